#include "firmware_link/virtual/virtual_planner.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

PlannerMove straight(double length_mm, double speed_mm_s) {
  PlannerMove move;
  move.length_mm = length_mm;
  move.speed_mm_s = speed_mm_s;
  move.direction = {1, 0, 0};
  move.acceleration_mm_s2 = 1000;
  return move;
}

double seconds_of(Instant end) {
  return std::chrono::duration<double>(end.time_since_epoch()).count();
}

}  // namespace

TEST_CASE("a lone move speeds up from a stop, and slows down to one") {
  VirtualPlanner planner;
  planner.push(straight(100, 100), Instant{}, false);
  // 100 mm at 100 mm/s, and 0.1 s more for both ramps.
  CHECK(seconds_of(*planner.next_event()) == doctest::Approx(1.1));
  planner.advance(Instant(1099ms));
  CHECK(planner.count() == 1);
  planner.advance(Instant(1101ms));
  CHECK(planner.empty());
  CHECK_FALSE(planner.next_event().has_value());
}

TEST_CASE("a straight successor in time lets it run through, a corner does not") {
  for (const bool corner : {false, true}) {
    VirtualPlanner planner;
    planner.push(straight(100, 100), Instant{}, false);
    PlannerMove next = straight(100, 100);
    if (corner) next.direction = {0, 1, 0};
    planner.push(next, Instant{}, false);
    CHECK(seconds_of(*planner.next_event()) == doctest::Approx(corner ? 1.1 : 1.05));
  }
}

TEST_CASE("fifteen blocks fill it; running dry while moves come is an underrun, unless asked for") {
  VirtualPlanner planner;
  for (int i = 0; i < 15; ++i) {
    CHECK_FALSE(planner.full());
    planner.push(straight(1, 100), Instant{}, false);
  }
  CHECK(planner.full());
  CHECK(planner.count_max() == 15);
  planner.advance(Instant(10s));
  CHECK(planner.low() > Duration(0));
  planner.push(straight(1, 100), Instant(10s), true);
  CHECK(planner.underruns() == 0);
  planner.advance(Instant(20s));
  planner.push(straight(1, 100), Instant(20s), false);
  CHECK(planner.underruns() == 1);
}
