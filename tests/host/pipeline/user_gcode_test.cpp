#include "host/pipeline/user_gcode.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using Lines = std::vector<std::string>;

namespace {

std::string refusal(const Lines& start, const std::string& allowed = "") {
  core::Settings settings;
  settings.start_gcode = start;
  settings.allow_gcode = allowed;
  const core::Status status = host::check_user_gcode(settings);
  return status.ok() ? "" : status.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE("\"" << part << "\" is missing in: " << text);
  return found;
}

Lines started(const Lines& start) {
  core::Settings settings;
  settings.start_gcode = start;
  return host::with_own_modes(settings).start_gcode;
}

}  // namespace

TEST_CASE("a user's line that may not be sent is told with its setting and place") {
  core::Settings settings;
  CHECK(host::check_user_gcode(settings).ok());
  CHECK(contains(refusal({"G28", "; a comment", "", "M112"}), "start_gcode, line 4 ('M112')"));
  CHECK(contains(refusal({"N12 G28"}), "line number"));
  CHECK(contains(refusal({"m110 N0"}), "M110 sets the number of the next line"));
  CHECK(refusal({"M1090", "Notice"}).empty());
  settings.end_gcode = {"N7 G28*12"};
  const core::Status status = host::check_user_gcode(settings);
  REQUIRE_FALSE(status.ok());
  CHECK_EQ(status.error().code, core::ErrorCode::kBadSetting);
  CHECK(contains(status.error().message, "end_gcode, line 1"));
}

TEST_CASE("what the user allows is sent, but for what is never allowed") {
  CHECK(contains(refusal({"G28", "m0500"}), "M500 stores the printer's settings for good"));
  CHECK(contains(refusal({"G28", "m0500"}), "--allow-gcode M500"));
  CHECK(refusal({"G28", "m0500"}, "M500").empty());
  CHECK(refusal({"M500", "M501"}, "m 500, M501").empty() == false);
  CHECK(refusal({"M500", "M501"}, "m0500, M501").empty());
  CHECK(contains(refusal({"M500", "M502"}, "M500,M501"), "M502"));
  CHECK(contains(refusal({"G28"}, "M110"), "allow_gcode: M110 is never sent"));
  CHECK(contains(refusal({"G28"}, "M28,M500"), "never"));
  CHECK(contains(refusal({"G28"}, "="), "is no command"));
  // What nobody refuses may be named, too.
  CHECK(refusal({"G28"}, "G29,SAVE_VARIABLE").empty());
}

TEST_CASE("rind's modes stand before and behind the user's lines") {
  CHECK(started({"G28"}) == Lines{"G21", "G90", "M82", "G28", "G21", "G90", "M83", "G92 E0"});
  CHECK(started({}) == Lines{"G21", "G90", "M83", "G92 E0"});
  CHECK(started({"g18"}) ==
        Lines{"G21", "G90", "M82", "g18", "G21", "G90", "M83", "G17", "G92 E0"});
  const Lines all = started({"G19", "G18", "G93", "M149 F", "M200 D1.75", "M209 S1"});
  CHECK(Lines(all.begin() + 9, all.end()) ==
        Lines{"G21", "G90", "M83", "G17", "G94", "M149 C", "M200 D0", "M209 S0", "G92 E0"});
}

TEST_CASE("rind's modes stand behind the lines of a height, once") {
  core::Settings settings;
  settings.at_height = {"3 M600", "1 gcode G18", "3 pause", "2 nozzle_celsius 215", "1 M117 a"};
  settings.pause_gcode = {"G93"};
  CHECK(host::with_own_modes(settings).at_height ==
        Lines{"1 gcode G18", "1 gcode M117 a", "1 gcode G21", "1 gcode G90", "1 gcode M83",
              "1 gcode G17", "1 gcode G92 E0", "1 gcode M400", "2 nozzle_celsius 215",
              "3 gcode M600", "3 pause", "3 gcode G21", "3 gcode G90", "3 gcode M83", "3 gcode G94",
              "3 gcode G92 E0", "3 gcode M400"});
}

TEST_CASE("lines at heights and in pauses are checked as others are, and what lasts is named") {
  core::Settings settings;
  settings.at_height = {"1 pause", "1 M112"};
  CHECK(contains(host::check_user_gcode(settings).error().message, "at_height, line 2 ('M112')"));
  settings.at_height = {"1 M220 S50"};
  CHECK(host::check_user_gcode(settings).ok());
  CHECK(
      contains(host::user_gcode_notes(settings).at(0),
               "at_height: M220 S50 counts for the lines at that place alone: M220 S100 is told"));
  settings.pause_gcode = {"M997"};
  CHECK(contains(host::check_user_gcode(settings).error().message, "pause_gcode, line 1"));
}

TEST_CASE("what start G-code chose is told again behind the lines of a height and of a pause") {
  core::Settings settings;
  settings.start_gcode = {"T1", "M221 S95"};
  settings.at_height = {"1 gcode M221 S120", "2 gcode M117 a", "3 pause"};
  settings.pause_gcode = {"T0", "M220 S50", "M25"};
  CHECK(host::with_own_modes(settings).at_height ==
        Lines{"1 gcode M221 S120", "1 gcode G21",    "1 gcode G90",       "1 gcode M83",
              "1 gcode M221 S95",  "1 gcode G92 E0", "1 gcode M400",      "2 gcode M117 a",
              "2 gcode G21",       "2 gcode G90",    "2 gcode M83",       "2 gcode G92 E0",
              "2 gcode M400",      "3 pause",        "3 gcode G21",       "3 gcode G90",
              "3 gcode M83",       "3 gcode T1",     "3 gcode M220 S100", "3 gcode G92 E0",
              "3 gcode M400"});
}

TEST_CASE("what cannot be told again is named") {
  core::Settings settings;
  settings.at_height = {"1 M204 S300",   "2 M900 K0", "3 gcode SWAP_FILAMENT",
                        "4 gcode PAUSE", "5 M600",    "6 gcode G55"};
  const Lines notes = host::user_gcode_notes(settings);
  REQUIRE_EQ(notes.size(), 4);
  CHECK(contains(notes[0], "at_height: M204 S300 changes the rest of the print"));
  CHECK(contains(notes[1], "at_height: M900 K0 changes the rest of the print"));
  CHECK(contains(notes[2], "at_height: SWAP_FILAMENT is a macro"));
  CHECK(contains(notes[3], "G55"));
  settings.default_acceleration_mm_s2 = 500;
  settings.start_gcode = {"M900 K0.1"};
  CHECK_EQ(host::user_gcode_notes(settings).size(), 3);  // SWAP_FILAMENT, G55; M900 goes back
}

TEST_CASE("filament counts from 0 before an end that moves it") {
  core::Settings settings;
  settings.end_gcode = {"M84"};
  CHECK(host::with_own_modes(settings).end_gcode == Lines{"M84"});
  settings.end_gcode = {"M82", "G1 e-4 F300", "M84"};
  CHECK(host::with_own_modes(settings).end_gcode == Lines{"G92 E0", "M82", "G1 e-4 F300", "M84"});
}

TEST_CASE("what the user's lines change for the whole print is named") {
  core::Settings settings;
  CHECK(host::user_gcode_notes(settings).empty());
  settings.start_gcode = {"G28", "G92 E0",         "G92 X10 E0", "G55",
                          "T1",  "M221 S95 ; mk3", "M220 S80 B", "M206 Z0.1",
                          "T0",  "M104 T1 S200",   "G92 X10 E0", "SET_GCODE_OFFSET Z=0.1"};
  const Lines notes = host::user_gcode_notes(settings);
  REQUIRE_EQ(notes.size(), 7);
  CHECK(contains(notes[0], "G92 X10 E0"));
  CHECK(contains(notes[1], "G55"));
  CHECK(contains(notes[2], "T1 chooses the tool"));
  CHECK(contains(notes[3], "M221 S95 changes the flow"));
  CHECK(contains(notes[4], "M220"));
  CHECK(contains(notes[5], "M206"));
  CHECK(contains(notes[6], "SET_GCODE_OFFSET"));
}
