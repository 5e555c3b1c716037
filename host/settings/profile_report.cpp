#include "host/settings/profile_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/settings/foreign_names.h"   // prusa_name
#include "host/settings/prusa_left_out.h"  // left_out_rows, is_left_out, shortened_value

namespace host {
namespace {

// Read by prusa_supports.cpp and settings_file.cpp where all values are known.
constexpr std::array<std::string_view, 15> kTakenTogether = {
    "machine_max_acceleration_y",
    "machine_max_feedrate_y",
    "machine_max_jerk_y",
    "machine_width",
    "machine_depth",
    "machine_center_is_zero",
    "machine_shape",
    "adhesion_type",
    "support_structure",
    "support_type",
    "support_material_buildplate_only",
    "support_material_style",
    "support_material_contact_distance",
    "support_material_bottom_contact_distance",
    "gcode_flavor"};

// Names, notes and colours; what several tools, wipe towers, several parts, plates and the network
// are about; how files are written.
constexpr std::array<std::string_view, 56> kNoMeaning = {"bed_custom_model",
                                                         "bed_custom_texture",
                                                         "bed_model",
                                                         "bed_texture",
                                                         "clip_multipart_objects",
                                                         "colorprint_heights",
                                                         "duplicate_distance",
                                                         "extruder_colour",
                                                         "extruder_offset",
                                                         "extrusion_axis",
                                                         "family",
                                                         "filament_cost",
                                                         "filament_density",
                                                         "filament_minimal_purge_on_wipe_tower",
                                                         "filament_notes",
                                                         "filament_ramming_parameters",
                                                         "filament_soluble",
                                                         "filament_spool_weight",
                                                         "filament_toolchange_delay",
                                                         "filament_type",
                                                         "filament_vendor",
                                                         "from",
                                                         "gcode_comments",
                                                         "gcode_label_objects",
                                                         "gcode_substitutions",
                                                         "high_current_on_filament_swap",
                                                         "host_type",
                                                         "infill_extruder",
                                                         "instantiation",
                                                         "interface_shells",
                                                         "machine_limits_usage",
                                                         "name",
                                                         "notes",
                                                         "ooze_prevention",
                                                         "output_filename_format",
                                                         "parking_pos_retraction",
                                                         "perimeter_extruder",
                                                         "print_settings_id",
                                                         "printer_notes",
                                                         "printer_technology",
                                                         "renamed_from",
                                                         "setting_id",
                                                         "silent_mode",
                                                         "solid_infill_extruder",
                                                         "standby_temperature_delta",
                                                         "support_material_extruder",
                                                         "support_material_interface_extruder",
                                                         "template_custom_gcode",
                                                         "threads",
                                                         "toolchange_gcode",
                                                         "type",
                                                         "use_relative_e_distances",
                                                         "variable_layer_height",
                                                         "version",
                                                         "retract_restart_extra_toolchange",
                                                         "retract_length_toolchange"};

constexpr std::array<std::string_view, 19> kNoMeaningStarts = {
    "compatible_print",  "cooling_tube_",    "default_",
    "extra_loading_",    "filament_load",    "filament_unload",
    "filament_cooling_", "inherits",         "mmu_",
    "octoprint_",        "physical_printer", "print_host",
    "printhost_",        "serial_",          "single_extruder_multi_material",
    "thumbnails",        "wipe_into_",       "wipe_tower",
    "wiping_volumes_"};

bool is_without_meaning(std::string_view key, std::string_view value) {
  const std::string_view first = first_value(value);
  if (first.empty() || first == "nil") return true;
  if (std::find(kNoMeaning.begin(), kNoMeaning.end(), key) != kNoMeaning.end()) return true;
  return std::any_of(kNoMeaningStarts.begin(), kNoMeaningStarts.end(),
                     [key](std::string_view start) { return key.starts_with(start); });
}

ProfileGroup group_of(std::string_view key, std::string_view value) {
  if (std::find(kTakenTogether.begin(), kTakenTogether.end(), key) != kTakenTogether.end()) {
    return ProfileGroup::kTaken;
  }
  // A setting whose lack would be told, at a value that lacks nothing.
  if (is_left_out(key) || is_without_meaning(key, value)) return ProfileGroup::kNoMeaning;
  return ProfileGroup::kNotSupported;
}

std::vector<ProfileRow> rows_in(const std::vector<ProfileRow>& rows, ProfileGroup group) {
  std::vector<ProfileRow> some;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(some),
               [group](const ProfileRow& row) { return row.group == group; });
  return some;
}

}  // namespace

std::vector<ProfileRow> report_of(const LoadedSettings& loaded) {
  std::vector<ProfileRow> rows = loaded.rows;
  const auto find = [&rows](std::string_view key) {
    return std::find_if(rows.begin(), rows.end(),
                        [key](const ProfileRow& row) { return prusa_name(row.key) == key; });
  };
  for (const LeftOutRow& row : left_out_rows(loaded.values)) {
    const auto theirs =
        std::find_if(loaded.ignored.begin(), loaded.ignored.end(),
                     [&row](const std::string& key) { return prusa_name(key) == row.key; });
    const auto same = find(row.key);
    if (same != rows.end()) {
      same->group = ProfileGroup::kChanges;
      same->what = row.instead;
      continue;
    }
    rows.push_back({ProfileGroup::kChanges,
                    theirs == loaded.ignored.end() ? std::string(row.key) : *theirs, row.value,
                    std::string(row.instead)});
  }
  for (const std::string& key : loaded.ignored) {
    const auto value = loaded.values.find(key);
    if (value == loaded.values.end() || find(prusa_name(key)) != rows.end()) continue;
    rows.push_back({group_of(key, value->second), key, value->second, ""});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const ProfileRow& a, const ProfileRow& b) { return a.group < b.group; });
  return rows;
}

std::string_view group_name(ProfileGroup group) {
  switch (group) {
    case ProfileGroup::kTaken:
      return "taken";
    case ProfileGroup::kChanges:
      return "changes the print";
    case ProfileGroup::kNotSupported:
      return "not supported";
    case ProfileGroup::kNoMeaning:
      break;
  }
  return "of no meaning here";
}

std::string counts_of(const std::vector<ProfileRow>& rows) {
  const auto count = [&rows](ProfileGroup group) { return rows_in(rows, group).size(); };
  return fmt::format(
      "{} are taken, {} would change the print, {} are not supported, {} have no meaning here",
      count(ProfileGroup::kTaken), count(ProfileGroup::kChanges),
      count(ProfileGroup::kNotSupported), count(ProfileGroup::kNoMeaning));
}

std::string text_of(const std::vector<ProfileRow>& rows) {
  std::string text;
  for (const ProfileGroup group : kProfileGroups) {
    const std::vector<ProfileRow> some = rows_in(rows, group);
    text += fmt::format("#\n# {}: {}\n", group_name(group), some.size());
    for (const ProfileRow& row : some) {
      const char* between = row.group == ProfileGroup::kTaken ? "  ->  " : ": ";
      text += fmt::format("#   {} = {}{}{}\n", row.key, shortened_value(row.value),
                          row.what.empty() ? "" : between, row.what);
    }
  }
  return text;
}

}  // namespace host
