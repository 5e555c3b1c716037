#include "host/settings/settings_prusa.h"

#include <doctest/doctest.h>

#include <string>

#include "host/output/thumbnail_text.h"
#include "host/settings/foreign_names.h"   // prusa_name, prusa_value
#include "host/settings/prusa_left_out.h"  // left_out_of
#include "host/settings/settings_table.h"

namespace {

std::string thumbnails_from(const std::string& list) {
  const auto ours = host::from_prusa("thumbnails", list);
  REQUIRE(ours.has_value());
  REQUIRE_EQ(ours->size(), 1);
  host::PrintSettings settings;
  REQUIRE(host::set_setting(settings, ours->front().key, ours->front().text).ok());
  REQUIRE(host::validate_settings(settings).ok());
  return settings.thumbnails;
}

}  // namespace

TEST_CASE("thumbnails are ours, but for formats and sizes that are not written") {
  CHECK_EQ(thumbnails_from("16x16/QOI, 220x124/PNG"), "16x16/QOI, 220x124/PNG");
  CHECK_EQ(thumbnails_from("16x16,220x124"), "16x16, 220x124");
  CHECK_EQ(thumbnails_from("16x16/QOI, 640x480/JPG,8x8/PNG, 313x173/QOI"),
           "16x16/QOI, 313x173/QOI");
  CHECK_EQ(thumbnails_from("640x480/COLPIC"), "");
  CHECK_EQ(thumbnails_from(""), "");
  std::string many = "32x32";
  for (std::size_t i = 0; i < host::kThumbnailsMax; ++i) many += ",32x32";
  CHECK_EQ(thumbnails_from(many).size(), host::kThumbnailsMax * 7 - 2);
  CHECK_EQ(host::from_prusa("thumbnails_format", "QOI")->front().text, "QOI");
  CHECK(host::from_prusa("thumbnails_format", "JPG")->empty());
}

TEST_CASE("what can't be a thumbnail is told with the setting's name") {
  host::PrintSettings settings;
  settings.thumbnails = "32x32, 8x8";
  const core::Status status = host::validate_settings(settings);
  REQUIRE_FALSE(status.ok());
  CHECK(status.error().message.starts_with("thumbnails: \"8x8\" is no thumbnail"));
}

TEST_CASE("a machine's limits are taken, however large its profile has them") {
  // The Jubilee's, in a bundle of PrusaSlicer 2.5.
  const auto ours = host::from_prusa("machine_max_feedrate_x", "13000,200");
  REQUIRE(ours.has_value());
  REQUIRE_EQ(ours->size(), 1);
  host::PrintSettings settings;
  REQUIRE(host::set_setting(settings, ours->front().key, ours->front().text).ok());
  CHECK(host::validate_settings(settings).ok());
  CHECK_EQ(settings.speed_max_xy_mm_s, 13'000);
}

TEST_CASE("objects one after another, by the names of all slicers") {
  struct Name {
    const char *key, *value, *ours, *text;
  };
  for (const Name& name : {Name{"complete_objects", "1", "sequential", "1"},
                           Name{"print_sequence", "by object", "sequential", "1"},
                           Name{"print_sequence", "by layer", "sequential", "0"},
                           Name{"print_sequence", "one_at_a_time", "sequential", "1"},
                           Name{"print_sequence", "all_at_once", "sequential", "0"},
                           Name{"extruder_clearance_radius", "45", "clearance_radius", "45"},
                           Name{"extruder_clearance_max_radius", "65", "clearance_radius", "65"},
                           Name{"extruder_clearance_height_to_rod", "36", "clearance_height", "36"},
                           Name{"gantry_height", "25", "clearance_height", "25"}}) {
    CAPTURE(name.key);
    const std::string key(host::prusa_name(name.key));
    const auto ours = host::from_prusa(key, host::prusa_value(name.key, name.value));
    REQUIRE(ours.has_value());
    REQUIRE_EQ(ours->size(), 1);
    CHECK_EQ(ours->front().key, name.ours);
    CHECK_EQ(ours->front().text, name.text);
    host::PrintSettings settings;
    CHECK(host::set_setting(settings, ours->front().key, ours->front().text).ok());
  }
}

TEST_CASE("names for files are without quotes, the first of several; others are left empty") {
  struct Name {
    const char *key, *value, *ours;
  };
  for (const Name& name :
       {Name{"filament_settings_id", "Generic PLA", "Generic PLA"},
        Name{"filament_settings_id", "\"A;B\";\"C\"", "A;B"},
        Name{"filament_settings_id", "A;B", "A"}, Name{"filament_settings_id", "\"\"", ""},
        Name{"filament_settings_id", "\"a \\\"b\\\"\"", "a \"b\""},
        Name{"filament_settings_id", "Süd", ""},
        Name{"filament_colour", "#112233;#445566", "#112233"},
        Name{"printer_settings_id", "Prusa; mine", "Prusa; mine"},
        Name{"printer_model", "MK3S", "MK3S"}}) {
    CAPTURE(name.value);
    const auto ours = host::from_prusa(name.key, name.value);
    REQUIRE(ours.has_value());
    REQUIRE_EQ(ours->size(), 1);
    CHECK_EQ(ours->front().text, name.ours);
    host::PrintSettings settings;
    CHECK(host::set_setting(settings, ours->front().key, ours->front().text).ok());
  }
  CHECK(host::from_prusa("printer_model", std::string(2'000, 'a'))->front().text.empty());
}

TEST_CASE("a chamber that start G-code heats is not told as left out") {
  const auto told = [](const std::string& start) {
    return host::left_out_of({{"chamber_temperature", "45"}, {"start_gcode", start}}).size();
  };
  CHECK_EQ(told("G28\\nM191 S[chamber_temperature]"), 0);
  CHECK_EQ(told("PRINT_START CHAMBER=[chamber_temperature]"), 0);
  CHECK_EQ(told("G28"), 1);
  CHECK_EQ(host::left_out_of({{"chamber_temperature", "45"}}).size(), 1);
  CHECK_EQ(host::left_out_of({{"chamber_temperature", "0"}}).size(), 0);
}
