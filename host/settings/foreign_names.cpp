#include "host/settings/foreign_names.h"

#include <algorithm>
#include <array>

#include "host/settings/settings_text.h"  // read_number, write_number

namespace host {
namespace {

enum class ForeignKind {
  kSame,
  kPercent,         // 20 for 20%
  kShare,           // 98 for 0.98
  kFromHorizontal,  // an angle from the vertical
};

struct Row {
  std::string_view theirs;
  std::string_view prusas;
  ForeignKind kind = ForeignKind::kSame;
};

constexpr std::array kRows = {
    // OrcaSlicer's and Bambu Studio's.
    Row{"printable_area", "bed_shape"},
    Row{"printable_height", "max_print_height"},
    Row{"machine_start_gcode", "start_gcode"},
    Row{"machine_end_gcode", "end_gcode"},
    Row{"machine_pause_gcode", "pause_print_gcode"},
    Row{"initial_layer_print_height", "first_layer_height"},
    Row{"line_width", "extrusion_width"},
    Row{"initial_layer_line_width", "first_layer_extrusion_width"},
    Row{"outer_wall_line_width", "external_perimeter_extrusion_width"},
    Row{"inner_wall_line_width", "perimeter_extrusion_width"},
    Row{"sparse_infill_line_width", "infill_extrusion_width"},
    Row{"internal_solid_infill_line_width", "solid_infill_extrusion_width"},
    Row{"top_surface_line_width", "top_infill_extrusion_width"},
    Row{"support_line_width", "support_material_extrusion_width"},
    Row{"print_sequence", "complete_objects"},  // Cura's, too
    Row{"extruder_clearance_max_radius", "extruder_clearance_radius"},
    Row{"extruder_clearance_height_to_rod", "extruder_clearance_height"},
    Row{"gantry_height", "extruder_clearance_height"},  // Cura's
    Row{"wall_loops", "perimeters"},
    Row{"top_shell_layers", "top_solid_layers"},
    Row{"bottom_shell_layers", "bottom_solid_layers"},
    Row{"sparse_infill_density", "fill_density"},
    Row{"sparse_infill_pattern", "fill_pattern"},
    Row{"infill_direction", "fill_angle"},
    Row{"top_surface_pattern", "top_fill_pattern"},
    Row{"bottom_surface_pattern", "bottom_fill_pattern"},
    Row{"skirt_loops", "skirts"},
    Row{"brim_object_gap", "brim_separation"},
    Row{"outer_wall_speed", "external_perimeter_speed"},
    Row{"inner_wall_speed", "perimeter_speed"},
    Row{"sparse_infill_speed", "infill_speed"},
    Row{"internal_solid_infill_speed", "solid_infill_speed"},
    Row{"top_surface_speed", "top_solid_infill_speed"},
    Row{"gap_infill_speed", "gap_fill_speed"},
    Row{"support_speed", "support_material_speed"},
    Row{"support_interface_speed", "support_material_interface_speed"},
    Row{"initial_layer_speed", "first_layer_speed"},
    Row{"bridge_flow", "bridge_flow_ratio"},
    Row{"outer_wall_acceleration", "external_perimeter_acceleration"},
    Row{"inner_wall_acceleration", "perimeter_acceleration"},
    Row{"top_surface_acceleration", "top_solid_infill_acceleration"},
    Row{"initial_layer_acceleration", "first_layer_acceleration"},
    Row{"sparse_infill_acceleration", "infill_acceleration"},
    Row{"internal_solid_infill_acceleration", "solid_infill_acceleration"},
    Row{"enable_support", "support_material"},
    Row{"support_threshold_angle", "support_material_threshold"},
    Row{"support_on_build_plate_only", "support_material_buildplate_only"},
    Row{"support_object_xy_distance", "support_material_xy_spacing"},
    Row{"support_top_z_distance", "support_material_contact_distance"},
    Row{"support_bottom_z_distance", "support_material_bottom_contact_distance"},
    Row{"support_base_pattern_spacing", "support_material_spacing"},
    Row{"support_interface_spacing", "support_material_interface_spacing"},
    Row{"support_interface_top_layers", "support_material_interface_layers"},
    Row{"support_interface_bottom_layers", "support_material_bottom_interface_layers"},
    Row{"spiral_mode", "spiral_vase"},
    Row{"fuzzy_skin_point_distance", "fuzzy_skin_point_dist"},
    Row{"ironing_flow", "ironing_flowrate"},
    Row{"nozzle_temperature", "temperature"},
    Row{"nozzle_temperature_initial_layer", "first_layer_temperature"},
    Row{"hot_plate_temp", "bed_temperature"},
    Row{"hot_plate_temp_initial_layer", "first_layer_bed_temperature"},
    Row{"bed_temperature_initial_layer", "first_layer_bed_temperature"},
    Row{"bed_temperature_initial_layer_single", "first_layer_bed_temperature"},
    Row{"chamber_temperatures", "chamber_temperature"},
    Row{"filament_flow_ratio", "extrusion_multiplier"},
    Row{"retraction_length", "retract_length"},
    Row{"retraction_speed", "retract_speed"},
    Row{"retraction_minimum_travel", "retract_before_travel"},
    Row{"z_hop", "retract_lift"},
    Row{"reduce_crossing_wall", "avoid_crossing_perimeters"},
    Row{"max_travel_detour_distance", "avoid_crossing_perimeters_max_detour"},
    Row{"fan_min_speed", "min_fan_speed"},
    Row{"fan_max_speed", "max_fan_speed"},
    Row{"fan_cooling_layer_time", "fan_below_layer_time"},
    Row{"slow_down_layer_time", "slowdown_below_layer_time"},
    Row{"slow_down_min_speed", "min_print_speed"},
    Row{"slow_down_for_layer_cooling", "cooling"},
    Row{"close_fan_the_first_x_layers", "disable_fan_first_layers"},
    Row{"reduce_fan_stop_start_freq", "fan_always_on"},
    Row{"overhang_fan_speed", "bridge_fan_speed"},
    Row{"resolution", "gcode_resolution"},
    Row{"filament_start_gcode", "start_filament_gcode"},
    Row{"filament_end_gcode", "end_filament_gcode"},
    Row{"layer_change_gcode", "layer_gcode"},
    Row{"before_layer_change_gcode", "before_layer_gcode"},
    Row{"support_type", "support_material_style"},
    Row{"filament_retraction_length", "filament_retract_length"},
    Row{"filament_retraction_speed", "filament_retract_speed"},
    Row{"filament_retraction_minimum_travel", "filament_retract_before_travel"},
    Row{"filament_z_hop", "filament_retract_lift"},
    // Cura's.
    Row{"support_angle", "support_material_threshold", ForeignKind::kFromHorizontal},
    Row{"material_print_temperature", "temperature"},
    Row{"material_print_temperature_layer_0", "first_layer_temperature"},
    Row{"material_bed_temperature", "bed_temperature"},
    Row{"material_bed_temperature_layer_0", "first_layer_bed_temperature"},
    Row{"layer_height_0", "first_layer_height"},
    Row{"machine_nozzle_size", "nozzle_diameter"},
    Row{"material_diameter", "filament_diameter"},
    Row{"machine_height", "max_print_height"},
    Row{"infill_sparse_density", "fill_density", ForeignKind::kPercent},
    Row{"material_flow", "extrusion_multiplier", ForeignKind::kShare},
    Row{"infill_pattern", "fill_pattern"},
    Row{"wall_line_count", "perimeters"},
    Row{"speed_wall_0", "external_perimeter_speed"},
    Row{"speed_wall_x", "perimeter_speed"},
    Row{"speed_infill", "infill_speed"},
    Row{"speed_topbottom", "solid_infill_speed"},
    Row{"speed_roofing", "top_solid_infill_speed"},
    Row{"speed_travel", "travel_speed"},
    Row{"speed_layer_0", "first_layer_speed"},
    Row{"speed_support", "support_material_speed"},
    Row{"retraction_amount", "retract_length"},
    Row{"retraction_hop", "retract_lift"},
    Row{"retraction_min_travel", "retract_before_travel"},
    Row{"skirt_line_count", "skirts"},
    Row{"skirt_gap", "skirt_distance"},
    Row{"brim_gap", "brim_separation"},
    Row{"xy_offset", "xy_size_compensation"},
    Row{"support_enable", "support_material"},
    Row{"support_xy_distance", "support_material_xy_spacing"},
    Row{"support_z_distance", "support_material_contact_distance"},
    Row{"magic_spiralize", "spiral_vase"},
    Row{"cool_fan_speed_min", "min_fan_speed"},
    Row{"cool_fan_speed_max", "max_fan_speed"},
    Row{"cool_min_layer_time", "slowdown_below_layer_time"},
    Row{"cool_min_speed", "min_print_speed"},
    Row{"acceleration_wall_0", "external_perimeter_acceleration"},
    Row{"acceleration_wall_x", "perimeter_acceleration"},
    Row{"acceleration_infill", "infill_acceleration"},
    Row{"acceleration_travel", "travel_acceleration"},
    Row{"acceleration_layer_0", "first_layer_acceleration"},
    Row{"acceleration_print", "default_acceleration"},
    Row{"ironing_enabled", "ironing"},
    Row{"ironing_line_spacing", "ironing_spacing"},
    Row{"speed_ironing", "ironing_speed"},
    Row{"z_seam_type", "seam_position"},
    Row{"outer_inset_first", "external_perimeters_first"},
};

// Words of the others for PrusaSlicer's.
struct Word {
  std::string_view prusas_key;
  std::string_view theirs;
  std::string_view prusas;
};

constexpr std::array kWords = {
    Word{"support_material_style", "tree(auto)", "tree"},
    Word{"support_material_style", "tree(manual)", "tree"},
    Word{"support_material_style", "hybrid(auto)", "tree"},
    Word{"support_material_style", "normal(auto)", "grid"},
    Word{"support_material_style", "normal(manual)", "grid"},
    Word{"complete_objects", "by object", "1"},
    Word{"complete_objects", "by layer", "0"},
    Word{"complete_objects", "one_at_a_time", "1"},
    Word{"complete_objects", "all_at_once", "0"},
    Word{"seam_position", "back", "rear"},
    Word{"seam_position", "shortest", "nearest"},
    Word{"fuzzy_skin", "allwalls", "all"},
    Word{"fill_pattern", "zigzag", "rectilinear"},
    Word{"fill_pattern", "lines", "rectilinear"},
    Word{"top_fill_pattern", "monotonicline", "monotoniclines"},
    Word{"gcode_flavor", "RepRap (Marlin/Sprinter)", "marlin"},
    Word{"gcode_flavor", "RepRap (RepRap)", "reprapfirmware"},
    Word{"gcode_flavor", "Marlin", "marlin"},
};

const Row* row_of(std::string_view foreign) {
  const auto* found = std::find_if(kRows.begin(), kRows.end(),
                                   [&](const Row& row) { return row.theirs == foreign; });
  return found == kRows.end() ? nullptr : found;
}

}  // namespace

std::string_view prusa_name(std::string_view foreign) {
  const Row* row = row_of(foreign);
  return row == nullptr ? foreign : row->prusas;
}

std::string prusa_value(std::string_view foreign, std::string_view value) {
  const Row* row = row_of(foreign);
  const std::string_view key = row == nullptr ? foreign : row->prusas;
  for (const Word& word : kWords) {
    if (word.prusas_key == key && word.theirs == value) return std::string(word.prusas);
  }
  if (value == "true" || value == "True") return "1";
  if (value == "false" || value == "False") return "0";
  if (row == nullptr || row->kind == ForeignKind::kSame) return std::string(value);
  const core::Result<double> number = read_number(value, "");
  if (!number.ok()) return std::string(value);
  if (row->kind == ForeignKind::kFromHorizontal) return write_number(90 - number.value());
  if (row->kind == ForeignKind::kShare) return write_number(number.value() / 100);
  return write_number(number.value()) + "%";
}

}  // namespace host
