#include "host/settings/setting_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/settings/near_words.h"
#include "host/settings/prusa_left_out.h"
#include "host/settings/settings_prusa.h"
#include "host/settings/settings_rows.h"

namespace host {
namespace {

struct Synonym {
  std::string_view word;
  std::string_view key;
};

// Names in other programs and in everyday use.
constexpr std::array kSynonyms = {
    Synonym{"walls", "perimeters"},
    Synonym{"wall_loops", "perimeters"},
    Synonym{"wall_count", "perimeters"},
    Synonym{"wall_line_count", "perimeters"},
    Synonym{"shells", "perimeters"},
    Synonym{"infill", "loose_density"},
    Synonym{"infill_density", "loose_density"},
    Synonym{"sparse_infill_density", "loose_density"},
    Synonym{"density", "loose_density"},
    Synonym{"infill_angle", "fill_angle_degrees"},
    Synonym{"line_width", "road_width"},
    Synonym{"width", "road_width"},
    Synonym{"height", "layer_height"},
    Synonym{"quality", "layer_height"},
    Synonym{"nozzle", "nozzle_diameter"},
    Synonym{"nozzle_size", "nozzle_diameter"},
    Synonym{"brim", "brim_width"},
    Synonym{"raft", "raft_layers"},
    Synonym{"support", "supports"},
    Synonym{"support_enabled", "supports"},
    Synonym{"enable_support", "supports"},
    Synonym{"pressure_advance", "pressure_advance_s"},
    Synonym{"linear_advance", "pressure_advance_s"},
    Synonym{"max_volumetric_speed", "volumetric_speed_max_mm3_s"},
    Synonym{"max_flow", "volumetric_speed_max_mm3_s"},
    Synonym{"vase", "spiral_vase"},
    Synonym{"vase_mode", "spiral_vase"},
    Synonym{"spiral_mode", "spiral_vase"},
    Synonym{"spiralize", "spiral_vase"},
    Synonym{"magic_spiralize", "spiral_vase"},
    Synonym{"filament", "filament_diameter"},
    Synonym{"flow", "extrusion_multiplier"},
    Synonym{"flow_ratio", "extrusion_multiplier"},
    Synonym{"speed", "perimeter_speed_mm_s"},
    Synonym{"print_speed", "perimeter_speed_mm_s"},
    Synonym{"fan", "fan_share"},
    Synonym{"fan_speed", "fan_share"},
    Synonym{"nozzle_temperature", "nozzle_celsius"},
    Synonym{"hotend", "nozzle_celsius"},
    Synonym{"temp", "nozzle_celsius"},
    Synonym{"extruder_temp", "nozzle_celsius"},
    Synonym{"nozzle_temp", "nozzle_celsius"},
    Synonym{"bed_temp", "bed_celsius"},
    Synonym{"bed", "bed_x"},
    Synonym{"bed_width", "bed_x"},
    Synonym{"bed_depth", "bed_y"},
    Synonym{"bed_height", "axis_z"},
    Synonym{"z_hop", "retraction_lift"},
    Synonym{"retraction", "retraction_mm"},
    Synonym{"retract", "retraction_mm"},
    Synonym{"retraction_length", "retraction_mm"},
    Synonym{"retraction_distance", "retraction_mm"},
    Synonym{"speeds", "perimeter_speed_mm_s"},
    Synonym{"retraction_speed", "retraction_speed_mm_s"},
    Synonym{"skirt", "skirt_loops"},
    Synonym{"center", "centre"},
};

}  // namespace

std::string unknown_setting(std::string_view typed, std::string_view key) {
  constexpr const char* kAll = "rind settings lists them all";
  if (is_left_out(key)) {
    return fmt::format("\"{}\" is a setting of PrusaSlicer that rind does not have", typed);
  }
  const auto* synonym = std::find_if(kSynonyms.begin(), kSynonyms.end(),
                                     [&](const Synonym& one) { return one.word == key; });
  if (synonym != kSynonyms.end()) {
    return fmt::format("there is no setting \"{}\"; here it is called \"{}\" ({})", typed,
                       synonym->key, kAll);
  }
  // Our names first: they win if another is equally similar.
  NearestWord nearest(key);
  for (const Setting& setting : kSettings) nearest.look_at(setting.key);
  for (const std::string_view theirs : prusa_keys()) nearest.look_at(theirs);
  NearestWord left_out = nearest;
  for (const std::string_view theirs : left_out_keys()) left_out.look_at(theirs);
  if (left_out.distance() < nearest.distance()) {
    return fmt::format(
        "there is no setting \"{}\"; the nearest is PrusaSlicer's \"{}\", which rind does not have",
        typed, left_out.word());
  }
  if (nearest.word().empty()) return fmt::format("there is no setting \"{}\" ({})", typed, kAll);
  return fmt::format("there is no setting \"{}\"; the nearest is \"{}\" ({})", typed,
                     nearest.word(), kAll);
}

}  // namespace host
