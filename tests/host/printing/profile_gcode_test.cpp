// The G-code of a PrusaSlicer profile, from its placeholders to what is sent.
#include <doctest/doctest.h>

#include <map>
#include <string>

#include "tests/host/profile_print.h"

using namespace profile_test;

TEST_CASE("profile: absolute filament in its start G-code") {
  const Asked asked;
  const Settings settings =
      asked.good({{"start_gcode", "G28 ; home\\nM82 ; absolute\\nG92 E0\\nG1 Z5 F5000"},
                  {"end_gcode", "M104 S0\\nG28 X0\\nM84"},
                  {"use_relative_e_distances", "0"}});
  CHECK(settings.start_gcode == Lines{"G28", "M82", "G92 E0", "G1 Z5 F5000"});
  CHECK(settings.end_gcode == Lines{"M104 S0", "G28 X0", "M84"});
  CHECK_EQ(asked.made(settings).filament_mm,
           doctest::Approx(asked.made(asked.good({})).filament_mm));
}

TEST_CASE("profile: placeholders are filled in, or refused") {
  const Asked asked;
  const Settings settings = asked.good(
      {{"start_gcode",
        "M104 S[first_layer_temperature] ; hot\\nM190 S{first_layer_bed_temperature[0]}\\n"
        "M109 S{first_layer_temperature[initial_tool]}\\nM104 S{first_layer_temperature[1]}\\nG1 "
        "X{print_bed_max[0]} Y[print_bed_size_1]"
        "\\nM117 [layer_height] [nozzle_diameter] [fill_density] [filament_diameter] "
        "[nozzle_celsius]\\nT[initial_tool]"},
       {"filament_type", "PLA"},
       {"end_gcode", "M117 {filament_type[0]} [temperature] done"}});
  CHECK(settings.start_gcode == Lines{"M104 S215", "M190 S65", "M109 S215", "M104 S215",
                                      "G1 X250 Y210", "M117 0.2 0.4 15% 1.75 210", "T0"});
  CHECK(settings.end_gcode == Lines{"M117 PLA 210 done"});
  // What is set besides holds.
  const std::string path = asked.folder.add_text(
      "hot.ini", profile({{"start_gcode", "M109 S[first_layer_temperature]"}}));
  const auto hotter = host::whole_settings({path, false, {{"nozzle_first_layer_celsius", "230"}}});
  REQUIRE(hotter.ok());
  CHECK(hotter.value().settings.start_gcode == Lines{"M109 S230"});

  // What is automatic stands for the value that is used.
  const std::string first_path = asked.folder.add_text(
      "first.ini",
      profile({{"start_gcode", "G1 Z[first_layer_height]\\nM140 S[first_layer_bed_temperature]"}}));
  const auto like_others = host::whole_settings({first_path,
                                                 false,
                                                 {{"first_layer_height", "auto"},
                                                  {"bed_first_layer_celsius", "auto"},
                                                  {"bed_celsius", "55"}}});
  REQUIRE(like_others.ok());
  CHECK(like_others.value().settings.start_gcode == Lines{"G1 Z0.2", "M140 S55"});

  const std::map<std::string, std::string> unknown = {
      {"start_gcode", "M862.3 P \"[printer_model]\"\\nG28\\n{if x}\\nG1 Z0.3\\n{endif}"}};
  CHECK(contains(asked.refusal(unknown),
                 "start_gcode: line 1, column 11: [printer_model]: it stands for nothing"));
  CHECK(contains(asked.refusal({{"end_gcode", "M84\\n{if 1}G1 Z5"}}),
                 "end_gcode: line 2, column 1: {if 1}: has no {endif}"));
  const auto lax = asked.settings(unknown, true);
  REQUIRE(lax.ok());
  CHECK(lax.value().settings.start_gcode == Settings().start_gcode);
  CHECK(names(lax.value().notes, "rind's own is sent (G28)"));
  CHECK(asked.refusal({{"start_gcode", "G28"}}).empty());
}

TEST_CASE("profile: what only the part gives waits for it") {
  const Asked asked;
  const std::string path = asked.folder.add_text(
      "part.ini", profile({{"end_gcode",
                            "{if max_layer_z < max_print_height}G1 Z{z_offset+min(max_layer_z+2, "
                            "max_print_height)}{endif}\\nM117 [input_filename_base] "
                            "{total_layer_count} {first_layer_print_min[0]}\\nM84"}}));
  const host::SettingsRequest request{path, false, {}};
  auto whole = host::whole_settings(request);
  REQUIRE(whole.ok());
  REQUIRE_EQ(whole.value().pending.size(), 1);
  CHECK(whole.value().settings.end_gcode.empty());
  host::WholeSettings unknown = whole.value();
  const core::Box box{{1'200'000, 1'000'000}, {1'300'000, 1'100'000}};
  const core::Status refused =
      host::fill_for_part(request, {"standard input", core::Length(), 0, {}}, unknown);
  REQUIRE_FALSE(refused.ok());
  CHECK(contains(refused.error().message, "max_layer_z is not known of a part that is read as it"));
  CHECK(
      host::fill_for_part(request, {"a.b.stl", Length::from_mm(2.1), 10, box}, whole.value()).ok());
  CHECK(whole.value().settings.end_gcode == Lines{"G1 Z4.1", "M117 a.b 10 120", "M84"});
  CHECK(whole.value().pending.empty());
}

TEST_CASE("profile: refused commands are taken out and named, and can't allow themselves") {
  const Asked asked;
  for (const char* start : {"G28\\nM500", "G28\\nm0997", "G28\\nG1 X5 M112", "G28\\n@WORD"}) {
    CAPTURE(start);
    const auto whole = asked.settings({{"start_gcode", start}});
    REQUIRE(whole.ok());
    CHECK(whole.value().settings.start_gcode == Lines{"G28"});
    CHECK(names(whole.value().notes, "start_gcode: '"));
    CHECK(names(whole.value().notes, "is taken out"));
    CHECK(host::check_user_gcode(whole.value().settings).ok());
  }
  const std::string kept = asked.folder.add_text("kept.ini", profile({{"start_gcode", "M500"}}));
  const auto keeping = host::whole_settings({kept, false, {{"allow_gcode", "M500"}}});
  REQUIRE(keeping.ok());
  CHECK(keeping.value().settings.start_gcode == Lines{"M500"});
  // In the user's own lines they are refused.
  const auto mine = host::whole_settings({"", false, {{"start_gcode", "M500"}}});
  REQUIRE(mine.ok());
  CHECK_FALSE(host::check_user_gcode(mine.value().settings).ok());
  const std::string own = asked.folder.add_text("own.ini", "allow_gcode = M500\n");
  const auto allowing = host::whole_settings({own, false, {}});
  REQUIRE_FALSE(allowing.ok());
  CHECK(contains(allowing.error().message, "own.ini:1: allow_gcode is not permitted in a file"));
  const auto named = host::whole_settings({"", false, {{"allow_gcode", "M500"}}});
  REQUIRE(named.ok());
  CHECK_EQ(named.value().settings.allow_gcode, "M500");
}
