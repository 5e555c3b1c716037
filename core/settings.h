// Everything that a user can set about a part and the way it is built. Defaults are here. The host
// adds settings of the link, and has the units, the ranges and the help texts.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/geometry.h"  // Point
#include "core/units.h"     // Length

namespace core {

// The shape of the wall's inner side (wall_splitter.h).
enum class WallShape {
  kBall,      // one thickness in three dimensions, on any slope
  kCylinder,  // the paper's: one depth for all layers of the window
};

// How the inside of a part is built. The others are there to compare with.
enum class BuildStyle {
  kThinWall,  // dense wall, loose inside
  kRegular,   // dense everywhere
  kFast,      // three perimeters around a loose inside where a layer is wholly hidden by T layers
              // above and below, dense elsewhere (wall_style.h)
};

// Whether roads are drawn as arcs (G2, G3) where they are round.
enum class ArcUse {
  kAuto,  // in print, where the controller says that it draws them; in a file
  kOn,
  kOff,
};

// Where a closed perimeter starts and ends.
enum class SeamPosition { kAligned, kNearest, kRear, kRandom };

// How the loose inside is filled.
enum class LoosePattern {
  kLines,
  kGrid,
  kTriangles,
  kHoneycomb,
  kGyroid,
  kCubic,
  kConcentric,
  kLightning,  // branches under roofs alone (supports/lightning_fold.h)
};

// What of the inside is made solid so that it holds up its own roof (supports/roof_fold.h).
enum class LooseRoof { kOff, kCone };

// How what is dense is filled.
enum class SolidPattern { kRectilinear, kMonotonic, kConcentric };

// Steps of the share of a road that the layer below holds: over 3/4, over 1/2, over 1/4, less.
inline constexpr std::size_t kOverhangSteps = 4;

// Which outer perimeters are made rough.
enum class FuzzySkin { kNone, kOuter, kAll };

// Whose commands a file has for what firmwares spell in different ways.
enum class GcodeFlavor { kMarlin, kKlipper, kRepRapFirmware };

// The axis along which the part is mirrored.
enum class PartMirror { kNone, kX, kY, kZ };

// What the numbers of a file that does not tell its unit are.
enum class PartUnits { kMillimetre, kInch, kMetre };

// How a file, or a controller, is told which roads belong to which of several objects.
enum class ObjectLabels {
  kAuto,      // comments, and the commands of Klipper and RepRapFirmware
  kFirmware,  // comments and commands: M486, EXCLUDE_OBJECT
  kComments,  // in files alone
  kOff,
};

// What supports may stand on.
enum class SupportPlace { kOff, kBed, kEverywhere };

// What supports are made of under their dense layers.
enum class SupportStyle {
  kGrid,  // rows that stand on one another, straight down
  kTree,  // branches that grow together (supports/tree_fold.h)
};

// Which contours of the first layer get a brim.
enum class BrimPlace { kOuter, kBoth, kInner };

struct Settings {
  // Layers and the wall.
  Length layer_height = Length::from_units(2'000);
  bool adaptive_layer_height = false;                 // lower layers where the surface is flat
  Length cusp_height = Length::from_units(500);       // the highest step that they leave
  Length layer_height_min = Length::from_units(700);  // of them
  Length layer_height_max;                            // of them; 0: 3/4 of the nozzle's bore
  std::vector<std::string> height_range;              // "10-12.5 0.1" (layer_heights.h)
  Length wall_thickness = Length::from_units(8'000);
  WallShape wall_shape = WallShape::kBall;
  int wall_layers = 0;  // T of a cylinder; 0: from the wall's thickness
  BuildStyle style = BuildStyle::kThinWall;
  Length loose_width_min = Length::from_units(9'000);  // narrower tongues of the inside: solid
  double loose_area_min_mm2 = 1;                       // smaller islands of it: solid

  // Roads.
  Length nozzle_diameter = Length::from_units(4'000);
  Length filament_diameter = Length::from_units(17'500);
  std::string filament_type = "PLA";     // this and the next four: for people, and files' comments
  std::string filament_name;             // empty: not known; likewise the next
  std::string filament_colour;           // as "#FF8000"
  double filament_density_g_cm3 = 1.24;  // 0: not known
  double filament_cost_kg = 0;           // 0: not known
  double extrusion_multiplier = 1;       // of the filament that each road takes
  Length road_width = Length::from_units(4'500);
  Length road_width_min = Length::from_units(2'000);  // narrower rests are left out
  int perimeters = 2;
  bool outer_perimeter_first = false;
  double road_overlap = 1;         // 1: neighbours fill the layer without voids; 0: they just touch
  double loose_density = 0.2;      // share of the inside's volume; 0: empty, 1: dense
  double fill_angle_degrees = 45;  // of even layers; odd ones are turned by 90°
  Length loose_anchor = Length::from_units(3'000);  // how far loose roads reach into the wall
  LoosePattern loose_pattern = LoosePattern::kLines;
  LooseRoof loose_roof = LooseRoof::kOff;
  int loose_every_layers = 1;  // whose inside is laid at once (loose_blocks.h)
  Length infill_anchor_max = Length::from_units(500'000);  // longest join of loose roads
  SolidPattern solid_pattern = SolidPattern::kRectilinear;
  SolidPattern top_pattern = SolidPattern::kMonotonic;
  Length top_width;  // of roads in tops; 0: road_width
  double top_flow = 1;
  bool ironing = false;
  double ironing_flow = 0.15;
  Length ironing_spacing = Length::from_units(1'000);
  bool spiral_vase = false;  // one perimeter that rises without a seam
  SeamPosition seam = SeamPosition::kAligned;
  Length seam_gap = Length::from_units(600);  // between a closed road's end and its start
  FuzzySkin fuzzy_skin = FuzzySkin::kNone;
  Length fuzzy_skin_thickness = Length::from_units(3'000);  // as far in and out, at most
  Length fuzzy_skin_point_distance = Length::from_units(8'000);

  // The first layer. Lengths of 0: like the other layers.
  Length first_layer_height;
  Length first_layer_width;
  double first_layer_flow = 1;
  Length elephant_foot_compensation;  // how much smaller it is, where it stays wide enough
  Length brim_width;                  // 0: none
  Length brim_gap;                    // between the part and its brim
  BrimPlace brim_place = BrimPlace::kOuter;
  int skirt_loops = 1;
  Length skirt_length_min;  // more loops until the skirt is as long
  Length skirt_distance = Length::from_units(30'000);

  // The raft, torn off later.
  int raft_layers = 0;                                       // 0: none
  Length raft_expansion = Length::from_units(15'000);        // beyond the first slice
  Length raft_contact_distance = Length::from_units(1'000);  // between the raft and the part
  double raft_first_layer_density = 0.9;                     // share of its area; of supports', too

  // Supports, torn off later (supports/support_fold.h).
  SupportPlace supports = SupportPlace::kOff;
  bool support_auto = true;                       // otherwise only what is enforced is held
  std::vector<std::string> support_height_range;  // "0-20 off" (supports/support_heights.h)
  SupportStyle support_style = SupportStyle::kGrid;
  int support_top_gap_layers = 1;     // between a support and what it holds
  int support_bottom_gap_layers = 1;  // between a support and what it stands on
  Length support_xy_distance = Length::from_units(4'000);
  int support_interface_layers = 2;                              // the topmost layers are dense
  int support_bottom_interface_layers = 2;                       // over the part, the lowest ones
  Length support_spacing = Length::from_units(25'000);           // between two roads
  Length support_interface_spacing = Length::from_units(2'000);  // likewise, where it is dense
  double support_angle_degrees = 45;  // of its roads; of dense layers across them
  Length support_width;               // of its roads; 0: road_width
  double support_flow = 1;
  double support_interface_flow = 1;
  Length support_base_expansion = Length::from_units(10'000);  // on the bed
  double support_area_min_mm2 = 0.5;  // of what hangs; smaller pieces are left alone
  Length support_section_min = Length::from_units(20'000);  // under an island
  int support_lookahead = 0;  // in layers; 0: the whole part (supports/support_lookahead.h)
  // Of trees.
  double support_branch_angle_degrees = 40;  // from the vertical, at most
  Length support_branch_diameter = Length::from_units(20'000);
  double support_branch_diameter_angle_degrees = 5;  // by which branches grow wider downwards
  Length support_tip_diameter = Length::from_units(8'000);
  Length support_tip_spacing = Length::from_units(30'000);  // under what hangs

  // Bridges and overhangs.
  double overhang_angle_degrees = 45;               // from the vertical; steeper is told, or held
  Length bridge_max = Length::from_units(100'000);  // longer spans are told
  double bridge_flow = 1;
  double internal_bridge_flow = 1;

  // How much larger contours are made, to make up for how the printer prints.
  Length contour_compensation;
  Length hole_compensation;  // negative: larger holes

  // The share by which the filament shrinks as it cools; the part is made larger for it.
  double shrinkage_xy = 0;
  double shrinkage_z = 0;

  // Slicing.
  Length simplify_tolerance = Length::from_units(50);  // 5 µm
  Length arc_tolerance = Length::from_units(25);       // 2.5 µm
  Length chain_gap_max = Length::from_units(20'000);   // beyond it, only one way

  // Roads as motions.
  ArcUse arcs = ArcUse::kAuto;
  Length arc_fit_tolerance = Length::from_units(70);  // 7 µm, between a road and its arcs
  // No stretch of a road has shorter segments than this, in the mean over what a planner holds
  // (segment_merger.h).
  double segment_time_min_ms = 0;                     // 0: as the port's baud says; in a file: none
  Length segment_tolerance = Length::from_units(70);  // 7 µm, between a road and merged segments

  // Speeds, mm/s.
  double perimeter_speed_mm_s = 60;
  double outer_perimeter_speed_mm_s = 60;
  double solid_speed_mm_s = 60;
  double loose_speed_mm_s = 60;
  double rest_speed_mm_s = 40;
  double top_speed_mm_s = 40;
  double ironing_speed_mm_s = 15;
  double support_speed_mm_s = 60;
  double support_interface_speed_mm_s = 45;
  double bridge_speed_mm_s = 30;
  double internal_bridge_speed_mm_s = 40;
  std::array<double, kOverhangSteps> overhang_speed_mm_s{60, 45, 30, 20};  // 0: no difference
  double small_perimeter_speed_mm_s = 0;                                   // 0: no difference
  double volumetric_speed_max_mm3_s = 0;                                   // 0: no limit
  double first_layer_speed_mm_s = 30;
  double travel_speed_mm_s = 130;
  double lift_speed_mm_s = 10;
  double layer_time_min_s = 5;  // shorter layers are slowed down, where cool_short_layers
  double slowed_speed_min_mm_s = 10;

  // Speed and acceleration sink evenly from one height to another, to a share of them: slender
  // parts sway.
  Length height_slowdown_from;
  Length height_slowdown_to;  // 0: they don't sink
  double height_slowdown_speed = 1;
  double height_slowdown_acceleration = 1;

  // Accelerations that the machine is told, by kind of road, mm/s² (road_accelerations.h). 0: that
  // of other roads. Without a default, none is told.
  double default_acceleration_mm_s2 = 0;
  double perimeter_acceleration_mm_s2 = 0;
  double outer_perimeter_acceleration_mm_s2 = 0;
  double loose_acceleration_mm_s2 = 0;
  double solid_acceleration_mm_s2 = 0;
  double top_acceleration_mm_s2 = 0;
  double bridge_acceleration_mm_s2 = 0;
  double first_layer_acceleration_mm_s2 = 0;
  double travel_acceleration_mm_s2 = 0;

  // How the machine moves: for the estimate of time only (motion_clock.h), it is not told.
  double acceleration_mm_s2 = 1'000;
  double filament_acceleration_mm_s2 = 3'000;
  double junction_deviation_mm = 0.013;
  double jerk_xy_mm_s = 0;  // 0: corners by the junction deviation; likewise the next
  double jerk_z_mm_s = 0;
  double jerk_filament_mm_s = 0;
  double square_corner_speed_mm_s = 0;  // Klipper's
  double speed_max_xy_mm_s = 0;         // 0: no limit; likewise all of these
  double speed_max_z_mm_s = 0;
  double speed_max_filament_mm_s = 0;
  double acceleration_max_xy_mm_s2 = 0;
  double acceleration_max_z_mm_s2 = 0;
  double acceleration_max_filament_mm_s2 = 0;

  // Travel.
  double retraction_mm = 1;
  double retraction_speed_mm_s = 40;
  Length retraction_travel_min = Length::from_units(50'000);  // shorter inside the part: none
  bool only_retract_when_crossing_perimeters = false;         // inside the part: none, also if long
  Length retraction_lift;                                     // 0: travel at the layer's height
  bool wipe = false;                                          // over the road just laid
  Length wipe_distance;  // 0: as far as the nozzle comes while the filament is drawn back
  double retraction_before_wipe = 0;  // share of the retraction
  bool avoid_crossing_perimeters = false;
  Length avoid_crossing_max_detour;  // longer than the straight way by more: straight; 0: any

  // Machine. Its names are for files' comments; empty: not known.
  std::string printer_name;     // of its settings
  std::string printer_vendor;   // who makes it
  std::string printer_model;    // as its maker calls it
  std::string printer_variant;  // of the model; empty: the nozzle's bore
  Length bed_x = Length::from_units(3'000'000);
  Length bed_y = Length::from_units(3'000'000);
  Length bed_origin_x;  // the printer's coordinates of the bed's front left corner
  Length bed_origin_y;
  // Its outline in the printer's coordinates (bed.h); empty: the rectangle of the four above.
  std::vector<Point> bed_shape;
  Length axis_z;       // 0: not limited
  bool centre = true;  // on the bed; otherwise at part_x, part_y
  Length part_x;       // from the bed's front left corner to the lowest x and y of the part
  Length part_y;
  std::string part_scale = "1";     // this and the next three: what is done to what is read of the
  std::string part_rotation = "0";  // part, before all else (host/part/part_transform.h)
  PartMirror part_mirror = PartMirror::kNone;
  PartUnits part_units = PartUnits::kMillimetre;
  std::string cut = "off";  // height, and the piece that is kept (host/part/cut_plane.h)
  // Several objects on the bed (host/part/plate.h).
  int copies = 1;                                // of each part
  Length part_gap = Length::from_units(60'000);  // between objects, at least
  ObjectLabels object_labels = ObjectLabels::kAuto;
  // One object after another (host/part/object_sequence.h).
  bool sequential = false;
  Length clearance_radius = Length::from_units(450'000);
  Length clearance_height = Length::from_units(200'000);
  double nozzle_celsius = 210;
  double nozzle_first_layer_celsius = 210;
  double bed_celsius = 60;
  double bed_first_layer_celsius = -1;  // negative: like the other layers

  // Cooling (cooling.h).
  bool cool_short_layers = true;
  double fan_share = 1;
  double bridge_fan_share = 1;
  double support_interface_fan_share = 0;  // 0: no difference
  std::array<double, kOverhangSteps> overhang_fan_share{1, 1, 1, 1};
  double fan_share_min = 1;
  bool fan_always_on = true;
  double fan_below_layer_time_s = 60;
  int fan_from_layer = 2;  // counted from 1
  int fan_full_layer = 0;  // counted from 1; 0: at once

  // How the filament's pressure in the nozzle follows the speed, mm of filament for mm/s of it.
  double pressure_advance_s = -1;  // negative: not told

  GcodeFlavor gcode_flavor = GcodeFlavor::kMarlin;  // of files; a print's is its controller's
  bool progress_commands = true;                    // M73 in files

  // The user's own lines.
  std::vector<std::string> start_gcode = {"G28"};
  std::vector<std::string> end_gcode = {"M84"};
  std::vector<std::string> at_height;             // "12.4 pause" (height_actions.h)
  std::vector<std::string> pause_gcode = {"M0"};  // in a file, where the print pauses
  std::string allow_gcode;  // commands that are refused unless they are named here
  Length park_lift = Length::from_units(100'000);  // nozzle off the part at the end and at a stop
  // Where the nozzle is parked then, from the bed's front left corner. Negative: near that corner.
  Length park_x = Length::from_units(-10'000);
  Length park_y = Length::from_units(-10'000);
};

// T: how many layers the wall reaches up and down: wall_layers, or ⌊w/h + ½⌋, at least 1.
[[nodiscard]] int wall_layers(const Settings& settings);

// Whether a mesh's layers above the first one may differ in height.
[[nodiscard]] bool has_unequal_layers(const Settings& settings);

// Whether the window is T layers up and T down, whatever their heights: a cylinder's, and the fast
// style's. Otherwise it is a ball's.
[[nodiscard]] bool wall_counts_layers(const Settings& settings);

// With the road's width of the first layer.
[[nodiscard]] Settings first_layer_settings(Settings settings);

[[nodiscard]] double bed_first_layer_celsius(const Settings& settings);

}  // namespace core
