// OrcaSlicer's and Bambu Studio's profiles, Cura's, and those in archives.
#include "host/settings/profile_json.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "host/settings/profile_report.h"
#include "host/settings/whole_settings.h"
#include "tests/support/mesh_files.h"
#include "tests/support/temporary_folder.h"

using host::ProfileGroup;
using Lines = std::vector<std::string>;

namespace {

constexpr const char* kCommon = R"({"type": "machine", "name": "common", "nozzle_diameter": ["0.4"],
  "gcode_flavor": "klipper", "printable_height": "250", "retraction_length": ["0.8"],
  "machine_end_gcode": "PRINT_END"})";
constexpr const char* kMachine =
    R"({"type": "machine", "name": "Box 0.4", "inherits": "common",
  "printable_area": ["0x0", "250x0", "250x210", "0x210"], "default_print_profile": "0.20mm Box",
  "default_filament_profile": ["Box PLA"],
  "machine_start_gcode": "G28 ; home\nM140 S[bed_temperature_initial_layer_single]\n)"
    R"(M104 S{nozzle_temperature_initial_layer[0]}\n)"
    R"({if nozzle_temperature[0] > 210}M117 {filament_type[0]}{endif}"})";
constexpr const char* kProcess =
    R"json({"type": "process", "name": "0.20mm Box", "layer_height": "0.2",
  "initial_layer_print_height": "0.25", "wall_loops": "3", "sparse_infill_density": "15%",
  "sparse_infill_pattern": "crosshatch", "outer_wall_speed": "50", "brim_type": "auto_brim",
  "brim_width": "5", "enable_support": "1", "support_type": "tree(auto)", "line_width": "105%",
  "ironing_type": "no ironing", "detect_thin_wall": "1"})json";
constexpr const char* kFilament = R"({"type": "filament", "name": "Box PLA",
  "nozzle_temperature": ["215"], "nozzle_temperature_initial_layer": ["220"],
  "hot_plate_temp": ["60"], "hot_plate_temp_initial_layer": ["65"], "filament_type": ["PLA"],
  "filament_flow_ratio": ["0.98"], "filament_z_hop": ["0.6"],
  "filament_start_gcode": ["M900 K0.03"]})";

// Folders as OrcaSlicer has them.
struct Vendor {
  test::TemporaryFolder folder;
  std::string machine;

  Vendor() {
    for (const char* name : {"machine", "process", "filament"}) {
      std::filesystem::create_directory(folder.path(name));
    }
    folder.write("machine/common.json", kCommon);
    machine = folder.write("machine/Box.json", kMachine);
    folder.write("process/0.20mm Box.json", kProcess);
    folder.write("filament/Box PLA.json", kFilament);
  }
};

host::WholeSettings whole(const std::string& path, const std::string& quality = {}) {
  host::SettingsRequest request{path, false, {}};
  request.printer.printer = "none";
  request.printer.quality = quality;
  auto result = host::whole_settings(request);
  if (!result.ok()) FAIL(result.error().message);
  return std::move(result).value();
}

std::string refusal(const std::string& path) {
  host::SettingsRequest request{path, false, {}};
  request.printer.printer = "none";
  const auto result = host::whole_settings(request);
  return result.ok() ? "" : result.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE("\"" << part << "\" is missing in: " << text);
  return found;
}

ProfileGroup group_of(const host::WholeSettings& settings, const std::string& key) {
  for (const host::ProfileRow& row : host::report_of(*settings.profile)) {
    if (row.key == key) return row.group;
  }
  FAIL(key << " is in no group");
  return ProfileGroup::kTaken;
}

}  // namespace

TEST_CASE("OrcaSlicer: a printer, what it inherits, its print and its filament") {
  const Vendor vendor;
  const host::WholeSettings all = whole(vendor.machine);
  const host::PrintSettings& settings = all.settings;
  CHECK_EQ(settings.bed_y.mm(), 210);
  CHECK_EQ(settings.printer_name, "Box 0.4");
  CHECK_EQ(settings.filament_name, "Box PLA");
  CHECK_EQ(settings.axis_z.mm(), 250);
  CHECK(settings.gcode_flavor == core::GcodeFlavor::kKlipper);
  CHECK_EQ(settings.first_layer_height.mm(), 0.25);
  CHECK_EQ(settings.road_width.mm(), doctest::Approx(0.42));
  CHECK_EQ(settings.perimeters, 3);
  CHECK_EQ(settings.loose_density, doctest::Approx(0.15));
  CHECK_EQ(settings.extrusion_multiplier, doctest::Approx(0.98));
  CHECK_EQ(settings.nozzle_first_layer_celsius, 220);
  CHECK_EQ(settings.bed_first_layer_celsius, 65);
  CHECK_EQ(settings.retraction_mm, 0.8);
  CHECK_EQ(settings.retraction_lift.mm(), 0.6);
  CHECK(settings.support_style == core::SupportStyle::kTree);
  CHECK_EQ(settings.brim_width, core::Length());
  CHECK_FALSE(settings.ironing);
  CHECK(settings.start_gcode == Lines{"G28", "M140 S65", "M104 S220", "M117 PLA"});
  CHECK(settings.end_gcode == Lines{"PRINT_END"});
  CHECK(group_of(all, "sparse_infill_pattern") == ProfileGroup::kChanges);
  CHECK(group_of(all, "brim_type") == ProfileGroup::kChanges);
  CHECK(group_of(all, "filament_start_gcode") == ProfileGroup::kChanges);
  CHECK(group_of(all, "detect_thin_wall") == ProfileGroup::kNotSupported);
  CHECK(group_of(all, "name") == ProfileGroup::kNoMeaning);
}

TEST_CASE("OrcaSlicer: another print, and files that are not there") {
  const Vendor vendor;
  const std::string own =
      vendor.folder.write("thin.json", R"({"type": "process", "layer_height": "0.1"})");
  CHECK_EQ(whole(vendor.machine, own).settings.layer_height.mm(), 0.1);
  host::SettingsRequest missing{vendor.machine, false, {}};
  missing.printer.filament = "Wood";
  const auto refused = host::whole_settings(missing);
  REQUIRE_FALSE(refused.ok());
  CHECK(contains(refused.error().message, "--filament \"Wood\": there is no such file"));
  std::filesystem::remove(vendor.folder.path("machine/common.json"));
  CHECK(contains(refusal(vendor.machine), "inherits \"common\", but common.json is neither"));
  std::filesystem::remove(vendor.folder.path("process/0.20mm Box.json"));
  vendor.folder.write("machine/common.json", R"({"inherits": "Box", "type": "machine"})");
  CHECK(contains(refusal(vendor.machine), "or from itself"));
  CHECK(contains(refusal(vendor.folder.write("bad.json", "{\"type\": ")), "is not valid JSON"));
  CHECK(contains(refusal(vendor.folder.write("other.json", "{\"a\": 1}")), "no profile of Orca"));
  const std::string deep = "{\"type\": " + std::string(100'000, '[') + "}";
  CHECK(contains(refusal(vendor.folder.write("deep.json", deep)), "is not valid JSON"));
}

TEST_CASE("Cura: a definition, its expressions and its placeholders") {
  const test::TemporaryFolder folder;
  folder.write("base.def.json",
               R"({"version": 2, "inherits": "fdmprinter", "metadata": {}, "overrides": {
    "machine_start_gcode": {"default_value":
      "G28 ;home\nM109 S{material_print_temperature_layer_0}\nG1 X{machine_width, 0} [x]"},
    "machine_end_gcode": {"value": "'M84'"}, "machine_width": {"default_value": 200},
    "machine_depth": {"value": "machine_width + 20"},
    "material_print_temperature_layer_0": {"value": "material_print_temperature + 5"},
    "material_print_temperature": {"default_value": 200},
    "wall_line_count": {"value": "2 if a else 3"},
    "infill_sparse_density": {"default_value": 15}, "support_angle": {"value": 50},
    "support_enable": {"default_value": true},
    "unknown_thing": {"value": "a + b"}}})");
  const std::string one =
      folder.write("one.def.json", R"({"version": 2, "inherits": "base", "metadata": {},
    "overrides": {"machine_shape": {"default_value": "elliptic"}, 
    "brim_width": {"default_value": 8},
    "machine_center_is_zero": {"default_value": true},
    "adhesion_type": {"default_value": "skirt"}}})");
  const host::WholeSettings all = whole(one);
  CHECK_EQ(all.settings.bed_shape.size(), 72);
  CHECK_EQ(all.settings.bed_x.mm(), 200);
  CHECK_EQ(all.settings.bed_y.mm(), 220);
  CHECK_EQ(all.settings.bed_origin_x.mm(), -100);
  CHECK_EQ(all.settings.nozzle_first_layer_celsius, 205);
  CHECK_EQ(all.settings.loose_density, doctest::Approx(0.15));
  CHECK_EQ(all.settings.overhang_angle_degrees, 50);
  CHECK_EQ(all.settings.brim_width, core::Length());
  CHECK(all.settings.start_gcode == Lines{"G28", "M109 S205", "G1 X200 [x]"});
  CHECK(all.settings.end_gcode == Lines{"M84"});
  CHECK(group_of(all, "wall_line_count") == ProfileGroup::kChanges);
  CHECK(group_of(all, "unknown_thing") == ProfileGroup::kNotSupported);
  CHECK(group_of(all, "machine_shape") == ProfileGroup::kTaken);
  const std::string lost =
      folder.write("lost.def.json", R"({"inherits": "nobody", "overrides": {}})");
  CHECK(contains(refusal(lost), "inherits \"nobody\", but nobody.def.json is not beside it"));
  const std::string unknown =
      folder.write("unknown.def.json",
                   R"({"overrides": {"machine_end_gcode": {"default_value": "M84 {nothing}"}}})");
  CHECK(contains(refusal(unknown), "{nothing}: nothing stands for nothing"));
}

TEST_CASE("Cura: settings of a print") {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("fine.inst.cfg",
                   "[general]\nversion = 4\nname = fine\n\n[metadata]\ntype = quality\n\n"
                   "[values]\nlayer_height = 0.1\nwall_line_count = =2 + 1\n"
                   "speed_infill = =speed_print\nretraction_hop = 0.4\n");
  const host::WholeSettings all = whole(path);
  CHECK_EQ(all.settings.layer_height.mm(), 0.1);
  CHECK_EQ(all.settings.perimeters, 3);
  CHECK_EQ(all.settings.retraction_lift.mm(), 0.4);
  CHECK(group_of(all, "speed_infill") == ProfileGroup::kChanges);
}

TEST_CASE("the settings in an archive are those of the file that they would be") {
  const test::TemporaryFolder folder;
  const std::string prusa = folder.write(
      "prusa.3mf",
      test::zip_file({{"3D/3dmodel.model", "<model/>"},
                      {"Metadata/Slic3r_PE.config",
                       "; generated by PrusaSlicer 2.5.0 on 2023-01-01 at 10:00:00 UTC\n\n"
                       "; bed_shape = 50x0,0x50,-50x0,0x-50\n; layer_height = 0.15\n"
                       "; start_gcode = G28 ; home\\nM104 S[first_layer_temperature]\n"
                       "; first_layer_temperature = 215\n"}}));
  const host::WholeSettings of_prusa = whole(prusa);
  CHECK_EQ(of_prusa.settings.layer_height.mm(), 0.15);
  CHECK_EQ(of_prusa.settings.bed_shape.size(), 4);
  CHECK(of_prusa.settings.start_gcode == Lines{"G28", "M104 S215"});
  const std::string bambu = folder.write(
      "bambu.3mf",
      test::zip_file({{"Metadata/project_settings.config",
                       R"({"layer_height": "0.28", "printable_area": ["0x0", "256x0", "256x256",
                          "0x256"], "wall_loops": "4", "inherits_group": ["", ""]})"}}));
  CHECK_EQ(whole(bambu).settings.perimeters, 4);
  CHECK_EQ(whole(bambu).settings.bed_x.mm(), 256);
  const std::string cura = folder.write(
      "a.curaprofile",
      test::zip_file({{"machine", "[general]\nname = a\n\n[values]\nlayer_height = 0.3\n"},
                      {"extruder", "[general]\nname = b\n\n[values]\nspeed_infill = 55\n"}}));
  CHECK_EQ(whole(cura).settings.layer_height.mm(), 0.3);
  CHECK_EQ(whole(cura).settings.loose_speed_mm_s, 55);
  const std::string none =
      folder.write("none.3mf", test::zip_file({{"3D/3dmodel.model", "<model/>"}}));
  CHECK(contains(refusal(none), "holds no settings of a slicer that rind knows"));
  CHECK_FALSE(refusal(folder.write("cut.3mf", "PK\x03\x04 cut")).empty());
}
