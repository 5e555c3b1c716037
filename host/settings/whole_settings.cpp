#include "host/settings/whole_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>

#include "core/slices/height_ranges.h"  // first_layer_height
#include "host/settings/gcode_placeholders.h"
#include "host/settings/prusa_supports.h"
#include "host/settings/settings_file.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_table.h"
#include "host/settings/settings_text.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;
using Lines = std::vector<std::string>;

constexpr const char* kLax = "; --profile-lax leaves it out";

std::string with_underscores(std::string key) {
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

// Placeholders whose values are neither in the profile nor settings.
std::optional<std::string> known_besides(std::string_view name, std::size_t index,
                                         const PrintSettings& settings) {
  const double x = settings.bed_origin_x.mm(), y = settings.bed_origin_y.mm();
  const double width = settings.bed_x.mm(), depth = settings.bed_y.mm();
  const auto pair = [index](double first, double second) -> std::optional<std::string> {
    if (index > 1) return std::nullopt;
    return write_number(index == 0 ? first : second);
  };
  if (name == "print_bed_min") return pair(x, y);
  if (name == "print_bed_max") return pair(x + width, y + depth);
  if (name == "print_bed_size") return pair(width, depth);
  if (index > 0) return std::nullopt;
  if (name == "num_extruders" || name == "num_printing_extruders") return "1";
  constexpr std::array<std::string_view, 7> kNone = {"initial_tool",
                                                     "initial_extruder",
                                                     "current_extruder",
                                                     "total_toolchanges",
                                                     "current_object_idx",
                                                     "has_wipe_tower",
                                                     "has_single_extruder_multi_material_priming"};
  if (std::find(kNone.begin(), kNone.end(), name) != kNone.end()) return "0";
  return std::nullopt;
}

// The index-th of a profile's values, "215,210" or "PLA;PETG"; the first if there are fewer, as in
// PrusaSlicer.
std::optional<std::string> element(std::string_view list, std::size_t index) {
  const char between = list.find(';') != std::string_view::npos ? ';' : ',';
  std::string_view rest = list;
  for (; index > 0; --index) {
    const std::size_t end = rest.find(between);
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  const std::string_view one = first_value(index == 0 ? rest : list);
  if (one.find('\\') != std::string_view::npos) return std::nullopt;
  return std::string(one);
}

// Values of placeholders: from the settings, then from the profile, then others.
class Known {
 public:
  Known(const PrintSettings& settings, const ProfileValues& values)
      : settings_(settings), values_(values) {
    for (const SettingRow& row : describe_settings(settings)) rows_[row.key] = row.plain_value;
    // As they are used, where the settings say "auto".
    rows_["first_layer_height"] = write_number(core::first_layer_height(settings).mm());
    rows_["bed_first_layer_celsius"] = write_number(core::bed_first_layer_celsius(settings));
  }

  [[nodiscard]] std::optional<std::string> value(std::string_view name, std::size_t index) const {
    // G-code may hold placeholders itself.
    if (is_gcode_setting(name)) return std::nullopt;
    if (index == 0) {
      if (const auto row = rows_.find(ours_for(name).value_or(name)); row != rows_.end()) {
        return row->second;
      }
    }
    if (const auto said = values_.find(name); said != values_.end()) {
      return element(said->second, index);
    }
    return known_besides(name, index, settings_);
  }

 private:
  const PrintSettings& settings_;
  const ProfileValues& values_;
  ProfileValues rows_;
};

Lines& lines_of(PrintSettings& settings, std::string_view key) {
  if (key == "start_gcode") return settings.start_gcode;
  if (key == "at_height") return settings.at_height;
  return key == "pause_gcode" ? settings.pause_gcode : settings.end_gcode;
}

class Assembly {
 public:
  explicit Assembly(const SettingsRequest& request) : request_(request) {
    for (const auto& [key, value] : request.assignments) assigned_.insert(with_underscores(key));
  }

  Result<WholeSettings> assemble() {
    if (!request_.profile.empty()) {
      Result<LoadedSettings> loaded = load_settings(request_.profile, PrintSettings());
      if (!loaded.ok()) return loaded.error();
      loaded_ = std::move(loaded).value();
      whole_.settings = loaded_.settings;
    }
    for (const auto& [key, value] : request_.assignments) {
      if (Status set = set_setting(whole_.settings, key, value); !set.ok()) return set.error();
    }
    // By the print's own layers and roads, which may be others than the profile's.
    if (loaded_.from_prusa) {
      take_prusa_support_distances(
          loaded_.values, [this](const std::string& key) { return assigned(key); },
          whole_.settings);
    }
    for (const auto step : {&Assembly::take_unreadable, &Assembly::fill_gcode}) {
      if (Status done = (this->*step)(); !done.ok()) return done.error();
    }
    if (Status valid = validate_settings(whole_.settings); !valid.ok()) return valid.error();
    name_left_out();
    return std::move(whole_);
  }

 private:
  [[nodiscard]] bool assigned(const std::string& key) const { return assigned_.count(key) > 0; }

  Status take_unreadable() {
    for (const Unreadable& one : loaded_.unreadable) {
      if (std::all_of(one.keys.begin(), one.keys.end(),
                      [this](const std::string& key) { return assigned(key); })) {
        continue;
      }
      if (!request_.lax) return Error{ErrorCode::kBadSetting, one.what + kLax};
      std::string instead;
      for (const SettingText& setting : one.instead) {
        if (assigned(setting.key)) continue;
        Status set = set_setting(whole_.settings, setting.key, setting.text);
        if (!set.ok()) return set;
        instead += fmt::format("{}{} = {}", instead.empty() ? "" : ", ", setting.key, setting.text);
      }
      if (instead.empty()) instead = "rind's own is used";
      whole_.notes.push_back(fmt::format("{}; it is left out: {}", one.what, instead));
    }
    return {};
  }

  Status fill_gcode() {
    for (const RawGcode& raw : loaded_.gcode) {
      if (assigned(raw.key)) continue;
      Result<Lines> lines = read(raw);
      if (lines.ok()) {
        lines_of(whole_.settings, raw.key) = std::move(lines).value();
        continue;
      }
      const std::string what = fmt::format("{}: {}: {}", raw.place, raw.key, lines.error().message);
      if (!request_.lax) return Error{ErrorCode::kBadSetting, what + kLax};
      whole_.notes.push_back(fmt::format("{}; it is left out, and rind's own is sent ({})", what,
                                         write_lines(lines_of(whole_.settings, raw.key))));
    }
    const Known known(whole_.settings, loaded_.values);
    for (const char* key : {"start_gcode", "at_height", "pause_gcode", "end_gcode"}) {
      Lines& lines = lines_of(whole_.settings, key);
      Result<Lines> filled = fill_placeholders(lines, lookup(known), GcodeOrigin::kOwn);
      if (!filled.ok()) {
        return Error{ErrorCode::kBadSetting, fmt::format("{}: {}", key, filled.error().message)};
      }
      lines = std::move(filled).value();
    }
    return {};
  }

  [[nodiscard]] Result<Lines> read(const RawGcode& raw) const {
    const Known known(whole_.settings, loaded_.values);
    Result<Lines> filled =
        fill_placeholders(unescaped_lines(raw.text), lookup(known), GcodeOrigin::kProfile);
    if (!filled.ok()) return filled.error();
    return sendable_lines(filled.value());
  }

  [[nodiscard]] static PlaceholderValue lookup(const Known& known) {
    return [&known](std::string_view name, std::size_t index) { return known.value(name, index); };
  }

  void name_left_out() {
    whole_.notes.insert(whole_.notes.begin(), loaded_.left_out.begin(), loaded_.left_out.end());
    if (!loaded_.from_prusa) return;
    whole_.notes.insert(whole_.notes.begin(),
                        fmt::format("{}: {} settings taken, {} of no meaning here or as follows",
                                    request_.profile, loaded_.set_count, loaded_.ignored.size()));
  }

  const SettingsRequest& request_;
  std::set<std::string, std::less<>> assigned_;
  LoadedSettings loaded_;
  WholeSettings whole_;
};

}  // namespace

Result<WholeSettings> whole_settings(const SettingsRequest& request) {
  return Assembly(request).assemble();
}

}  // namespace host
