// The rows of the table of settings; settings_table.cpp has the functions that use them.
//
// Help texts are noun phrases: first the setting's meaning, then special values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/limits.h"                   // kCoordinateMax
#include "core/units.h"                    // Length, kUnitsPerMm
#include "host/pipeline/print_settings.h"  // PrintSettings
#include "host/settings/settings_text.h"   // kVerbatimLinesMax

namespace host {

using SettingLines = std::vector<std::string>;

// An enumeration's field, and the names of its values in the order of the enumeration.
struct Choice {
  std::size_t (*get)(const PrintSettings& settings);
  void (*set)(PrintSettings& settings, std::size_t value);
  std::array<std::string_view, 8> names;  // "" after the last
};

template <auto kMember, typename... Names>
constexpr Choice choice(Names... names) {
  using Enumeration = std::remove_cvref_t<decltype(std::declval<PrintSettings&>().*kMember)>;
  return {[](const PrintSettings& settings) -> std::size_t {
            return static_cast<std::size_t>(settings.*kMember);
          },
          [](PrintSettings& settings, std::size_t value) {
            settings.*kMember = static_cast<Enumeration>(value);
          },
          {names...}};
}

// A number for each step of what the layer below holds; one number is written for four equal ones.
using OverhangSteps = std::array<double, core::kOverhangSteps>;

// The setting's field. Its type decides how values are written.
using SettingMember =
    std::variant<core::Length PrintSettings::*, double PrintSettings::*, int PrintSettings::*,
                 bool PrintSettings::*, std::string PrintSettings::*, SettingLines PrintSettings::*,
                 OverhangSteps PrintSettings::*, Choice>;

// A word for a number with a special meaning.
struct NumberWord {
  std::string_view word;
  double number = 0;
};
using NumberWords = std::array<NumberWord, 2>;  // "" after the last

inline constexpr NumberWords kAutoIsZero = {NumberWord{"auto", 0}};
inline constexpr NumberWords kAutoIsNegative = {NumberWord{"auto", -1}};
inline constexpr NumberWords kOffIsZero = {NumberWord{"off", 0}};
inline constexpr NumberWords kAutoOrOff = {NumberWord{"auto", 0}, NumberWord{"off", 0.001}};

struct Setting {
  std::string_view key;
  SettingMember member;
  std::string_view unit;  // "%": a fraction, which may also be given in percent
  double min = 0;         // the range includes both ends; a word's number may lie outside
  double max = 0;
  std::string_view help;
  NumberWords words{};

  [[nodiscard]] std::optional<double> number_of(std::string_view word) const;
  [[nodiscard]] std::optional<std::string_view> word_for(double number) const;
};

// Largest bed: coordinates of the part must fit.
inline constexpr double kBedMaxMm = core::kCoordinateMax / core::kUnitsPerMm / 2;

// Layers whose inside is laid at once.
inline constexpr double kLooseEveryMax = 10;

inline constexpr std::array kSettings = {
    Setting{"layer_height", &PrintSettings::layer_height, "mm", 0.01, 2, "height of every layer"},
    Setting{"wall_thickness", &PrintSettings::wall_thickness, "mm", 0.05, 100,
            "thickness of the dense wall, sideways, up and down"},
    Setting{"wall_shape", choice<&PrintSettings::wall_shape>("ball", "cylinder"), "", 0, 0,
            "shape by which the wall is offset from the surface: ball, the same thickness on any "
            "slope; cylinder, one depth for all layers"},
    Setting{"wall_layers", &PrintSettings::wall_layers, "", 0, 64,
            "number of layers that a cylinder-shaped wall reaches up and down; auto: "
            "wall_thickness in layers",
            kAutoIsZero},
    Setting{"style", choice<&PrintSettings::style>("thin-wall", "regular", "fast"), "", 0, 0,
            "way of building the inside: thin-wall, dense wall and loose inside; for comparison: "
            "regular, dense everywhere; fast, loose in hidden layers"},
    Setting{"loose_width_min", &PrintSettings::loose_width_min, "mm", 0, 20,
            "least width of the loose inside; narrower places are made solid"},
    Setting{"loose_area_min_mm2", &PrintSettings::loose_area_min_mm2, "mm²", 0, 10'000,
            "least area of an island of the loose inside; smaller ones are made solid"},
    Setting{"nozzle_diameter", &PrintSettings::nozzle_diameter, "mm", 0.05, 5,
            "bore of the nozzle"},
    Setting{"filament_diameter", &PrintSettings::filament_diameter, "mm", 0.5, 10,
            "diameter of the filament as bought"},
    Setting{"extrusion_multiplier", &PrintSettings::extrusion_multiplier, "×", 0.1, 10,
            "factor for the filament of every road"},
    Setting{"road_width", &PrintSettings::road_width, "mm", 0.05, 10,
            "width of a road where there is room for its full width"},
    Setting{"road_width_min", &PrintSettings::road_width_min, "mm", 0.01, 10,
            "width of the narrowest road of gap fill; narrower gaps are left empty"},
    Setting{"perimeters", &PrintSettings::perimeters, "", 0, 50,
            "number of closed roads along every contour"},
    Setting{"outer_perimeter_first", &PrintSettings::outer_perimeter_first, "", 0, 1,
            "whether outer perimeters come before inner ones, but for those that overhang"},
    Setting{"road_overlap", &PrintSettings::road_overlap, "%", 0, 1,
            "overlap of neighbouring roads; 1: the layer has no voids, 0: roads just touch"},
    Setting{"loose_density", &PrintSettings::loose_density, "%", 0, 1,
            "fraction of the inside that is filled; 0: empty, 1: dense"},
    Setting{"fill_angle_degrees", &PrintSettings::fill_angle_degrees, "°", -360, 360,
            "direction of fill on even layers; turned by 90° on odd layers"},
    Setting{"loose_anchor", &PrintSettings::loose_anchor, "mm", 0, 20,
            "overlap of the inside's roads into the wall, where their ends are not joined"},
    Setting{"loose_pattern",
            choice<&PrintSettings::loose_pattern>("lines", "grid", "triangles", "honeycomb",
                                                  "gyroid", "cubic", "concentric"),
            "", 0, 0, "pattern of the inside's fill"},
    Setting{"loose_every_layers", &PrintSettings::loose_every_layers, "", 1, kLooseEveryMax,
            "number of layers whose inside is laid at once, in the highest; the nozzle limits it"},
    Setting{"infill_anchor_max", &PrintSettings::infill_anchor_max, "mm", 0, 1'000,
            "longest join of the inside's roads along the wall; 0: none are joined"},
    Setting{"solid_pattern",
            choice<&PrintSettings::solid_pattern>("rectilinear", "monotonic", "concentric"), "", 0,
            0, "pattern of the wall's dense fill"},
    Setting{"top_pattern",
            choice<&PrintSettings::top_pattern>("rectilinear", "monotonic", "concentric"), "", 0, 0,
            "pattern of tops and bottoms; monotonic: no row is laid between two that are laid"},
    Setting{"top_width", &PrintSettings::top_width, "mm", 0.05, 10,
            "width of the roads of tops; auto: road_width", kAutoIsZero},
    Setting{"top_flow", &PrintSettings::top_flow, "×", 0.1, 3,
            "factor for the filament of the roads of tops"},
    Setting{"ironing", &PrintSettings::ironing, "", 0, 1,
            "whether tops are smoothed by rows of little flow"},
    Setting{"ironing_flow", &PrintSettings::ironing_flow, "%", 0, 1,
            "filament of ironing, as a fraction of a dense layer's"},
    Setting{"ironing_spacing", &PrintSettings::ironing_spacing, "mm", 0.02, 2,
            "distance of the rows of ironing"},
    Setting{
        "seam", choice<&PrintSettings::seam>("aligned", "nearest", "rear", "random"), "", 0, 0,
        "place where a closed perimeter starts and ends: aligned, in one line up the part, in a "
        "corner where there is one; nearest, near the road before; rear; random"},
    Setting{"seam_gap", &PrintSettings::seam_gap, "mm", 0, 1,
            "distance from the end of a closed road to its start; off: none", kOffIsZero},
    Setting{"fuzzy_skin", choice<&PrintSettings::fuzzy_skin>("none", "external", "all"), "", 0, 0,
            "rough surface above the first layer; external: of outer contours; all: of holes, too"},
    Setting{"fuzzy_skin_thickness", &PrintSettings::fuzzy_skin_thickness, "mm", 0, 5,
            "farthest that a point of a rough perimeter is moved, in or out"},
    Setting{"fuzzy_skin_point_distance", &PrintSettings::fuzzy_skin_point_distance, "mm", 0.05, 20,
            "mean distance of a rough perimeter's points"},
    Setting{"first_layer_height", &PrintSettings::first_layer_height, "mm", 0.01, 2,
            "height of the first layer; auto: layer_height", kAutoIsZero},
    Setting{"first_layer_width", &PrintSettings::first_layer_width, "mm", 0.05, 10,
            "width of the first layer's roads; auto: road_width", kAutoIsZero},
    Setting{"first_layer_flow", &PrintSettings::first_layer_flow, "×", 0.1, 10,
            "factor for the filament of the first layer's roads"},
    Setting{"elephant_foot_compensation", &PrintSettings::elephant_foot_compensation, "mm", 0, 5,
            "how much smaller the first layer is made all round, where it stays as wide as a road"},
    Setting{"brim_width", &PrintSettings::brim_width, "mm", 0, 100,
            "width of the brim, loops on the bed that hold the first layer; 0: none"},
    Setting{"brim_gap", &PrintSettings::brim_gap, "mm", 0, 5, "distance from the part to its brim"},
    Setting{"brim_place", choice<&PrintSettings::brim_place>("outer", "both", "inner"), "", 0, 0,
            "contours of the first layer that get a brim"},
    Setting{"skirt_loops", &PrintSettings::skirt_loops, "", 0, 50,
            "number of loops around the first layer; 0: none"},
    Setting{"skirt_length_min", &PrintSettings::skirt_length_min, "mm", 0, 10'000,
            "least length of the skirt; shorter ones get more loops"},
    Setting{"skirt_distance", &PrintSettings::skirt_distance, "mm", 0, 200,
            "distance from the part and its brim to the skirt"},
    Setting{"overhang_angle_degrees", &PrintSettings::overhang_angle_degrees, "°", 0, 90,
            "angle from the vertical; overhangs that are steeper are reported"},
    Setting{"bridge_max", &PrintSettings::bridge_max, "mm", 0, 1'000,
            "length of the longest bridge that is not reported"},
    Setting{"bridge_flow", &PrintSettings::bridge_flow, "×", 0.1, 3,
            "factor for the filament of bridges, which are round and touch one another"},
    Setting{"internal_bridge_flow", &PrintSettings::internal_bridge_flow, "×", 0.1, 3,
            "factor for the filament of bridges over the loose inside"},
    Setting{"contour_compensation", &PrintSettings::contour_compensation, "mm", -5, 5,
            "how far outer contours are moved outwards"},
    Setting{"hole_compensation", &PrintSettings::hole_compensation, "mm", -5, 5,
            "how far the contours of holes are moved inwards; negative: holes get larger"},
    Setting{"shrinkage_xy", &PrintSettings::shrinkage_xy, "%", -0.1, 0.5,
            "fraction by which the filament shrinks sideways; the part is made larger for it"},
    Setting{"shrinkage_z", &PrintSettings::shrinkage_z, "%", -0.1, 0.5,
            "fraction by which it shrinks in height; 0 for a file of layers"},
    Setting{"simplify_tolerance", &PrintSettings::simplify_tolerance, "mm", 0, 0.5,
            "largest distance that a slice's contours are moved to save points"},
    Setting{"arc_tolerance", &PrintSettings::arc_tolerance, "mm", 0.0005, 0.5,
            "largest distance between the arcs of an offset and their chords"},
    Setting{
        "chain_gap_max", &PrintSettings::chain_gap_max, "mm", 0, 100,
        "largest gap of a broken mesh that is closed; wider ones only if there is only one way"},
    Setting{"arcs", choice<&PrintSettings::arcs>("auto", "on", "off"), "", 0, 0,
            "use of arcs (G2, G3) for round roads; auto: in files, and if the controller says that "
            "it draws them"},
    Setting{"arc_fit_tolerance", &PrintSettings::arc_fit_tolerance, "mm", 0, 0.5,
            "largest distance between an arc and the road that it replaces; off: no arcs",
            kOffIsZero},
    Setting{"segment_time_min_ms", &PrintSettings::segment_time_min_ms, "ms", 0, 1'000,
            "minimum time of a segment; shorter ones are merged or printed slower; auto: from the "
            "port's baud rate, off in files; off: no minimum",
            kAutoOrOff},
    Setting{"segment_tolerance", &PrintSettings::segment_tolerance, "mm", 0, 0.5,
            "largest distance between a road and the segments that it is laid in, arcs excepted"},
    Setting{"meatpack", choice<&PrintSettings::meatpack>("auto", "off"), "", 0, 0,
            "packing of lines; auto: if the controller offers MeatPack; only for a port that loses "
            "no bytes"},
    Setting{
        "wait_limit_s", &PrintSettings::wait_limit_s, "s", 0, 604'800,
        "minimum time to wait for the answer to a command; auto: by the command, from seconds to "
        "hours",
        kAutoIsZero},
    Setting{"perimeter_speed_mm_s", &PrintSettings::perimeter_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of inner perimeters"},
    Setting{"outer_perimeter_speed_mm_s", &PrintSettings::outer_perimeter_speed_mm_s, "mm/s", 0.1,
            2'000, "speed of the part's visible surface"},
    Setting{"solid_speed_mm_s", &PrintSettings::solid_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of the wall's dense fill"},
    Setting{"loose_speed_mm_s", &PrintSettings::loose_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of the inside's fill"},
    Setting{"rest_speed_mm_s", &PrintSettings::rest_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of gap fill: roads in narrow gaps, with widths of their own"},
    Setting{"top_speed_mm_s", &PrintSettings::top_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of the dense fill of tops"},
    Setting{"ironing_speed_mm_s", &PrintSettings::ironing_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of ironing"},
    Setting{"bridge_speed_mm_s", &PrintSettings::bridge_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of bridges"},
    Setting{"internal_bridge_speed_mm_s", &PrintSettings::internal_bridge_speed_mm_s, "mm/s", 0.1,
            2'000, "speed of bridges over the loose inside"},
    Setting{"overhang_speed_mm_s", &PrintSettings::overhang_speed_mm_s, "mm/s", 0, 2'000,
            "speed of perimeters of which the layer below holds more than 3/4, 1/2, 1/4 of the "
            "width, and less; 0: no limit"},
    Setting{"small_perimeter_speed_mm_s", &PrintSettings::small_perimeter_speed_mm_s, "mm/s", 0.1,
            2'000, "speed of closed perimeters up to 40 mm long; off: as others", kOffIsZero},
    Setting{"volumetric_speed_max_mm3_s", &PrintSettings::volumetric_speed_max_mm3_s, "mm3/s", 0.01,
            10'000,
            "filament that can be molten in a second; faster roads are slowed down; off: "
            "not limited",
            kOffIsZero},
    Setting{"first_layer_speed_mm_s", &PrintSettings::first_layer_speed_mm_s, "mm/s", 0.1, 2'000,
            "speed of the fastest road of the first layer"},
    Setting{"travel_speed_mm_s", &PrintSettings::travel_speed_mm_s, "mm/s", 0.1, 5'000,
            "speed of travel moves"},
    Setting{"lift_speed_mm_s", &PrintSettings::lift_speed_mm_s, "mm/s", 0.1, 1'000,
            "speed of the nozzle up and down"},
    Setting{"layer_time_min_s", &PrintSettings::layer_time_min_s, "s", 0, 3'600,
            "minimum time of a layer; with cool_short_layers, a faster layer is slowed down"},
    Setting{"slowed_speed_min_mm_s", &PrintSettings::slowed_speed_min_mm_s, "mm/s", 0.1, 2'000,
            "lowest speed to which a layer is slowed down"},
    Setting{"height_slowdown_from", &PrintSettings::height_slowdown_from, "mm", 0, 1e6,
            "height from which speed and acceleration sink, for slender parts"},
    Setting{"height_slowdown_to", &PrintSettings::height_slowdown_to, "mm", 0, 1e6,
            "height above which they don't sink any more; off: they don't sink", kOffIsZero},
    Setting{"height_slowdown_speed", &PrintSettings::height_slowdown_speed, "%", 0.05, 1,
            "fraction of every speed that is left from height_slowdown_to on"},
    Setting{"height_slowdown_acceleration", &PrintSettings::height_slowdown_acceleration, "%", 0.05,
            1, "fraction of the accelerations that is left from height_slowdown_to on"},
    Setting{"default_acceleration_mm_s2", &PrintSettings::default_acceleration_mm_s2, "mm/s2", 1,
            100'000,
            "acceleration of roads without one of their own, and that the printer is left with; "
            "off: the printer's own throughout",
            kOffIsZero},
    Setting{"perimeter_acceleration_mm_s2", &PrintSettings::perimeter_acceleration_mm_s2, "mm/s2",
            1, 100'000, "acceleration of perimeters; off: default_acceleration_mm_s2", kOffIsZero},
    Setting{"outer_perimeter_acceleration_mm_s2",
            &PrintSettings::outer_perimeter_acceleration_mm_s2, "mm/s2", 1, 100'000,
            "acceleration of the part's visible surface; off: perimeter_acceleration_mm_s2",
            kOffIsZero},
    Setting{"loose_acceleration_mm_s2", &PrintSettings::loose_acceleration_mm_s2, "mm/s2", 1,
            100'000, "acceleration of the inside's fill; off: default_acceleration_mm_s2",
            kOffIsZero},
    Setting{"solid_acceleration_mm_s2", &PrintSettings::solid_acceleration_mm_s2, "mm/s2", 1,
            100'000, "acceleration of the wall's dense fill; off: loose_acceleration_mm_s2",
            kOffIsZero},
    Setting{"top_acceleration_mm_s2", &PrintSettings::top_acceleration_mm_s2, "mm/s2", 1, 100'000,
            "acceleration of tops and ironing; off: solid_acceleration_mm_s2", kOffIsZero},
    Setting{"bridge_acceleration_mm_s2", &PrintSettings::bridge_acceleration_mm_s2, "mm/s2", 1,
            100'000, "acceleration of bridges and overhanging perimeters; off: as other roads",
            kOffIsZero},
    Setting{"first_layer_acceleration_mm_s2", &PrintSettings::first_layer_acceleration_mm_s2,
            "mm/s2", 1, 100'000, "acceleration of the first layer's roads; off: as other layers",
            kOffIsZero},
    Setting{"travel_acceleration_mm_s2", &PrintSettings::travel_acceleration_mm_s2, "mm/s2", 1,
            100'000, "acceleration of travel; off: that of the road before it", kOffIsZero},
    Setting{"acceleration_mm_s2", &PrintSettings::acceleration_mm_s2, "mm/s2", 1, 100'000,
            "acceleration of the machine where it is not told any, for the estimate of time only"},
    Setting{"filament_acceleration_mm_s2", &PrintSettings::filament_acceleration_mm_s2, "mm/s2", 1,
            100'000, "acceleration of retractions, for the estimate of time only"},
    Setting{"junction_deviation_mm", &PrintSettings::junction_deviation_mm, "mm", 0, 1,
            "junction deviation of the machine at corners, for the estimate of time only"},
    Setting{"retraction_mm", &PrintSettings::retraction_mm, "mm", 0, 100,
            "length of filament that is retracted before travel"},
    Setting{"retraction_speed_mm_s", &PrintSettings::retraction_speed_mm_s, "mm/s", 0.1, 500,
            "speed of the filament when it is retracted and returned"},
    Setting{"retraction_travel_min", &PrintSettings::retraction_travel_min, "mm", 0, 1'000,
            "length of the shortest travel within the part with retraction"},
    Setting{"only_retract_when_crossing_perimeters",
            &PrintSettings::only_retract_when_crossing_perimeters, "", 0, 1,
            "whether travel that stays within the part is without retraction however long it is, "
            "but over finished tops"},
    Setting{"retraction_lift", &PrintSettings::retraction_lift, "mm", 0, 50,
            "lift of the nozzle above the layer during travel with retraction"},
    Setting{"wipe", &PrintSettings::wipe, "", 0, 1,
            "whether the nozzle moves over the road just laid while filament is retracted"},
    Setting{"wipe_distance", &PrintSettings::wipe_distance, "mm", 0.01, 100,
            "length of the way over the road just laid; auto: as far as the nozzle comes during "
            "the retraction at 4/5 of travel_speed_mm_s",
            kAutoIsZero},
    Setting{"retraction_before_wipe", &PrintSettings::retraction_before_wipe, "%", 0, 1,
            "fraction of the retraction before the nozzle moves"},
    Setting{"avoid_crossing_perimeters", &PrintSettings::avoid_crossing_perimeters, "", 0, 1,
            "whether travel within an island goes around holes and notches"},
    Setting{"avoid_crossing_max_detour", &PrintSettings::avoid_crossing_max_detour, "mm", 0.01,
            10'000,
            "length that such a way may have more than the straight one, which is taken otherwise; "
            "off: any",
            kOffIsZero},
    Setting{"bed_x", &PrintSettings::bed_x, "mm", 1, kBedMaxMm, "width of the bed"},
    Setting{"bed_y", &PrintSettings::bed_y, "mm", 1, kBedMaxMm, "depth of the bed"},
    Setting{"bed_origin_x", &PrintSettings::bed_origin_x, "mm", -kBedMaxMm, kBedMaxMm,
            "printer's x of the bed's front left corner"},
    Setting{"bed_origin_y", &PrintSettings::bed_origin_y, "mm", -kBedMaxMm, kBedMaxMm,
            "printer's y of the bed's front left corner"},
    Setting{"axis_z", &PrintSettings::axis_z, "mm", 0, 1e9,
            "largest height that the nozzle can reach; off: not limited", kOffIsZero},
    Setting{"centre", &PrintSettings::centre, "", 0, 1,
            "whether the part is centred on the bed; 0: at part_x, part_y"},
    Setting{"part_x", &PrintSettings::part_x, "mm", 0, kBedMaxMm,
            "distance of the part's left side from the bed's"},
    Setting{"part_y", &PrintSettings::part_y, "mm", 0, kBedMaxMm,
            "distance of the part's front from the bed's"},
    Setting{"nozzle_celsius", &PrintSettings::nozzle_celsius, "°C", 0, 500,
            "temperature of the nozzle; 0: not heated"},
    Setting{"nozzle_first_layer_celsius", &PrintSettings::nozzle_first_layer_celsius, "°C", 0, 500,
            "temperature of the nozzle on the first layer; 0: not heated"},
    Setting{"bed_celsius", &PrintSettings::bed_celsius, "°C", 0, 200,
            "temperature of the bed; 0: not heated"},
    Setting{"bed_first_layer_celsius", &PrintSettings::bed_first_layer_celsius, "°C", 0, 200,
            "temperature of the bed on the first layer; auto: bed_celsius", kAutoIsNegative},
    Setting{"cool_short_layers", &PrintSettings::cool_short_layers, "", 0, 1,
            "whether short layers are slowed down and get more of the fan"},
    Setting{"fan_share", &PrintSettings::fan_share, "%", 0, 1,
            "speed of the part's fan on layers shorter than layer_time_min_s"},
    Setting{"bridge_fan_share", &PrintSettings::bridge_fan_share, "%", 0, 1,
            "speed of the part's fan on bridges, if it is more than the layer's"},
    Setting{"overhang_fan_share", &PrintSettings::overhang_fan_share, "%", 0, 1,
            "speed of the part's fan on perimeters of which the layer below holds more than 3/4, "
            "1/2, 1/4 of the width, and less, if it is more than the layer's"},
    Setting{"fan_share_min", &PrintSettings::fan_share_min, "%", 0, 1,
            "speed of the part's fan on layers of fan_below_layer_time_s or longer"},
    Setting{"fan_always_on", &PrintSettings::fan_always_on, "", 0, 1,
            "whether the fan also runs on long layers"},
    Setting{"fan_below_layer_time_s", &PrintSettings::fan_below_layer_time_s, "s", 0, 3'600,
            "time of a layer below which the fan is faster than fan_share_min"},
    Setting{"fan_from_layer", &PrintSettings::fan_from_layer, "", 1, 1e6,
            "number of the first layer with the fan on, counted from 1"},
    Setting{"fan_full_layer", &PrintSettings::fan_full_layer, "", 0, 1e6,
            "number of the layer up to which the fan's speed rises; 0: at once"},
    Setting{"pressure_advance_s", &PrintSettings::pressure_advance_s, "s", 0, 10,
            "pressure advance (Marlin's K, linear advance); 0: none; auto: the printer's own",
            kAutoIsNegative},
    Setting{"gcode_flavor",
            choice<&PrintSettings::gcode_flavor>("marlin", "klipper", "reprapfirmware"), "", 0, 0,
            "firmware whose accelerations and pressure advance a file has; a print: its own"},
    Setting{"start_gcode", &PrintSettings::start_gcode, "", 0, kVerbatimLinesMax,
            "lines of G-code that are sent first, with \\n between them; ';' starts a comment"},
    Setting{"end_gcode", &PrintSettings::end_gcode, "", 0, kVerbatimLinesMax,
            "lines of G-code that are sent last"},
    Setting{"at_height", &PrintSettings::at_height, "", 0, kVerbatimLinesMax,
            "lines of a height in mm and what is done before the first layer that starts there or "
            "above: pause, nozzle_celsius NUMBER, gcode LINE, or a command as M600"},
    Setting{"pause_gcode", &PrintSettings::pause_gcode, "", 0, kVerbatimLinesMax,
            "lines of G-code that stand for a pause in a file; a print pauses by itself"},
    Setting{"allow_gcode", &PrintSettings::allow_gcode, "", 0, 0,
            "commands that the user's G-code may have although they are refused otherwise, as "
            "M500,M501; only on the command line"},
    Setting{"park_lift", &PrintSettings::park_lift, "mm", 0, 1'000,
            "lift of the nozzle at the end and at a stop"},
    Setting{
        "park_x", &PrintSettings::park_x, "mm", 0, kBedMaxMm,
        "parked nozzle's distance from the bed's left side; auto: 5 mm at the end and at a stop, "
        "in a pause that of the corner farthest from the part",
        kAutoIsNegative},
    Setting{"park_y", &PrintSettings::park_y, "mm", 0, kBedMaxMm,
            "parked nozzle's distance from the bed's front; auto: as park_x", kAutoIsNegative},
};

}  // namespace host
