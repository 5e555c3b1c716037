// The virtual controller's motion planner: a queue of 16 blocks, 15 of them usable, and how long
// each takes to move.
//
// A block's time is that of a trapezoid from its entry to its exit speed. All that wait are planned
// again with each new block: none enters faster than its corner allows, than the one before can
// speed up to, or than those behind it can brake from, so that the last ends at rest. Thus segments
// that arrive in time run through, those that arrive late stop at each end.
//
// A corner's speed is by the jerks, by Klipper's square corner or by the junction deviation, as the
// block says. Within an arc no speed is larger than sqrt(acceleration · radius).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "firmware_link/virtual/virtual_limits.h"  // VirtualAxes, VirtualCorners
#include "firmware_link/wire/instant.h"            // Instant
#include "firmware_link/wire/limits.h"             // kPlannerBlocks
#include "firmware_link/wire/ring_buffer.h"        // RingBuffer

namespace firmware_link {

struct PlannerMove {
  double length_mm = 0;           // over x, y, z, or of filament when nothing else moves
  double speed_mm_s = 0;          // REQUIRES: > 0
  VirtualAxes direction{};        // of each axis for a millimetre of the length
  double acceleration_mm_s2 = 0;  // REQUIRES: > 0
  VirtualCorners corners;         // what counts at its start, and where it starts from rest
  bool goes_on = false;           // the arc of the block before it
  std::int64_t last_of = -1;      // the command whose last block it is; -1: others follow
};

class VirtualPlanner {
 public:
  [[nodiscard]] bool empty() const { return blocks_.empty(); }
  [[nodiscard]] bool full() const { return blocks_.size() == kPlannerBlocks - 1; }
  [[nodiscard]] std::size_t count() const { return blocks_.size(); }

  // REQUIRES: !full(). `pause_was_asked`: a gap before this move is no underrun.
  void push(const PlannerMove& move, Instant now, bool pause_was_asked);

  // Called when a command's last block has ended.
  std::function<void(std::int64_t command)> moved;

  // Ends blocks whose time is over. REQUIRES: no block ends before a time already passed.
  void advance(Instant now);

  // When the running block ends.
  [[nodiscard]] std::optional<Instant> next_event() const;

  void clear() { blocks_.clear(); }

  [[nodiscard]] std::int64_t underruns() const { return underruns_; }
  [[nodiscard]] Duration low() const { return low_; }
  // How long blocks that have ended took.
  [[nodiscard]] Duration busy() const { return busy_; }
  [[nodiscard]] std::size_t count_max() const { return count_max_; }

 private:
  struct Block {
    PlannerMove move;
    double rest_speed_mm_s = 0;  // at which it may start from rest, or end
    double entry_squared_max = 0;
    double entry_squared = 0;
  };

  void plan();
  void start(Instant when);
  [[nodiscard]] Instant end_of_first(Instant start);

  RingBuffer<Block, kPlannerBlocks> blocks_;
  Instant running_since_;
  Instant running_until_;
  bool moved_before_ = false;

  std::int64_t underruns_ = 0;
  Duration low_{0};
  Duration busy_{0};
  std::size_t count_max_ = 0;
};

}  // namespace firmware_link
