#include "firmware_link/session/planner_watch.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

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

TEST_CASE("an arc takes a planner's block for each millimetre") {
  Move move;
  move.x_um = 20'000;
  CHECK(planner_blocks_of(move) == 1);
  Move arc = move;
  arc.arc = Arc{true, 10'000, 0, 31'416};
  CHECK(planner_blocks_of(arc) == kPlannerBlocks);
  arc.arc->length_um = 2'500;
  CHECK(planner_blocks_of(arc) == 3);
  arc.arc->length_um = 10;
  CHECK(planner_blocks_of(arc) == 1);

  PlannerWatch planner;
  const Instant now{};
  planner.accepted_move(300ms, now, 3);
  CHECK(planner.blocks() == 3);
  planner.advance(now + 150ms);
  CHECK(planner.blocks() == 2);
}
