#include "host/settings/settings_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/limits.h"
#include "host/settings/settings_text.h"
#include "tests/support/random_regions.h"

using core::Length;
using Settings = host::PrintSettings;
using host::set_setting;
using host::SettingRow;

namespace {

std::string error_of(const core::Status& status) {
  REQUIRE_FALSE(status.ok());
  CHECK_EQ(status.error().code, core::ErrorCode::kBadSetting);
  return status.error().message;
}

std::string error_of(const std::string& key, const std::string& text) {
  Settings settings;
  const std::string message = error_of(set_setting(settings, key, text));
  // After an error everything is as it was.
  const std::vector<SettingRow> rows = host::describe_settings(settings);
  for (const SettingRow& row : rows) CHECK_EQ(row.value, row.default_value);
  return message;
}

bool contains(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE("\"" << part << "\" is missing in: " << text);
  return found;
}

Settings set_to(const std::string& key, const std::string& text) {
  Settings settings;
  const core::Status status = set_setting(settings, key, text);
  if (!status.ok()) FAIL(status.error().message);
  return settings;
}

// The smallest and largest number in a range "a … b unit".
std::pair<double, double> ends_of(const SettingRow& row) {
  std::smatch match;
  REQUIRE(std::regex_search(row.range, match, std::regex("^(\\S+) … (\\S+)")));
  return {std::stod(match[1]), std::stod(match[2])};
}

// The fields of the structure of settings in a header, in their order.
std::vector<std::string> fields_in(const std::string& path) {
  std::ifstream header(std::string(RIND_SOURCE_DIR) + "/" + path);
  REQUIRE(header.good());
  const std::regex field(
      "^  "
      "(?:double|int|bool|[A-Z][A-Za-z]+|std::string|std::vector<std::string>|std::vector<Point>|"
      "std::array<double, kOverhangSteps>) "
      "([a-z0-9_]+)(?: = .*|\\{.*\\})?(?:;.*)?$");
  std::vector<std::string> fields;
  for (std::string line; std::getline(header, line);) {
    std::smatch match;
    if (std::regex_match(line, match, field)) fields.push_back(match[1]);
  }
  return fields;
}

bool has_number(const SettingRow& row) { return row.range.find("…") != std::string::npos; }

}  // namespace

TEST_CASE("every field of a print's settings has its row, in the same order") {
  const std::vector<std::string> of_part = fields_in("core/settings.h");
  const std::vector<std::string> of_link = fields_in("host/pipeline/print_settings.h");
  CHECK_GE(of_part.size(), 43);
  CHECK_EQ(of_link.size(), 5);
  std::vector<std::string> part_keys, link_keys;
  for (const SettingRow& row : host::describe_settings(Settings())) {
    const bool is_of_link = std::find(of_link.begin(), of_link.end(), row.key) != of_link.end();
    (is_of_link ? link_keys : part_keys).push_back(row.key);
    CHECK_FALSE(row.help.empty());
    CHECK_FALSE(row.range.empty());
  }
  CHECK_EQ(part_keys, of_part);
  CHECK_EQ(link_keys, of_link);
}

TEST_CASE("the defaults are in range, fit together, and read back") {
  CHECK(host::validate_settings(Settings()).ok());
  for (const SettingRow& row : host::describe_settings(Settings())) {
    CAPTURE(row.key);
    Settings settings;
    CHECK(set_setting(settings, row.key, row.default_value).ok());
    CHECK_EQ(row.value, row.default_value);
  }
}

TEST_CASE("what describe_settings writes, set_setting reads back") {
  constexpr unsigned kSeed = 7;
  CAPTURE(kSeed);
  test::Random random(kSeed);
  Settings settings;
  for (const SettingRow& row : host::describe_settings(Settings())) {
    if (!has_number(row)) continue;
    const auto [min, max] = ends_of(row);
    const bool whole = row.unit.empty();
    for (int i = 0; i < 20; ++i) {
      const double value = random.between(min, max);
      const std::string text = host::write_number(whole ? std::floor(value) : value);
      CAPTURE(row.key);
      CAPTURE(text);
      REQUIRE(set_setting(settings, row.key, text).ok());
    }
  }
  REQUIRE(set_setting(settings, "start_gcode", "M117 a\\\\b\\nG28 X ; home\\n\\n ;only\\nG1").ok());
  CHECK_EQ(settings.start_gcode, std::vector<std::string>{"M117 a\\b", "G28 X", "G1"});
  Settings again;
  for (const SettingRow& row : host::describe_settings(settings)) {
    REQUIRE(set_setting(again, row.key, row.value).ok());
  }
  const auto first = host::describe_settings(settings), second = host::describe_settings(again);
  for (std::size_t i = 0; i < first.size(); ++i) CHECK_EQ(first[i].value, second[i].value);
  CHECK_EQ(settings.start_gcode, again.start_gcode);
  CHECK_EQ(settings.bed_x, again.bed_x);
}

TEST_CASE("a word stands for a number that is not meant as one, and is written instead of it") {
  const auto row_of = [](const Settings& settings, const std::string& key) {
    for (const SettingRow& row : host::describe_settings(settings)) {
      if (row.key == key) return row;
    }
    FAIL(key);
    return SettingRow();
  };
  CHECK_EQ(set_to("segment_time_min_ms", "auto").segment_time_min_ms, 0);
  CHECK_EQ(set_to("segment_time_min_ms", " off ").segment_time_min_ms, 0.001);
  CHECK_EQ(set_to("wall_layers", "auto").wall_layers, 0);
  CHECK_EQ(set_to("axis_z", "off").axis_z, core::Length());
  CHECK(contains(error_of("axis_z", "auto"), "0 … 1000000000 mm, off"));
  for (const char* text : {"off", "0.001"}) {
    const SettingRow row = row_of(set_to("segment_time_min_ms", text), "segment_time_min_ms");
    CHECK_EQ(row.value, "off");
    CHECK_EQ(row.plain_value, "0.001");
    CHECK_EQ(row.default_value, "auto");
  }
  CHECK_EQ(row_of(set_to("segment_time_min_ms", "2"), "segment_time_min_ms").value, "2");
}

TEST_CASE(
    "both ends of every range are in it, and what lies beyond is refused with range and unit") {
  for (const SettingRow& row : host::describe_settings(Settings())) {
    if (!has_number(row)) continue;
    CAPTURE(row.key);
    const auto [min, max] = ends_of(row);
    Settings settings;
    CHECK(set_setting(settings, row.key, host::write_number(min)).ok());
    CHECK(set_setting(settings, row.key, host::write_number(max)).ok());
    const double step = row.unit.empty() ? 1 : 1e-5;
    for (const double value : {min - step, max + std::max(step, max * 1e-9)}) {
      const std::string message = error_of(row.key, host::write_number(value));
      CHECK(contains(message, row.key));
      CHECK(contains(message, row.range));
      if (row.unit == "mm") CHECK(contains(message, " mm"));
    }
    for (const char* text :
         {"nan", "inf", "-inf", "1e999", "-1e999", "99999999999999999999999",
          "-99999999999999999999999", "", " ", "x", "1x", "0x10", "1,5", "--1", "+-1", "1 2"}) {
      CAPTURE(text);
      CHECK(contains(error_of(row.key, text), row.key));
    }
  }
}

TEST_CASE("numbers as users write them") {
  CHECK_EQ(set_to("layer_height", "0.1").layer_height, Length::from_units(1'000));
  CHECK_EQ(set_to("layer-height", " +0.15 mm ").layer_height, Length::from_units(1'500));
  CHECK_EQ(set_to("layer_height", "1e-1").layer_height, Length::from_units(1'000));
  CHECK_EQ(set_to("loose_density", "15%").loose_density, doctest::Approx(0.15));
  CHECK_EQ(set_to("loose_density", "0.15").loose_density, doctest::Approx(0.15));
  CHECK_EQ(set_to("nozzle_celsius", "215 °C").nozzle_celsius, 215);
  CHECK_EQ(set_to("travel_speed_mm_s", "150mm/s").travel_speed_mm_s, 150);
  CHECK_EQ(set_to("perimeters", "+3").perimeters, 3);
  for (const char* no : {"0", "false", "No", "OFF"}) CHECK_FALSE(set_to("centre", no).centre);
  for (const char* yes : {"1", "TRUE", "yes", "on"}) CHECK(set_to("centre", yes).centre);
  CHECK_EQ(set_to("wall_shape", "cylinder").wall_shape, core::WallShape::kCylinder);
  CHECK_EQ(set_to("wall_shape", " ball ").wall_shape, core::WallShape::kBall);
  CHECK_EQ(set_to("style", "regular").style, core::BuildStyle::kRegular);
  CHECK_EQ(set_to("style", "fast").style, core::BuildStyle::kFast);
}

TEST_CASE("an error says what was read") {
  CHECK(contains(error_of("layer_height", "0,2"), "but \",2\" follows"));
  CHECK(contains(error_of("layer_height", "0.2 inch"), "\"inch\""));
  CHECK(contains(error_of("layer_height", "thin"), "\"thin\" is not a number"));
  CHECK(contains(error_of("layer_height", ""), "missing"));
  CHECK(contains(error_of("layer_height", "1e999"), "beyond what a number can hold"));
  CHECK(contains(error_of("perimeters", "2.5"), "\"2.5\" is not a whole number"));
  CHECK(contains(error_of("perimeters", "3%"), "\"3%\" is not a whole number"));
  CHECK(contains(error_of("loose_density", "20"), "0% … 100%"));
  CHECK(contains(error_of("fill_density", "15"), "fill_density: loose_density = 15"));
  CHECK(contains(error_of("fill_density", "15"), "write 15%"));
  CHECK(contains(error_of("wall_shape", "cube"), "\"cube\" is not one of: ball, cylinder"));
  CHECK(contains(error_of("centre", "maybe"), "\"maybe\""));
  CHECK(contains(error_of("road_width", "50%"), "\"%\""));
}

TEST_CASE("an unknown key names the nearest known one") {
  CHECK(contains(error_of("layer_heigth", "0.2"), "\"layer_height\""));
  CHECK(contains(error_of("wallthickness", "1"), "\"wall_thickness\""));
  CHECK(contains(error_of("perimeter", "1"), "\"perimeters\""));
  CHECK(contains(error_of("fil_density", "1"), "\"fill_density\""));
  CHECK(contains(error_of("", "1"), "there is no setting \"\""));
  CHECK(contains(error_of("suport_material", "1"), "\"support_material\""));
  CHECK(contains(error_of("draft_sheild", "1"), "PrusaSlicer's \"draft_shield\""));
  CHECK(contains(error_of("draft_shield", "1"), "that rind does not have"));
  CHECK(contains(error_of("walls", "2"), "\"perimeters\""));
  CHECK(contains(error_of("infill", "20%"), "\"loose_density\""));
  // What is near nothing names nothing.
  for (const std::string& far : {std::string("foo"), std::string("x"), std::string(3'000, 'x')}) {
    CHECK_EQ(error_of(far, "1").find("nearest"), std::string::npos);
  }
}

TEST_CASE("G-code that the link could not send is refused") {
  CHECK(contains(error_of("start_gcode", std::string(host::kVerbatimBytesMax + 1, 'G')), "bytes"));
  CHECK_EQ(set_to("start_gcode", std::string(host::kVerbatimBytesMax, 'G')).start_gcode.size(), 1);
  CHECK(contains(error_of("start_gcode", "G28\\nM117 gr\xc3\xbc\xc3\x9f"), "line 2"));
  std::string many;
  for (std::size_t i = 0; i <= host::kVerbatimLinesMax; ++i) many += "G4\\n";
  CHECK(contains(error_of("start_gcode", many), "lines"));
  CHECK(set_to("start_gcode", "").start_gcode.empty());
  CHECK(host::is_gcode_setting("start_gcode"));
  CHECK_FALSE(host::is_gcode_setting("layer_height"));
}

TEST_CASE("PrusaSlicer's keys of the same meaning") {
  CHECK_EQ(set_to("extrusion_width", "0.5").road_width, Length::from_units(5'000));
  CHECK_EQ(set_to("fill_density", "35%").loose_density, doctest::Approx(0.35));
  CHECK_EQ(set_to("temperature", "205,200").nozzle_celsius, 205);
  CHECK_EQ(set_to("max_fan_speed", "80").fan_share, doctest::Approx(0.8));
  CHECK_EQ(set_to("disable_fan_first_layers", "3").fan_from_layer, 4);
  const Settings bed = set_to("bed_shape", "0x0,250x0,250x210,0x210");
  CHECK_EQ(bed.bed_x.mm(), 250);
  CHECK_EQ(bed.bed_y.mm(), 210);
  CHECK(contains(error_of("extrusion_width", "0"), "no counterpart"));
  CHECK(contains(error_of("extrusion_width", "105%"), "no counterpart"));
  CHECK(contains(error_of("first_layer_speed", "50%"), "no counterpart"));
  CHECK(contains(error_of("extrusion_width", "wide"), "\"wide\" is not a number"));
  const Settings centred = set_to("bed_shape", "-100x-90,100x-90,100x90,-100x90");
  CHECK_EQ(centred.bed_x.mm(), 200);
  CHECK_EQ(centred.bed_y.mm(), 180);
  CHECK_EQ(centred.bed_origin_x.mm(), -100);
  CHECK_EQ(centred.bed_origin_y.mm(), -90);
  CHECK_EQ(set_to("min_print_speed", "0").slowed_speed_min_mm_s, doctest::Approx(0.1));
  CHECK_EQ(set_to("extrusion_multiplier", "1.05").extrusion_multiplier, doctest::Approx(1.05));
  CHECK(set_to("external_perimeters_first", "1").outer_perimeter_first);
  CHECK_EQ(set_to("bridge_speed", "45").bridge_speed_mm_s, 45);
  CHECK_EQ(set_to("bridge_speed", "45").internal_bridge_speed_mm_s, 45);
  CHECK_EQ(set_to("bridge_speed", "45").overhang_speed_mm_s, std::array<double, 4>{0, 0, 45, 45});
  CHECK_EQ(set_to("bridge_flow_ratio", "0.9").bridge_flow, doctest::Approx(0.9));
  CHECK_EQ(set_to("bridge_flow_ratio", "0.9").internal_bridge_flow, doctest::Approx(0.9));
  CHECK_EQ(set_to("bridge_fan_speed", "80").bridge_fan_share, doctest::Approx(0.8));
  CHECK_EQ(set_to("bridge_fan_speed", "80").overhang_fan_share,
           std::array<double, 4>{0, 0, 0.8, 0.8});
  CHECK_EQ(set_to("small_perimeter_speed", "15").small_perimeter_speed_mm_s, 15);
  CHECK_EQ(set_to("filament_max_volumetric_speed", "11").volumetric_speed_max_mm3_s, 11);
  CHECK_EQ(set_to("max_volumetric_speed", "0").volumetric_speed_max_mm3_s, 0);
  CHECK_EQ(set_to("default_acceleration", "1000").default_acceleration_mm_s2, 1'000);
  CHECK_EQ(set_to("external_perimeter_acceleration", "0").outer_perimeter_acceleration_mm_s2, 0);
  CHECK_EQ(set_to("infill_acceleration", "900").loose_acceleration_mm_s2, 900);
  CHECK_EQ(set_to("filament_shrinkage_compensation_xy", "0.4%").shrinkage_xy,
           doctest::Approx(0.004));
  CHECK_FALSE(set_to("cooling", "0").fan_always_on);
  CHECK_FALSE(set_to("cooling", "0").cool_short_layers);
  for (const char* shape : {"round", "0x0,5x5,5x0,0x5", "1x", "0x0,nanx0,nanxnan,0xnan"}) {
    CAPTURE(shape);
    CHECK(contains(error_of("bed_shape", shape), "expected rectangle, or 3 to 1000 corners"));
  }
  CHECK(contains(error_of("bed_shape", "0x0,250x0,250x0.5,0x0.5"), "bed_y"));
}

TEST_CASE("a setting of four steps takes four numbers, or one for all") {
  CHECK_EQ(set_to("overhang_speed_mm_s", "50").overhang_speed_mm_s,
           std::array<double, 4>{50, 50, 50, 50});
  const Settings steps = set_to("overhang_speed_mm_s", " 60, 45.5,30 mm/s,0 ");
  CHECK_EQ(steps.overhang_speed_mm_s, std::array<double, 4>{60, 45.5, 30, 0});
  CHECK_EQ(set_to("overhang_fan_share", "10%,20%,0.3,1").overhang_fan_share,
           std::array<double, 4>{0.1, 0.2, 0.3, 1});
  for (const char* wrong :
       {"60,45", "60,45,30", "60,45,30,20,10", "60,,30,20", "", "a", "-1", "60,45,30,3000"}) {
    CAPTURE(wrong);
    CHECK(contains(error_of("overhang_speed_mm_s", wrong), "overhang_speed_mm_s"));
  }
}

TEST_CASE("settings that do not fit together") {
  const auto message_with = [](auto change) {
    Settings settings;
    change(settings);
    return error_of(host::validate_settings(settings));
  };
  using core::kWallLayersMax;
  const Length most = Settings().layer_height * kWallLayersMax;
  Settings thickest;
  thickest.wall_thickness = most;
  CHECK(host::validate_settings(thickest).ok());
  CHECK(contains(message_with([&](Settings& s) { s.wall_thickness = most + s.layer_height; }),
                 "is 65 layers"));
  CHECK(contains(message_with([](Settings& s) { s.road_width = s.layer_height; }), "road_width"));
  CHECK(contains(message_with([](Settings& s) { s.road_width = Length::from_mm(1.01); }), "2.5"));
  CHECK(contains(message_with([](Settings& s) { s.layer_height = Length::from_mm(0.41); }),
                 "nozzle_diameter"));
  CHECK(contains(message_with([](Settings& s) { s.road_width_min = Length::from_mm(0.46); }),
                 "road_width_min"));
  CHECK(contains(message_with([](Settings& s) { s.part_x = Length::from_mm(5); }), "centre"));
  CHECK(contains(message_with([](Settings& s) {
                   s.centre = false;
                   s.part_y = s.bed_y;
                 }),
                 "not on the bed"));
  CHECK(contains(message_with([](Settings& s) { s.axis_z = Length::from_mm(0.1); }), "axis_z"));
  CHECK(contains(message_with([](Settings& s) {
                   s.axis_z = Length::from_mm(1);
                   s.raft_layers = 4;
                 }),
                 "over a raft of 0.9 mm"));
  CHECK(contains(message_with([](Settings& s) { s.bridge_acceleration_mm_s2 = 500; }),
                 "bridge_acceleration_mm_s2 = 500 needs default_acceleration_mm_s2"));
  CHECK(contains(message_with([](Settings& s) { s.height_slowdown_speed = 0.5; }),
                 "need height_slowdown_to"));
  CHECK(contains(message_with([](Settings& s) {
                   s.height_slowdown_from = s.height_slowdown_to = Length::from_mm(20);
                 }),
                 "must be more than height_slowdown_from = 20"));
  CHECK(contains(message_with([](Settings& s) {
                   s.height_slowdown_to = Length::from_mm(20);
                   s.height_slowdown_acceleration = 0.5;
                 }),
                 "needs default_acceleration_mm_s2"));
  CHECK(contains(message_with([](Settings& s) {
                   s.supports = core::SupportPlace::kBed;
                   s.support_style = core::SupportStyle::kTree;
                   s.support_lookahead = 50;
                 }),
                 "needs support_style = grid"));
  CHECK(contains(message_with([](Settings& s) {
                   s.supports = core::SupportPlace::kBed;
                   s.loose_roof = core::LooseRoof::kCone;
                   s.support_lookahead = 50;
                 }),
                 "support_lookahead needs an inside"));
  // Whoever fills in the struct by hand is checked like who types.
  CHECK(contains(message_with([](Settings& s) { s.bed_x = Length(); }), "bed_x"));
  CHECK(contains(message_with([](Settings& s) { s.layer_height = Length(); }), "layer_height"));
  CHECK(contains(message_with([](Settings& s) { s.perimeters = -1; }), "perimeters"));
  CHECK(contains(message_with([](Settings& s) {
                   s.travel_speed_mm_s = std::numeric_limits<double>::quiet_NaN();
                 }),
                 "travel_speed_mm_s"));
  CHECK(contains(message_with([](Settings& s) { s.end_gcode = {std::string(99, 'G')}; }),
                 "end_gcode"));
}
