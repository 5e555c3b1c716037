#include "host/settings/profile_bundle.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "host/settings/profile_report.h"
#include "host/settings/settings_file.h"

using host::LoadedSettings;
using host::ProfileChoice;

namespace {

constexpr const char* kBundle = R"(# a vendor's printers
[vendor]
name = Small Machines

[printer_model:TINY]
name = Tiny && Tiny+
variants = 0.4; 0.25
[printer_model:BIG]
name = Big
variants = 0.6

[printer:*common*]
printer_technology = FFF
gcode_flavor = marlin
bed_shape = 0x0,100x0,100x90,0x90
max_print_height = 100
nozzle_diameter = 0.4
start_gcode = M862.3 P "[printer_model]"\nG28\nM104 S[first_layer_temperature]
end_gcode = M84
printer_notes = first\nMODEL_COMMON\nlast

[printer:*round*]
bed_shape = 50x0,0x50,-50x0,0x-50

[printer:Tiny with a name of more than fifty bytes, as inih cuts it 0.25 nozzle]
inherits = *common*
printer_model = TINY
printer_variant = 0.25
nozzle_diameter = 0.25
default_print_profile = 0.10mm

[printer:Tiny & Tiny+]
inherits = *common*
printer_model = TINY
printer_variant = 0.4
default_print_profile = 0.20mm
default_filament_profile = "Soft; old";"Hard"

[printer:Big 0.6]
inherits = *common*; *round*
printer_model = BIG
printer_variant = 0.6
nozzle_diameter = 0.6
default_print_profile = no such

[print:*base*]
perimeters = 2
layer_height = 0.2
first_layer_height = 75%
perimeter_speed = 50
external_perimeter_speed = 50%
top_solid_layers = 5
thin_walls = 1
compatible_printers_condition = nozzle_diameter[0]==0.4 and printer_notes=~/.*MODEL_COMMON.*/
[print:0.20mm]
inherits = *base*
[print:0.10mm]
inherits = *base*
perimeters = 4
layer_height = 0.1
compatible_printers_condition =
[print:0.30mm thick]
inherits = 0.20mm
extrusion_width = 0
layer_height = 0.3
compatible_printers_condition = nozzle_diameter[0]>0.4

[filament:Soft]
temperature = 200
first_layer_temperature = 205
compatible_printers_condition = nozzle_diameter[0]!=0.6
[filament:Hard]
inherits = Soft
first_layer_temperature = 245
filament_retract_length = 2.5
filament_wipe = nil
compatible_printers_condition = num_extruders==1
)";

LoadedSettings loaded(const ProfileChoice& choice) {
  const auto result = host::read_settings(kBundle, "b.ini", host::PrintSettings(), choice);
  if (!result.ok()) FAIL(result.error().message);
  return result.value();
}

std::string refusal(const std::string& text, const ProfileChoice& choice) {
  const auto result = host::read_settings(text, "b.ini", host::PrintSettings(), choice);
  REQUIRE_FALSE(result.ok());
  return result.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE("\"" << part << "\" is missing in: " << text);
  return found;
}

}  // namespace

TEST_CASE("a printer with what it inherits, its print and its filament") {
  for (const char* name : {"Tiny & Tiny+", "TINY"}) {
    CAPTURE(name);
    const LoadedSettings tiny = loaded({name, "", "Hard"});
    CHECK_EQ(tiny.settings.bed_y.mm(), 90);
    CHECK_EQ(tiny.settings.layer_height.mm(), 0.2);
    CHECK_EQ(tiny.settings.first_layer_height.mm(), doctest::Approx(0.15));
    CHECK_EQ(tiny.settings.outer_perimeter_speed_mm_s, 25);
    CHECK_EQ(tiny.settings.nozzle_first_layer_celsius, 245);
    CHECK_EQ(tiny.settings.nozzle_celsius, 200);
    CHECK_EQ(tiny.settings.retraction_mm, 2.5);
    REQUIRE_EQ(tiny.chosen.size(), 1);
    CHECK(
        contains(tiny.chosen[0], "printer \"Tiny & Tiny+\", print \"0.20mm\", filament \"Hard\""));
    CHECK_EQ(tiny.values.at("printer_model"), "TINY");
    CHECK_EQ(tiny.values.at("print_settings_id"), "0.20mm");
  }
  // Its default filament is not there: the first one that is made for it.
  CHECK(contains(loaded({"TINY", "", ""}).chosen[0], "filament \"Soft\""));
  const LoadedSettings fine =
      loaded({"Tiny with a name of more than fifty bytes, as inih cuts it 0.25 nozzle", "", ""});
  CHECK_EQ(fine.settings.perimeters, 4);
  CHECK_EQ(fine.settings.nozzle_diameter.mm(), 0.25);
}

TEST_CASE("of several parents the last one wins, and without a default the first that fits") {
  const LoadedSettings big = loaded({"Big", "", ""});
  CHECK_EQ(big.settings.bed_shape.size(), 4);
  CHECK_EQ(big.settings.bed_x.mm(), 100);
  CHECK_EQ(big.settings.bed_origin_x.mm(), -50);
  CHECK(contains(big.chosen[0], "print \"0.10mm\", filament \"Hard\""));
  const LoadedSettings thick = loaded({"BIG", "0.30mm thick", "Soft"});
  CHECK_EQ(thick.settings.layer_height.mm(), 0.3);
  CHECK_EQ(thick.settings.road_width.mm(), doctest::Approx(0.675));
}

TEST_CASE("what can't be chosen is refused with what can") {
  CHECK(contains(refusal(kBundle, {}),
                 "b.ini: is a bundle of 3 printers; choose one by --printer: "));
  CHECK(contains(refusal(kBundle, {"tiny", "", ""}), "no printer \"tiny\"; there are \"Tiny with"));
  CHECK(contains(refusal(kBundle, {"*common*", "", ""}), "no printer"));
  CHECK(contains(refusal(kBundle, {"TINY", "0.5mm", ""}),
                 "--quality \"0.5mm\": there is no such print profile; for this printer there are "
                 "\"0.20mm\", \"0.10mm\""));
  CHECK(contains(refusal(kBundle, {"TINY", "", "Wood"}), "--filament \"Wood\""));
  CHECK(contains(refusal("[printer:A]\ninherits = B\n", {"A", "", ""}), "no section [printer:B]"));
  CHECK(contains(refusal("[printer:A]\ninherits = A\n", {"A", "", ""}), "from itself"));
  CHECK(contains(refusal("[print:A]\nperimeters = 2\n", {"A", "", ""}), "without a printer"));
  CHECK(contains(refusal("[printer:A]\nprinter_technology = SLA\n", {"A", "", ""}), "resin"));
  CHECK(contains(refusal("perimeters = 3\n", {"", "fine", ""}), "nothing to choose by --quality"));
  // PrusaSlicer's own bed, where a printer has none, and no print at all.
  const auto bare = host::read_settings("[printer:A]\nnozzle_diameter = 0.4\n", "b.ini",
                                        host::PrintSettings(), {"A", "", ""});
  REQUIRE(bare.ok());
  CHECK_EQ(bare.value().settings.bed_x.mm(), 200);
  CHECK(contains(bare.value().chosen[1], "no print profile is made for A"));
}

TEST_CASE("each setting is in one group of the report") {
  const LoadedSettings tiny = loaded({"TINY", "", "Hard"});
  const auto rows = host::report_of(tiny);
  const auto group = [&](const std::string& key) {
    const auto is = [&key](const host::ProfileRow& row) { return row.key == key; };
    CAPTURE(key);
    REQUIRE_EQ(std::count_if(rows.begin(), rows.end(), is), 1);
    return std::string(host::group_name(std::find_if(rows.begin(), rows.end(), is)->group));
  };
  CHECK_EQ(group("layer_height"), "taken");
  CHECK_EQ(group("start_gcode"), "taken");
  CHECK_EQ(group("bed_shape"), "taken");
  CHECK_EQ(group("filament_retract_length"), "taken");
  CHECK_EQ(group("top_solid_layers"), "changes the print");
  CHECK_EQ(group("thin_walls"), "not supported");
  CHECK_EQ(group("printer_notes"), "of no meaning here");
  CHECK_EQ(group("filament_wipe"), "of no meaning here");
  for (const auto& [key, value] : tiny.values) group(key);
  const std::string text = host::text_of(rows);
  CHECK(
      contains(text, "#   external_perimeter_speed = 50%  ->  outer_perimeter_speed_mm_s = 25\n"));
  CHECK(contains(text, "# not supported: 1\n"));
  CHECK(contains(host::counts_of(rows), " 1 are not supported"));
}
