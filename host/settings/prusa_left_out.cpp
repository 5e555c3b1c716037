#include "host/settings/prusa_left_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "firmware_link/wire/gcode_words.h"  // commands_in
#include "host/settings/settings_text.h"     // read_number, unescaped_lines
#include "host/system/text.h"                // lower_case, trimmed

namespace host {
namespace {

// Which values mean that a setting is in use.
enum class When {
  kOn,        // a number or share that is not 0, a word that is neither "0" nor "none"
  kAboveOne,  // a number above 1
  kText,      // anything
  kGcode,     // a command that does something
  kUnlike,    // another value than that of `other`
  kUnlikeOn,  // likewise, except 0, which is automatic
  kWith,      // as kOn, where `other` is on, too
  kWord,      // the word `other`
  kNotSent,   // as kOn, where the G-code `other` does not heat the chamber
  kOffWith,   // 0, where `other` is on
};

struct LeftOut {
  std::string_view key;
  When when = When::kOn;
  std::string_view instead;
  std::string_view other = {};
};

constexpr std::string_view kOneWidth =
    "inner roads are as wide as extrusion_width, or as the wall needs";
constexpr std::string_view kNotSent = "it is not sent";

constexpr std::array kLeftOut = {
    LeftOut{"support_material_with_sheath", When::kOffWith, "supports have a sheath",
            "support_material"},
    LeftOut{"dont_support_bridges", When::kOffWith, "bridges up to bridge_max have no supports",
            "support_material"},
    LeftOut{"support_material_interface_contact_loops", When::kWith,
            "dense layers of supports are rows", "support_material"},
    LeftOut{"support_material_pattern", When::kWord, "supports are filled by rows", "honeycomb"},
    LeftOut{"support_material_pattern", When::kWord, "supports are filled by rows",
            "rectilinear-grid"},
    LeftOut{"support_material_interface_pattern", When::kWord, "dense layers of supports are rows",
            "concentric"},
    LeftOut{"support_material_enforce_layers", When::kOn,
            "no layer has supports that supports = off leaves out"},
    LeftOut{"raft_first_layer_expansion", When::kWith, "the raft is as wide in all its layers",
            "raft_layers"},
    LeftOut{"first_layer_speed_over_raft", When::kWith,
            "the part's first layer over the raft has first_layer_speed", "raft_layers"},
    LeftOut{"brim_type", When::kWord, "no brim is laid", "auto_brim"},
    LeftOut{"draft_shield", When::kOn, "no draft shield is laid"},
    LeftOut{"skirt_height", When::kAboveOne, "the skirt is one layer high"},
    LeftOut{"perimeter_extrusion_width", When::kUnlikeOn, kOneWidth, "extrusion_width"},
    LeftOut{"external_perimeter_extrusion_width", When::kUnlikeOn, kOneWidth, "extrusion_width"},
    LeftOut{"infill_extrusion_width", When::kUnlikeOn, kOneWidth, "extrusion_width"},
    LeftOut{"solid_infill_extrusion_width", When::kUnlikeOn, kOneWidth, "extrusion_width"},
    LeftOut{"top_solid_layers", When::kOn, "the top is as thick as wall_thickness"},
    LeftOut{"bottom_solid_layers", When::kOn, "the bottom is as thick as wall_thickness"},
    LeftOut{"bottom_fill_pattern", When::kUnlike, "bottoms are filled as tops", "top_fill_pattern"},
    LeftOut{"z_offset", When::kOn, "heights are as they are computed"},
    LeftOut{"thick_bridges", When::kOn, "bridges are as thick as bridge_flow_ratio says"},
    LeftOut{"bridge_angle", When::kOn, "the direction of bridges is found for each"},
    LeftOut{"enable_dynamic_overhang_speeds", When::kOn,
            "the speed of overhangs is that of overhang_speed_mm_s"},
    LeftOut{"enable_dynamic_fan_speeds", When::kOn,
            "overhangs are cooled as overhang_fan_share says"},
    LeftOut{"retract_restart_extra", When::kOn, "as much filament comes back as was drawn back"},
    LeftOut{"use_firmware_retraction", When::kOn, "rind draws filament back itself"},
    LeftOut{"use_volumetric_e", When::kOn, "filament is counted by its length"},
    LeftOut{"chamber_temperature", When::kNotSent, "the chamber is not heated", "start_gcode"},
    LeftOut{"start_filament_gcode", When::kGcode, kNotSent},
    LeftOut{"end_filament_gcode", When::kGcode, kNotSent},
    LeftOut{"before_layer_gcode", When::kGcode, kNotSent},
    LeftOut{"layer_gcode", When::kGcode, kNotSent},
    LeftOut{"post_process", When::kText, "no program in a profile is ever run"},
};

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool does_something(std::string_view gcode) {
  for (const std::string& line : unescaped_lines(gcode)) {
    const std::string text = firmware_link::without_comments(line);
    // rind starts every layer at filament 0 anyway.
    if (text.empty() || text == "\"" || text == "\"\"" || text.starts_with("G92 E0")) continue;
    return true;
  }
  return false;
}

// By a command, or by a macro that is given the value.
bool heats_chamber(std::string_view gcode) {
  const std::string text = lower_case(gcode);
  return std::ranges::any_of(std::array{"m141", "m191", "chamber"}, [&text](const char* word) {
    return text.find(word) != std::string::npos;
  });
}

bool same_number(std::string_view a, std::string_view b) {
  const core::Result<double> x = read_number(a, ""), y = read_number(b, "");
  return x.ok() && y.ok() ? x.value() == y.value() : a == b;
}

bool is_off(std::string_view first) {
  return first.empty() || is_one_of(first, {"none", "no", "disabled", "nil"}) ||
         same_number(first, "0") || first == "0%";
}

bool asks(const LeftOut& row, std::string_view value, const ProfileValues& profile) {
  const std::string_view first = first_value(value);
  const bool off = is_off(first);
  const auto other = profile.find(row.other);
  const bool unlike = other == profile.end() || !same_number(first, first_value(other->second));
  const core::Result<double> number = read_number(first, "");
  switch (row.when) {
    case When::kOn:
      return !off;
    case When::kAboveOne:
      return number.ok() && number.value() > 1;
    case When::kText:
      return !trimmed(value).empty() && value != "\"\"";
    case When::kGcode:
      return does_something(value);
    case When::kUnlike:
      // 100 % of the other is the same value.
      return unlike && first != "100%";
    case When::kUnlikeOn:
      return !off && unlike;
    case When::kNotSent:
      return !off && (other == profile.end() || !heats_chamber(other->second));
    case When::kOffWith:
      return off && other != profile.end() && !is_off(first_value(other->second));
    case When::kWord:
      return first == row.other;
    case When::kWith:
      return !off && other != profile.end() && !is_off(first_value(other->second));
  }
  return false;
}

}  // namespace

std::string shortened_value(std::string_view value) {
  constexpr std::size_t kShown = 40;
  std::string text(trimmed(value.substr(0, kShown)));
  return value.size() > kShown ? text + "…" : text;
}

std::string_view first_value(std::string_view text) {
  std::string_view first = trimmed(text.substr(0, text.find_first_of(",;")));
  if (first.size() >= 2 && first.front() == '"' && first.back() == '"') {
    first = trimmed(first.substr(1, first.size() - 2));
  }
  return first;
}

std::vector<LeftOutRow> left_out_rows(const ProfileValues& profile) {
  std::vector<LeftOutRow> rows;
  for (const LeftOut& row : kLeftOut) {
    const auto value = profile.find(row.key);
    if (value == profile.end() || !asks(row, value->second, profile)) continue;
    rows.push_back({row.key, value->second, row.instead});
  }
  return rows;
}

std::vector<std::string> left_out_of(const ProfileValues& profile) {
  std::vector<std::string> sentences;
  std::string keys;
  const std::vector<LeftOutRow> rows = left_out_rows(profile);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LeftOutRow& row = rows[i];
    keys += fmt::format("{}{} = {}", keys.empty() ? "" : ", ", row.key, shortened_value(row.value));
    // Settings with the same consequence share a message.
    if (i + 1 < rows.size() && rows[i + 1].instead == row.instead) continue;
    sentences.push_back(fmt::format("{}: {}", keys, row.instead));
    keys.clear();
  }
  return sentences;
}

bool is_left_out(std::string_view key) {
  return std::any_of(kLeftOut.begin(), kLeftOut.end(),
                     [&](const LeftOut& row) { return row.key == key; });
}

std::vector<std::string_view> left_out_keys() {
  std::vector<std::string_view> keys;
  keys.reserve(kLeftOut.size());
  for (const LeftOut& row : kLeftOut) keys.push_back(row.key);
  return keys;
}

}  // namespace host
