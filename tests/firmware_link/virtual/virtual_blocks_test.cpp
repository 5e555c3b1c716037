#include "firmware_link/virtual/virtual_blocks.h"

#include <doctest/doctest.h>

#include <chrono>
#include <vector>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("the planner takes as many blocks as it has room for, and the last one ends the move") {
  VirtualPlanner planner;
  std::vector<std::int64_t> ended;
  planner.moved = [&](std::int64_t command) { ended.push_back(command); };
  PlannerMove block;
  block.length_mm = 1;
  block.speed_mm_s = 10;
  block.direction = {1, 0, 0};
  block.acceleration_mm_s2 = 3000;
  VirtualBlocks blocks;
  bool pause_was_asked = true;
  CHECK(blocks.plan(planner, pause_was_asked, Instant{}));
  CHECK(pause_was_asked);
  blocks.set(block, 20, 0.1, 7);
  CHECK_FALSE(blocks.plan(planner, pause_was_asked, Instant{}));
  CHECK_FALSE(pause_was_asked);
  CHECK(planner.full());
  planner.advance(Instant(1s));
  CHECK(ended.empty());
  CHECK(blocks.plan(planner, pause_was_asked, Instant(1s)));
  planner.advance(Instant(1h));
  CHECK(ended == std::vector<std::int64_t>{7});
  blocks.set(block, 3, 0, 8);
  blocks.clear();
  CHECK(blocks.plan(planner, pause_was_asked, Instant(1h)));
  CHECK(planner.empty());
}
