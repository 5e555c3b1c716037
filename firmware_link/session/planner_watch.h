// How long the controller's planner ran below half for want of lines. There it starts to slow down,
// so that the nozzle stutters and leaves blobs (Marlin's SLOWDOWN), long before it runs dry.
//
// A controller with ADVANCED_OK tells its free blocks with each `ok`. Others are estimated: a move
// that was accepted lasts at least as long as its way takes at its feed, and they run one behind
// the other:
//
//     accepted   m1   m2   m3
//     runs       |--m1--|---m2---|-m3-|          at any time: blocks = moves that have not ended
//
// Real moves also speed up and slow down, so the estimate errs on the side of too few blocks. It
// starts to count once the planner was half full, and stops where a command waits for it to be
// empty (M400, G4, G28, M109): such a gap was asked for.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware_link/wire/command.h"      // Move
#include "firmware_link/wire/instant.h"      // Instant
#include "firmware_link/wire/limits.h"       // kPlannerBlocks
#include "firmware_link/wire/ring_buffer.h"  // RingBuffer

namespace firmware_link {

// Controllers make straight blocks of at most 1 mm of an arc (Marlin's MAX_ARC_SEGMENT_MM).
inline constexpr std::int32_t kArcBlockUm = 1'000;

// How many blocks a move takes in the planner, at least. ENSURES: 1 … kPlannerBlocks.
[[nodiscard]] std::size_t planner_blocks_of(const Move& move);

class PlannerWatch {
 public:
  // A move that takes so long, and so many blocks, was accepted.
  void accepted_move(Duration nominal, Instant now, std::size_t blocks = 1);

  // The controller told its free blocks.
  void told_free(std::int32_t blocks_free, Instant now);

  // A command that lets the planner run empty was given, or no more lines are to come for a while.
  void expect_gap(Instant now);

  // Lets time pass.
  void advance(Instant now);

  [[nodiscard]] Duration low() const { return low_; }

  // When the last of its blocks is taken to end; long ago when it is empty.
  [[nodiscard]] Instant end() const { return ends_.empty() ? Instant{} : ends_.back(); }

  // How full it is taken to be. ENSURES: at most kPlannerBlocks.
  [[nodiscard]] std::size_t blocks() const { return ends_.size(); }

 private:
  void add_block(Duration nominal, Instant now);

  // When each block that is taken to be in the planner ends, oldest first.
  RingBuffer<Instant, kPlannerBlocks> ends_;
  Instant at_{};
  Duration low_{0};
  Duration last_nominal_{0};
  bool armed_ = false;
  std::int32_t free_max_ = 0;  // the planner's size, as far as it was told
};

}  // namespace firmware_link
