#include "firmware_link/session/position_watch.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

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

TEST_CASE("an arc takes its length's time") {
  PositionWatch watch;
  Move start = to(0, 0);
  start.y_um = 0;
  start.f_mm_min = 600;
  watch.gave(start);
  Move arc = to(20'000, 100);
  arc.arc = Arc{true, 10'000, 0, 31'416};
  CHECK(watch.nominal_time(arc) == Duration(3'141'600));
}
