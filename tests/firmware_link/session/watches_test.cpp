// The three watches alone: place and filament, heaters, the planner's fill.
#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "firmware_link/session/heater_watch.h"
#include "firmware_link/session/planner_watch.h"
#include "firmware_link/session/position_watch.h"
#include "firmware_link/wire/capabilities.h"
#include "firmware_link/wire/reply.h"

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

Move to(std::int64_t x_um, std::int64_t e_10nm) {
  Move move;
  move.x_um = x_um;
  move.e_10nm = e_10nm;
  return move;
}

Position told(const std::string& line) { return read_reply(line).position; }

}  // namespace

TEST_CASE("an account of where it is agrees within what two decimals can tell") {
  using Verdict = PositionWatch::Verdict;
  PositionWatch watch;
  watch.gave_filament_reset();
  watch.gave(to(10'004, 12'345));
  watch.gave(to(20'004, 12'345));
  const auto compare = [&](const std::string& line) {
    return PositionWatch::compare(watch.expected(), told(line));
  };
  CHECK(compare("X:20.00 Y:5.00 Z:0.20 E:0.25 Count X:1600 Y:400 Z:80") == Verdict::kAgrees);
  CHECK(compare("X:20.02 Y:5.00 Z:0.20 E:0.25 Count X:1600") == Verdict::kPositionDiffers);
  CHECK(compare("X:20.00 Y:5.00 Z:0.20 E:0.26 Count X:1600") == Verdict::kFilamentDiffers);
  CHECK(compare("X:20.00 Y:5.00 Z:0.20 E:0.37 Count X:1600") == Verdict::kFilamentDiffers);
  CHECK(PositionWatch::filament_excess_10nm(watch.expected(), told("X:20.00 E:0.37")) == 12'310);
  // What isn't told isn't held against it.
  CHECK(compare("X:20.00") == Verdict::kAgrees);
  watch.gave_unknown();
  CHECK(compare("X:99.00 Y:5.00 Z:0.20 E:7.00") == Verdict::kAgrees);
}

TEST_CASE("how long a move takes at its feed") {
  PositionWatch watch;
  Move move = to(60'000, 0);
  move.f_mm_min = 3600;
  CHECK(watch.nominal_time(move) == Duration(0));  // from where?
  watch.gave(to(0, 0));
  CHECK(watch.nominal_time(move) == 1s);
  watch.gave(move);
  CHECK(watch.nominal_time(to(0, 0)) == 1s);  // the feed stays
  Move filament;
  filament.e_10nm = -100'000;
  CHECK(watch.nominal_time(filament) == Duration(16'667));
}

TEST_CASE("a heater that does not rise is found, one that rises slowly is not") {
  const HeaterWatchLimits limits = nozzle_watch_limits();
  HeaterWatch watch("the nozzle", limits);
  Instant now{};
  double celsius = 25;
  bool slow = false;
  SUBCASE("slow") { slow = true; }
  SUBCASE("dead") {}
  std::optional<std::string> complaint;
  for (; now < Instant(limits.rise_time * 3) && !complaint; now += 1s) {
    complaint = watch.heard(celsius, 210, now);
    if (slow) celsius += 0.05;
  }
  CHECK(complaint.has_value() != slow);
  if (complaint) {
    CHECK(now > Instant(limits.rise_time));
    CHECK(*complaint ==
          "the nozzle does not get warmer: 25.0 C where 210.0 C was asked for, over 61 s");
  }
}

TEST_CASE("a heater that loses its heat is found; a new target is no loss") {
  HeaterWatch watch("the bed", bed_watch_limits());
  Instant now{};
  const auto pass = [&](double celsius, double target, Duration time) {
    std::optional<std::string> complaint;
    for (const Instant end = now + time; now < end && !complaint; now += 1s) {
      complaint = watch.heard(celsius, target, now);
    }
    return complaint;
  };
  CHECK_FALSE(pass(60, 60, 10s));
  CHECK_FALSE(pass(50, 60, 600s));   // a draught
  CHECK_FALSE(pass(40, 60, 100s));   // a big one
  CHECK_FALSE(pass(58, 60, 10s));    // and it is over
  CHECK_FALSE(pass(58, 100, 200s));  // more is asked for
  CHECK_FALSE(pass(58, 0, 600s));    // off
  CHECK_FALSE(pass(60, 60, 10s));
  const auto complaint = pass(40, 60, 600s);
  REQUIRE(complaint.has_value());
  CHECK(complaint->find("the bed has lost its heat: 40.0 C") == 0);
}

TEST_CASE("time in which nothing was heard counts for little") {
  HeaterWatch watch("the nozzle", nozzle_watch_limits());
  CHECK_FALSE(watch.heard(25, 210, Instant(1s)));
  CHECK_FALSE(watch.heard(25.5, 210, Instant(76s)));   // the host stood still
  CHECK_FALSE(watch.heard(26, 210, Instant(3'000s)));  // and again
  CHECK_FALSE(watch.heard(26.1, 210, Instant(3'010s)));
  CHECK_FALSE(watch.heard(209, 210, Instant(3'100s)));  // reached
  CHECK_FALSE(watch.heard(150, 210, Instant(3'110s)));
  CHECK_FALSE(watch.heard(150, 210, Instant(9'000s)));
  // One that reports seldom is still found out.
  std::optional<std::string> complaint;
  Instant now(9'000s);
  for (; !complaint && now < Instant(9'400s); now += 30s) complaint = watch.heard(150, 210, now);
  CHECK(complaint.has_value());
}

TEST_CASE("a planner that is fed in time is never low, one that waits for lines is") {
  PlannerWatch watch;
  Instant now{};
  for (int i = 0; i < 8; ++i) watch.accepted_move(100ms, now);
  CHECK(watch.blocks() == 8);
  SUBCASE("fed in time") {
    for (int i = 0; i < 100; ++i) watch.accepted_move(100ms, now += 100ms);
    CHECK(watch.low() < 110ms);
  }
  SUBCASE("a gap") {
    watch.advance(now += 500ms);
    CHECK(watch.low() == 400ms);
    CHECK(watch.blocks() == 3);
  }
  SUBCASE("a gap that was asked for") {
    watch.expect_gap(now);
    watch.advance(now += 500ms);
    CHECK(watch.low() == Duration(0));
    watch.accepted_move(100ms, now);
    watch.advance(now += 50ms);
    CHECK(watch.low() == Duration(0));  // it was not half full yet
  }
  SUBCASE("what the controller tells counts more than what is thought") {
    watch.told_free(15, now);
    CHECK(watch.blocks() == 0);
    watch.told_free(5, now);
    CHECK(watch.blocks() == 10);
  }
}

TEST_CASE("capabilities and names out of what M115 says") {
  Capabilities can;
  for (const char* text : {"ARCS:1", "EMERGENCY_PARSER:1", "MEATPACK:0", "NOTHING:1", "x", ":"}) {
    note_capability(text, can);
  }
  CHECK(can.arcs);
  CHECK(can.emergency_parser);
  CHECK_FALSE(can.meatpack);
  CHECK_FALSE(can.autoreport_temperatures);
  CHECK(firmware_name_in("Marlin 2.1 (x y) SOURCE_CODE_URL:z") == "Marlin 2.1 (x y)");
  CHECK(firmware_name_in(" RepRapFirmware for Duet 2 FIRMWARE_VERSION: 3") ==
        "RepRapFirmware for Duet 2");
}

TEST_CASE("an arc takes its length's time, and a planner's block for each millimetre") {
  PositionWatch watch;
  Move begin = to(0, 0);
  begin.y_um = 0;
  begin.f_mm_min = 600;
  watch.gave(begin);
  Move arc = to(20'000, 100);
  arc.arc = Arc{true, 10'000, 0, 31'416};
  CHECK(watch.nominal_time(arc) == Duration(3'141'600));
  CHECK(planner_blocks_of(arc) == kPlannerBlocks);
  arc.arc->length_um = 2'500;
  CHECK(planner_blocks_of(arc) == 3);
  arc.arc->length_um = 10;
  CHECK(planner_blocks_of(arc) == 1);
  CHECK(planner_blocks_of(begin) == 1);

  PlannerWatch planner;
  const Instant now{};
  planner.accepted_move(300ms, now, 3);
  CHECK(planner.blocks() == 3);
  planner.advance(now + 150ms);
  CHECK(planner.blocks() == 2);
}
