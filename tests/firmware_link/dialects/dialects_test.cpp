// What the host asks a dialect, instead of asking for its name.
#include "firmware_link/dialects/dialects.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

using firmware_link::Capabilities;
using firmware_link::dialect_for;
using firmware_link::Duration;

TEST_CASE("only a Marlin is asked how far its axes go") {
  CHECK_EQ(dialect_for("Marlin 2.1.2")->rules().travel_question, "M211");
  CHECK_EQ(dialect_for("some other firmware")->rules().travel_question, "M211");
  for (const char* name : {"Klipper", "RepRapFirmware for Duet 3", "Prusa-Firmware 3.13"}) {
    CAPTURE(name);
    CHECK(dialect_for(name)->rules().travel_question.empty());
  }
}

TEST_CASE("a controller is told its height by its own command, where it has one") {
  for (const char* name : {"Marlin 2.1.2", "RepRapFirmware for Duet 3", "Prusa-Firmware 3.13"}) {
    CAPTURE(name);
    CHECK_EQ(dialect_for(name)->rules().height_command, "G92 Z");
    CHECK(dialect_for(name)->no_height_command(Capabilities()).empty());
  }
  const auto klipper = dialect_for("Klipper");
  CHECK_EQ(klipper->rules().height_command, "SET_KINEMATIC_POSITION Z=");
  Capabilities capabilities;
  CHECK_NE(klipper->no_height_command(capabilities).find("[force_move]"), std::string::npos);
  klipper->note_command("SET_KINEMATIC_POSITION: Force a low-level position", capabilities);
  CHECK(klipper->no_height_command(capabilities).empty());
}

TEST_CASE("a planner is counted in blocks, but Klipper's in time") {
  CHECK_EQ(dialect_for("Marlin 2.1.2")->rules().planned_time_max, Duration(0));
  CHECK_EQ(dialect_for("Klipper")->rules().planned_time_max, std::chrono::milliseconds(2'500));
}
