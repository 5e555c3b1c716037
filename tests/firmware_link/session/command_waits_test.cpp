#include "firmware_link/session/command_waits.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("a command's word ends with its number, or at the first blank") {
  CHECK(word_of("G1X10 E2") == "G1");
  CHECK(word_of("G1 X10") == "G1");
  CHECK(word_of("M105") == "M105");
  CHECK(word_of("PRINT_START BED=60") == "PRINT_START");
  CHECK(word_of("").empty());
  CHECK(word_of("T0") == "T0");
}

TEST_CASE("moves are answered at once, homing and heating take their time") {
  CHECK_FALSE(wait_of("G1X10", false).is_long());
  CHECK_FALSE(wait_of("M105", true).is_long());
  CHECK(wait_of("G28 X", false).limit == 10min);
  CHECK(wait_of("G28", false).planner_runs_empty);
  CHECK(wait_of("M190 S60", false).limit == 90min);
  CHECK(wait_of("M600", false).limit == 720h);
  CHECK(wait_of("T1", false).limit == 5min);
  CHECK(wait_of("M109 S200", false).what == "the nozzle to be warm");
}

TEST_CASE("macros may do anything, where there are any") {
  CHECK_FALSE(wait_of("PRINT_START", false).is_long());
  CHECK(wait_of("PRINT_START BED=60", true).limit == 60min);
  CHECK(wait_of("G28", true).limit == 60min);  // its user may have written it again
  CHECK(wait_of("M600", true).limit == 720h);
}
