#include "host/settings/settings_prusa.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/result.h"
#include "host/output/thumbnail_text.h"  // read_thumbnails
#include "host/part/pattern_words.h"     // kPatternWords
#include "host/settings/bed_setting.h"
#include "host/settings/prusa_texts.h"
#include "host/settings/settings_text.h"
#include "host/system/text.h"  // trimmed

namespace host {
namespace {

using Translated = std::vector<SettingText>;

enum class Kind {
  kNumber,       // unchanged; percentages (of another setting) have no counterpart
  kWidth,        // a number, but 0 means "automatic"
  kSpeed,        // likewise
  kSlowest,      // a speed, 0 for none
  kLimit,        // a number; 0 means none here, too
  kShare,        // with "%"
  kPercent,      // a whole number of percent, without "%"
  kLayersAfter,  // number of layers before the first one with the effect
  kBridgeSpeed,  // of bridges, and of perimeters whose centre line is in the air
  kBridgeFlow,   // of both kinds of bridges
  kBridgeFan,    // as kBridgeSpeed, in percent
  kGcode,
  kBed,
  kCooling,
  kAllContours,   // the same for outer contours and holes
  kBrim,          // which contours have one
  kSupports,      // whether there are any
  kThreshold,     // an angle from the horizontal; 0 is automatic
  kShareOfWidth,  // a number, or a share of a road's width (prusa_supports.h)
  kNotNegative,   // a number; a negative one means as for another setting
  kPattern,       // of the inside; one that has no counterpart is left out
  kTopPattern,
  kSeam,
  kFuzzySkin,
  kFlavor,
  kThumbnails,  // sizes, each with a format; those of formats that are not written are left out
  kThumbnailFormat,
  kName,       // text, perhaps in quotes; one that can't stand in a file is left empty
  kFirstName,  // the first of several, with semicolons between them
};

struct Alias {
  std::string_view theirs;
  std::string_view ours;
  Kind kind = Kind::kNumber;
};

constexpr std::array kAliases = {
    Alias{"layer_height", "layer_height"},
    Alias{"min_layer_height", "layer_height_min", Kind::kWidth},
    Alias{"max_layer_height", "layer_height_max", Kind::kLimit},
    Alias{"nozzle_diameter", "nozzle_diameter"},
    Alias{"filament_diameter", "filament_diameter"},
    Alias{"filament_type", "filament_type"},
    Alias{"filament_settings_id", "filament_name", Kind::kFirstName},
    Alias{"filament_colour", "filament_colour", Kind::kFirstName},
    Alias{"printer_settings_id", "printer_name", Kind::kName},
    Alias{"printer_vendor", "printer_vendor", Kind::kName},
    Alias{"printer_model", "printer_model", Kind::kName},
    Alias{"printer_variant", "printer_variant", Kind::kName},
    Alias{"remaining_times", "progress_commands"},
    Alias{"filament_density", "filament_density_g_cm3"},
    Alias{"filament_cost", "filament_cost_kg"},
    Alias{"extrusion_width", "road_width", Kind::kWidth},
    Alias{"extrusion_multiplier", "extrusion_multiplier"},
    Alias{"perimeters", "perimeters"},
    Alias{"external_perimeters_first", "outer_perimeter_first"},
    Alias{"bridge_speed", "bridge_speed_mm_s", Kind::kBridgeSpeed},
    Alias{"bridge_flow_ratio", "bridge_flow", Kind::kBridgeFlow},
    Alias{"bridge_fan_speed", "bridge_fan_share", Kind::kBridgeFan},
    Alias{"small_perimeter_speed", "small_perimeter_speed_mm_s", Kind::kSpeed},
    Alias{"max_volumetric_speed", "volumetric_speed_max_mm3_s", Kind::kLimit},
    Alias{"filament_max_volumetric_speed", "volumetric_speed_max_mm3_s", Kind::kLimit},
    Alias{"fill_density", "loose_density", Kind::kShare},
    Alias{"fill_angle", "fill_angle_degrees"},
    Alias{"fill_pattern", "loose_pattern", Kind::kPattern},
    Alias{"infill_every_layers", "loose_every_layers"},
    Alias{"spiral_vase", "spiral_vase"},
    Alias{"fuzzy_skin", "fuzzy_skin", Kind::kFuzzySkin},
    Alias{"fuzzy_skin_thickness", "fuzzy_skin_thickness"},
    Alias{"fuzzy_skin_point_dist", "fuzzy_skin_point_distance"},
    Alias{"top_fill_pattern", "top_pattern", Kind::kTopPattern},
    Alias{"top_infill_extrusion_width", "top_width", Kind::kWidth},
    Alias{"top_solid_infill_speed", "top_speed_mm_s", Kind::kSpeed},
    Alias{"ironing", "ironing"},
    Alias{"ironing_flowrate", "ironing_flow", Kind::kShare},
    Alias{"ironing_spacing", "ironing_spacing"},
    Alias{"ironing_speed", "ironing_speed_mm_s", Kind::kSpeed},
    Alias{"gcode_resolution", "segment_tolerance"},
    Alias{"infill_anchor_max", "infill_anchor_max"},
    Alias{"first_layer_height", "first_layer_height"},
    Alias{"first_layer_extrusion_width", "first_layer_width", Kind::kWidth},
    Alias{"elefant_foot_compensation", "elephant_foot_compensation"},
    Alias{"xy_size_compensation", "contour_compensation", Kind::kAllContours},
    Alias{"filament_shrinkage_compensation_xy", "shrinkage_xy", Kind::kShare},
    Alias{"filament_shrinkage_compensation_z", "shrinkage_z", Kind::kShare},
    Alias{"brim_width", "brim_width"},
    Alias{"brim_separation", "brim_gap"},
    Alias{"brim_type", "brim_place", Kind::kBrim},
    Alias{"raft_layers", "raft_layers"},
    Alias{"raft_expansion", "raft_expansion"},
    Alias{"raft_contact_distance", "raft_contact_distance"},
    Alias{"raft_first_layer_density", "raft_first_layer_density", Kind::kShare},
    Alias{"support_material", "supports", Kind::kSupports},
    Alias{"support_material_auto", "support_auto"},
    Alias{"support_material_threshold", "overhang_angle_degrees", Kind::kThreshold},
    Alias{"support_material_xy_spacing", "support_xy_distance", Kind::kShareOfWidth},
    Alias{"support_material_spacing", "support_spacing"},
    Alias{"support_material_interface_spacing", "support_interface_spacing"},
    Alias{"support_material_interface_layers", "support_interface_layers"},
    Alias{"support_material_bottom_interface_layers", "support_bottom_interface_layers",
          Kind::kNotNegative},
    Alias{"support_material_angle", "support_angle_degrees"},
    Alias{"support_material_extrusion_width", "support_width", Kind::kWidth},
    Alias{"support_material_speed", "support_speed_mm_s", Kind::kSpeed},
    Alias{"support_material_interface_speed", "support_interface_speed_mm_s", Kind::kSpeed},
    Alias{"support_tree_angle", "support_branch_angle_degrees"},
    Alias{"support_tree_branch_diameter", "support_branch_diameter"},
    Alias{"support_tree_branch_diameter_angle", "support_branch_diameter_angle_degrees"},
    Alias{"support_tree_tip_diameter", "support_tip_diameter"},
    Alias{"complete_objects", "sequential"},
    Alias{"extruder_clearance_radius", "clearance_radius"},
    Alias{"extruder_clearance_height", "clearance_height"},
    Alias{"min_skirt_length", "skirt_length_min"},
    Alias{"seam_position", "seam", Kind::kSeam},
    Alias{"skirts", "skirt_loops"},
    Alias{"skirt_distance", "skirt_distance"},
    Alias{"perimeter_speed", "perimeter_speed_mm_s", Kind::kSpeed},
    Alias{"external_perimeter_speed", "outer_perimeter_speed_mm_s", Kind::kSpeed},
    Alias{"solid_infill_speed", "solid_speed_mm_s", Kind::kSpeed},
    Alias{"infill_speed", "loose_speed_mm_s", Kind::kSpeed},
    Alias{"gap_fill_speed", "rest_speed_mm_s", Kind::kSpeed},
    Alias{"first_layer_speed", "first_layer_speed_mm_s", Kind::kSpeed},
    Alias{"default_acceleration", "default_acceleration_mm_s2", Kind::kLimit},
    Alias{"perimeter_acceleration", "perimeter_acceleration_mm_s2", Kind::kLimit},
    Alias{"external_perimeter_acceleration", "outer_perimeter_acceleration_mm_s2", Kind::kLimit},
    Alias{"infill_acceleration", "loose_acceleration_mm_s2", Kind::kLimit},
    Alias{"solid_infill_acceleration", "solid_acceleration_mm_s2", Kind::kLimit},
    Alias{"top_solid_infill_acceleration", "top_acceleration_mm_s2", Kind::kLimit},
    Alias{"bridge_acceleration", "bridge_acceleration_mm_s2", Kind::kLimit},
    Alias{"first_layer_acceleration", "first_layer_acceleration_mm_s2", Kind::kLimit},
    Alias{"travel_acceleration", "travel_acceleration_mm_s2", Kind::kLimit},
    Alias{"machine_max_acceleration_extruding", "acceleration_mm_s2", Kind::kSpeed},
    Alias{"machine_max_acceleration_retracting", "filament_acceleration_mm_s2", Kind::kSpeed},
    Alias{"machine_max_acceleration_x", "acceleration_max_xy_mm_s2", Kind::kLimit},
    Alias{"machine_max_acceleration_z", "acceleration_max_z_mm_s2", Kind::kLimit},
    Alias{"machine_max_acceleration_e", "acceleration_max_filament_mm_s2", Kind::kLimit},
    Alias{"machine_max_feedrate_x", "speed_max_xy_mm_s", Kind::kLimit},
    Alias{"machine_max_feedrate_z", "speed_max_z_mm_s", Kind::kLimit},
    Alias{"machine_max_feedrate_e", "speed_max_filament_mm_s", Kind::kLimit},
    Alias{"machine_max_jerk_x", "jerk_xy_mm_s", Kind::kLimit},
    Alias{"machine_max_jerk_z", "jerk_z_mm_s", Kind::kLimit},
    Alias{"machine_max_jerk_e", "jerk_filament_mm_s", Kind::kLimit},
    Alias{"gcode_flavor", "gcode_flavor", Kind::kFlavor},
    Alias{"thumbnails", "thumbnails", Kind::kThumbnails},
    Alias{"thumbnails_format", "thumbnails_format", Kind::kThumbnailFormat},
    Alias{"travel_speed", "travel_speed_mm_s", Kind::kSpeed},
    Alias{"slowdown_below_layer_time", "layer_time_min_s"},
    Alias{"min_print_speed", "slowed_speed_min_mm_s", Kind::kSlowest},
    Alias{"retract_length", "retraction_mm"},
    Alias{"retract_speed", "retraction_speed_mm_s"},
    Alias{"retract_before_travel", "retraction_travel_min"},
    Alias{"retract_lift", "retraction_lift"},
    Alias{"only_retract_when_crossing_perimeters", "only_retract_when_crossing_perimeters"},
    Alias{"wipe", "wipe"},
    Alias{"retract_before_wipe", "retraction_before_wipe", Kind::kShare},
    Alias{"avoid_crossing_perimeters", "avoid_crossing_perimeters"},
    Alias{"avoid_crossing_perimeters_max_detour", "avoid_crossing_max_detour", Kind::kLimit},
    Alias{"bed_shape", "bed_shape", Kind::kBed},
    Alias{"max_print_height", "axis_z", Kind::kLimit},
    Alias{"temperature", "nozzle_celsius"},
    Alias{"first_layer_temperature", "nozzle_first_layer_celsius"},
    Alias{"bed_temperature", "bed_celsius"},
    Alias{"first_layer_bed_temperature", "bed_first_layer_celsius"},
    Alias{"cooling", "cool_short_layers", Kind::kCooling},
    Alias{"fan_always_on", "fan_always_on"},
    Alias{"min_fan_speed", "fan_share_min", Kind::kPercent},
    Alias{"max_fan_speed", "fan_share", Kind::kPercent},
    Alias{"fan_below_layer_time", "fan_below_layer_time_s"},
    Alias{"full_fan_speed_layer", "fan_full_layer"},
    Alias{"disable_fan_first_layers", "fan_from_layer", Kind::kLayersAfter},
    Alias{"start_gcode", "start_gcode", Kind::kGcode},
    Alias{"end_gcode", "end_gcode", Kind::kGcode},
    Alias{"pause_print_gcode", "pause_gcode", Kind::kGcode},
};

// Of its keys, rind has raft_layers alone.
constexpr std::array<std::string_view, 14> kHallmarks = {"top_solid_layers",
                                                         "bottom_solid_layers",
                                                         "support_material",
                                                         "brim_separation",
                                                         "raft_layers",
                                                         "fill_density",
                                                         "fill_pattern",
                                                         "infill_extrusion_width",
                                                         "perimeter_extrusion_width",
                                                         "first_layer_extrusion_width",
                                                         "cooling",
                                                         "solid_infill_below_area",
                                                         "solid_infill_every_layers",
                                                         "external_perimeter_extrusion_width"};

// The lowest speed that a setting can have.
constexpr const char* kSlowestSpeed = "0.1";

// Empty if it can't be read.
Translated bed_settings(std::string_view outline) {
  const core::Result<BedCorners> corners = read_bed_shape(outline);
  if (!corners.ok() || corners.value().empty()) return {};
  return {{"bed_shape", std::string(outline)}};
}

Translated brim_settings(std::string_view type) {
  if (type == "outer_only") return {{"brim_place", "outer"}};
  if (type == "inner_only") return {{"brim_place", "inner"}};
  if (type == "outer_and_inner") return {{"brim_place", "both"}};
  // No brim at all: settings_file.cpp sees to that.
  return {{"brim_place", "outer"}};
}

struct WordPair {
  std::string_view theirs;
  std::string_view ours;
};

constexpr std::array kTopPatterns = {
    WordPair{"rectilinear", "rectilinear"}, WordPair{"alignedrectilinear", "rectilinear"},
    WordPair{"monotonic", "monotonic"},     WordPair{"monotoniclines", "monotonic"},
    WordPair{"concentric", "concentric"},
};

constexpr std::array kSeams = {
    WordPair{"aligned", "aligned"},
    WordPair{"nearest", "nearest"},
    WordPair{"rear", "rear"},
    WordPair{"random", "random"},
};

constexpr std::array kFuzzySkins = {
    WordPair{"none", "none"},
    WordPair{"external", "external"},
    WordPair{"all", "all"},
};

constexpr std::array kFlavors = {
    WordPair{"marlin", "marlin"},   WordPair{"marlin2", "marlin"},
    WordPair{"klipper", "klipper"}, WordPair{"reprap", "marlin"},
    WordPair{"repetier", "marlin"}, WordPair{"teacup", "marlin"},
    WordPair{"smoothie", "marlin"}, WordPair{"reprapfirmware", "reprapfirmware"},
};

constexpr std::array kThumbnailFormats = {WordPair{"PNG", "PNG"}, WordPair{"QOI", "QOI"}};

// None of them is no error: the file has no picture then.
Translated thumbnail_settings(std::string_view list) {
  std::string known;
  std::size_t count = 0;
  while (!list.empty() && count < kThumbnailsMax) {
    const std::size_t comma = list.find(',');
    const std::string one(trimmed(list.substr(0, comma)));
    const auto read = read_thumbnails(one, ThumbnailFormat::kPng);
    if (read.ok() && !read.value().empty()) {
      known += (known.empty() ? "" : ", ") + one;
      ++count;
    }
    list = comma == std::string_view::npos ? std::string_view() : list.substr(comma + 1);
  }
  return {{"thumbnails", known}};
}

template <typename Names>
Translated translate_word(const Names& names, std::string_view ours, std::string_view theirs) {
  for (const auto& name : names) {
    if (name.theirs == theirs) return {{std::string(ours), std::string(name.ours)}};
  }
  return {};
}

Translated translate(const Alias& alias, std::string_view text) {
  const std::string ours(alias.ours);
  if (alias.kind == Kind::kBed) return bed_settings(text);
  if (alias.kind == Kind::kGcode) return {{ours, std::string(text)}};
  if (alias.kind == Kind::kName) return {{ours, prusa_name_text(text)}};
  if (alias.kind == Kind::kFirstName) return {{ours, first_prusa_name(text)}};
  if (alias.kind == Kind::kThumbnails) return thumbnail_settings(text);
  const std::string_view first = trimmed(text.substr(0, text.find(',')));
  if (alias.kind == Kind::kThumbnailFormat) return translate_word(kThumbnailFormats, ours, first);
  if (alias.kind == Kind::kPattern) return translate_word(kPatternWords, ours, first);
  if (alias.kind == Kind::kTopPattern) return translate_word(kTopPatterns, ours, first);
  if (alias.kind == Kind::kSeam) return translate_word(kSeams, ours, first);
  if (alias.kind == Kind::kFuzzySkin) return translate_word(kFuzzySkins, ours, first);
  if (alias.kind == Kind::kFlavor) return translate_word(kFlavors, ours, first);
  if (alias.kind == Kind::kShare) return {{ours, std::string(first)}};
  if (alias.kind == Kind::kBrim) return brim_settings(first);
  if (alias.kind == Kind::kShareOfWidth && first.ends_with('%')) return {{ours, "0"}};
  if (first.ends_with('%')) return {};
  const core::Result<double> number = read_number(first, "");
  // Text that is no number is passed on: the setting reports the error.
  if (!number.ok()) return {{ours, std::string(first)}};
  switch (alias.kind) {
    case Kind::kWidth:
    case Kind::kSpeed:
      if (number.value() == 0) return {};
      break;
    case Kind::kSlowest:
      if (number.value() == 0) return {{ours, kSlowestSpeed}};
      break;
    case Kind::kCooling:
      // If 0, PrusaSlicer's fan is off unless fan_always_on is set.
      if (number.value() == 0) return {{ours, "0"}, {"fan_always_on", "0"}};
      break;
    case Kind::kBridgeSpeed: {
      if (number.value() == 0) return {};
      const std::string speed(first);
      return {{ours, speed},
              {"internal_bridge_speed_mm_s", speed},
              {"overhang_speed_mm_s", fmt::format("0,0,{0},{0}", speed)}};
    }
    case Kind::kBridgeFlow:
      return {{ours, std::string(first)}, {"internal_bridge_flow", std::string(first)}};
    case Kind::kBridgeFan: {
      if (number.value() < 0) return {};
      const std::string share = write_number(number.value() / 100);
      return {{ours, share}, {"overhang_fan_share", fmt::format("0,0,{0},{0}", share)}};
    }
    case Kind::kPercent:
      return {{ours, write_number(number.value() / 100)}};
    case Kind::kSupports:
      return {{ours, number.value() == 0 ? "off" : "everywhere"}};
    case Kind::kThreshold:
      if (number.value() == 0) return {};
      return {{ours, write_number(90 - number.value())}};
    case Kind::kNotNegative:
      if (number.value() < 0) return {};
      break;
    case Kind::kAllContours:
      return {{ours, std::string(first)}, {"hole_compensation", std::string(first)}};
    case Kind::kLayersAfter:
      return {{ours, write_number(number.value() + 1)}};
    default:
      break;
  }
  return {{ours, std::string(first)}};
}

}  // namespace

std::optional<Translated> from_prusa(std::string_view key, std::string_view text) {
  for (const Alias& alias : kAliases) {
    if (alias.theirs == key) return translate(alias, trimmed(text));
  }
  return std::nullopt;
}

std::vector<std::string_view> prusa_keys() {
  std::vector<std::string_view> keys;
  keys.reserve(kAliases.size());
  for (const Alias& alias : kAliases) keys.push_back(alias.theirs);
  return keys;
}

std::optional<std::string_view> ours_for(std::string_view key) {
  for (const Alias& alias : kAliases) {
    const bool as_it_is = alias.kind == Kind::kNumber || alias.kind == Kind::kLimit;
    if (alias.theirs == key && as_it_is) return alias.ours;
  }
  return std::nullopt;
}

std::vector<SettingText> prusa_cooling() {
  return {{"cool_short_layers", "1"}, {"fan_always_on", "0"},           {"fan_share_min", "0.35"},
          {"fan_share", "1"},         {"fan_below_layer_time_s", "60"}, {"fan_from_layer", "4"},
          {"fan_full_layer", "0"},    {"layer_time_min_s", "5"}};
}

bool is_prusa_cooling(std::string_view key) {
  constexpr std::array<std::string_view, 6> kKeys = {
      "cooling",       "fan_always_on",        "min_fan_speed",
      "max_fan_speed", "fan_below_layer_time", "disable_fan_first_layers"};
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

bool is_prusa_hallmark(std::string_view key) {
  return std::find(kHallmarks.begin(), kHallmarks.end(), key) != kHallmarks.end();
}

}  // namespace host
