// The blocks of the move in its handler that the planner has not taken yet: one of a straight move,
// many of an arc, each turned against the one before.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "firmware_link/virtual/virtual_planner.h"  // VirtualPlanner, PlannerMove

namespace firmware_link {

class VirtualBlocks {
 public:
  // `count` blocks like this one, each turned by so many radians. `command`: which the last block
  // ends.
  void set(const PlannerMove& block, std::size_t count, double turn, std::int64_t command) {
    block_ = block;
    count_ = count;
    turn_ = turn;
    command_ = command;
  }

  // Gives the planner as many as it has room for; true when it has all. `pause_was_asked` is that
  // of the first block, and cleared by it.
  bool plan(VirtualPlanner& planner, bool& pause_was_asked, Instant now) {
    while (count_ > 0 && !planner.full()) {
      block_.last_of = count_ == 1 ? command_ : -1;
      planner.push(block_, now, pause_was_asked);
      pause_was_asked = false;
      --count_;
      const auto [x, y, z, e] = block_.direction;
      const double c = std::cos(turn_), s = std::sin(turn_);
      block_.direction = {c * x - s * y, s * x + c * y, z, e};
      block_.goes_on = true;
    }
    return count_ == 0;
  }

  void clear() {
    count_ = 0;
    short_way_mm = {};
  }

  // Of moves too short for a block: the next move goes it, too.
  VirtualAxes short_way_mm{};

 private:
  PlannerMove block_;
  std::size_t count_ = 0;
  double turn_ = 0;
  std::int64_t command_ = 0;
};

}  // namespace firmware_link
