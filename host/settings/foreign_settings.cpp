#include "host/settings/foreign_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "host/settings/bed_setting.h"
#include "host/settings/foreign_names.h"
#include "host/settings/own_accelerations.h"
#include "host/settings/prusa_shares.h"
#include "host/settings/prusa_supports.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_table.h"
#include "host/settings/settings_text.h"
#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

// Notes a value without a counterpart, and what holds instead.
void leave_out(const ProfileLine& line, LoadedSettings& loaded) {
  loaded.ignored.push_back(fmt::format("{} = {}", line.key, line.value));
  if (prusa_name(line.key) == "bed_shape") {
    const Result<BedCorners> corners = read_bed_shape(line.value);
    loaded.unreadable.push_back(
        {fmt::format("{}: bed_shape: {}; set bed_shape, or bed_x and bed_y", line.place,
                     corners.ok() ? "a corner is missing" : corners.error().message),
         {"bed_x", "bed_y"}});
    return;
  }
  constexpr const char* kOwn = "rind's own value is used";
  loaded.left_out.push_back(fmt::format("{} = {}: {}", line.key, line.value, kOwn));
  loaded.rows.push_back({ProfileGroup::kChanges, line.key, line.value, kOwn});
}

// An expression in a setting that rind has changes the print; another one is of no concern.
void leave_out_expression(const ProfileLine& line, LoadedSettings& loaded) {
  loaded.values.insert_or_assign(line.key, line.value);
  const std::string key(prusa_name(line.key));
  if (!is_gcode_setting(key) && !from_prusa(key, "1").has_value()) {
    loaded.ignored.push_back(line.key);
    return;
  }
  constexpr const char* kInstead = "an expression that is not understood: rind's own value is used";
  loaded.left_out.push_back(fmt::format("{} = {}: {}", line.key, line.value, kInstead));
  loaded.rows.push_back({ProfileGroup::kChanges, line.key, line.value, kInstead});
}

// The line in PrusaSlicer's words.
ProfileLine in_prusas_words(const ProfileLine& line) {
  return {line.place, line.section, std::string(prusa_name(line.key)),
          prusa_value(line.key, line.value)};
}

// Of several lines with one key, the last one.
std::vector<ProfileLine> last_of_each(std::vector<ProfileLine> lines) {
  std::map<std::string, std::size_t> last;
  for (std::size_t i = 0; i < lines.size(); ++i) last[lines[i].key] = i;
  std::vector<ProfileLine> kept;
  kept.reserve(last.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (last[lines[i].key] == i) kept.push_back(std::move(lines[i]));
  }
  return kept;
}

Status apply_line(const ProfileLine& line, const ProfileLine& theirs, GcodeOrigin origin,
                  LoadedSettings& loaded) {
  if (is_gcode_setting(line.key)) {
    loaded.gcode.push_back({line.key, line.place, line.value, origin});
    loaded.rows.push_back({ProfileGroup::kTaken, theirs.key, theirs.value, line.key});
    ++loaded.set_count;
    return {};
  }
  if (trimmed(line.value).empty() && line.key != "bed_shape") {
    loaded.ignored.push_back(theirs.key);
    return {};
  }
  const std::optional<std::vector<SettingText>> ours = from_prusa(line.key, line.value);
  if (!ours.has_value()) {
    loaded.ignored.push_back(theirs.key);
    return {};
  }
  if (ours->empty()) {
    leave_out({line.place, line.section, theirs.key, theirs.value}, loaded);
    return {};
  }
  ++loaded.set_count;
  std::string taken;
  for (const SettingText& setting : *ours) {
    Status status = set_setting(loaded.settings, setting.key, setting.text);
    if (!status.ok()) return error_at(line, status.error().message);
    taken += fmt::format("{}{} = {}", taken.empty() ? "" : ", ", setting.key, setting.text);
  }
  loaded.rows.push_back({ProfileGroup::kTaken, theirs.key, theirs.value, taken});
  return {};
}

// Adds PrusaSlicer's defaults for missing keys, and moves `cooling` before the keys that need it.
core::Status start_prusa(std::vector<ProfileLine>& lines, LoadedSettings& loaded) {
  const auto cools = [](const ProfileLine& line) { return is_prusa_cooling(line.key); };
  if (std::none_of(lines.begin(), lines.end(), cools)) return {};
  std::stable_partition(lines.begin(), lines.end(),
                        [](const ProfileLine& line) { return line.key == "cooling"; });
  for (const SettingText& setting : prusa_cooling()) {
    core::Status status = set_setting(loaded.settings, setting.key, setting.text);
    if (!status.ok()) return status;
  }
  return {};
}

// A filament may have retractions of its own.
Status take_filament_overrides(LoadedSettings& loaded) {
  constexpr const char* kOverridden[] = {"retract_length",      "retract_speed",
                                         "retract_lift",        "retract_before_travel",
                                         "retract_before_wipe", "wipe"};
  for (const char* key : kOverridden) {
    const std::string theirs = fmt::format("filament_{}", key);
    const auto said = loaded.values.find(theirs);
    if (said == loaded.values.end() || first_value(said->second) == "nil") continue;
    const auto ours = from_prusa(key, first_value(said->second));
    for (const SettingText& setting : ours.value_or(std::vector<SettingText>())) {
      Status status = set_setting(loaded.settings, setting.key, setting.text);
      if (!status.ok()) return status;
      loaded.rows.push_back({ProfileGroup::kTaken, theirs, said->second,
                             fmt::format("{} = {}", setting.key, setting.text)});
      std::erase(loaded.ignored, theirs);
    }
  }
  return {};
}

// A profile of another printer, or of another filament, has other names than a preset's.
void forget_names(LoadedSettings& loaded) {
  const auto says = [&loaded](std::string_view key) {
    return loaded.values.find(key) != loaded.values.end();
  };
  PrintSettings& settings = loaded.settings;
  if (says("bed_shape")) {
    for (std::string* name : {&settings.printer_name, &settings.printer_vendor,
                              &settings.printer_model, &settings.printer_variant}) {
      name->clear();
    }
  }
  if (says("machine_max_acceleration_x") || says("machine_max_feedrate_x")) {
    settings.limits_assumed.clear();
  }
  if (says("filament_type") || says("filament_diameter") || says("temperature")) {
    settings.filament_name.clear();
    settings.filament_colour.clear();
  }
}

// Checks that need the whole file.
core::Status end_prusa(const std::string& name, LoadedSettings& loaded) {
  const std::vector<std::string> more = left_out_of(loaded.values);
  loaded.left_out.insert(loaded.left_out.end(), more.begin(), more.end());
  const auto value = [&](std::string_view key) -> std::string_view {
    const auto found = loaded.values.find(key);
    return found == loaded.values.end() ? std::string_view() : std::string_view(found->second);
  };
  if (value("printer_technology") == "SLA") {
    return Error{ErrorCode::kBadSetting,
                 name + ": is a profile of a printer that hardens resin; rind lays filament"};
  }
  if (value("nozzle_diameter").find(',') != std::string_view::npos) {
    loaded.left_out.push_back(
        fmt::format("nozzle_diameter = {}: one tool prints, with the first one's settings",
                    value("nozzle_diameter")));
  }
  // PrusaSlicer tells no acceleration at all without a default.
  if (loaded.settings.default_acceleration_mm_s2 == 0) {
    for (const auto& [key, own] : kOwnAccelerations) loaded.settings.*own = 0;
  }
  // An automatic width is 9/8 of the nozzle's, as there.
  const Result<double> width = read_number(absolute_value(loaded.values, "extrusion_width"), "");
  if (!width.ok() || width.value() == 0) {
    loaded.settings.road_width =
        core::Length::from_units(loaded.settings.nozzle_diameter.units() * 9 / 8);
  }
  const std::string_view brim = value("brim_type");
  if (brim == "no_brim" || brim == "auto_brim") loaded.settings.brim_width = core::Length();
  take_prusa_supports(loaded.values, loaded.settings);
  take_prusa_support_distances(
      loaded.values, [](const std::string&) { return false; }, loaded.settings);
  // The smaller of the print's and the filament's; 0 is none.
  double slowest = 0;
  for (const char* key : {"max_volumetric_speed", "filament_max_volumetric_speed"}) {
    const Result<double> limit = read_number(first_value(value(key)), "");
    if (!limit.ok() || limit.value() <= 0) continue;
    slowest = slowest > 0 ? std::min(slowest, limit.value()) : limit.value();
  }
  loaded.settings.volumetric_speed_max_mm3_s = slowest;
  if (loaded.settings.fan_share_min > loaded.settings.fan_share) {
    loaded.left_out.push_back(
        fmt::format("min_fan_speed = {}: the fan never runs faster than max_fan_speed",
                    value("min_fan_speed")));
  }
  return {};
}

}  // namespace

Status apply_foreign(ForeignProfile profile, const std::string& name, LoadedSettings& loaded) {
  loaded.from_prusa = true;
  loaded.program = profile.program;
  loaded.chosen = std::move(profile.notes);
  const bool translated = profile.program != "PrusaSlicer";
  std::vector<ProfileLine> theirs = last_of_each(std::move(profile.lines));
  if (Status started = start_prusa(theirs, loaded); !started.ok()) return started;
  for (const ProfileLine& line : theirs) {
    const ProfileLine ours = translated ? in_prusas_words(line) : line;
    loaded.values.insert_or_assign(line.key, line.value);
    loaded.values.insert_or_assign(ours.key, ours.value);
  }
  forget_names(loaded);
  for (const ProfileLine& line : theirs) {
    ProfileLine ours = translated ? in_prusas_words(line) : line;
    ours.value = absolute_value(loaded.values, ours.key);
    if (Status taken = apply_line(ours, line, profile.origin, loaded); !taken.ok()) return taken;
  }
  for (const ProfileLine& line : profile.unsolved) leave_out_expression(line, loaded);
  if (Status taken = take_filament_overrides(loaded); !taken.ok()) return taken;
  return end_prusa(name, loaded);
}

}  // namespace host
