// The virtual controller's motion planner: a queue of 16 blocks, 15 of them usable, and how long
// each takes to move.
//
// A block's time is that of a trapezoid from its entry to its exit speed. The speed at a corner is
// the slower block's, times the cosine of the turn (0 from 90° on); behind the last block it is 0.
// That is simpler than any firmware's, and right about what matters here: short segments that
// arrive in time run through, those that arrive late stop at each end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "firmware_link/wire/instant.h"      // Instant
#include "firmware_link/wire/limits.h"       // kPlannerBlocks
#include "firmware_link/wire/ring_buffer.h"  // RingBuffer

namespace firmware_link {

struct PlannerMove {
  double length_mm = 0;               // over x, y, z, or of filament when nothing else moves
  double speed_mm_s = 0;              // REQUIRES: > 0
  std::array<double, 3> direction{};  // of x, y, z; zero when only filament moves
  double acceleration_mm_s2 = 0;      // REQUIRES: > 0
  std::int64_t last_of = -1;          // the command whose last block it is; -1: others follow
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
  [[nodiscard]] std::size_t count_max() const { return count_max_; }

 private:
  struct Block {
    PlannerMove move;
    double entry_speed_mm_s = 0;
  };

  void start(Instant when);
  [[nodiscard]] Instant end_of_first(Instant start);

  RingBuffer<Block, kPlannerBlocks> blocks_;
  Instant running_since_;
  Instant running_until_;
  bool moved_before_ = false;

  std::int64_t underruns_ = 0;
  Duration low_{0};
  std::size_t count_max_ = 0;
};

}  // namespace firmware_link
