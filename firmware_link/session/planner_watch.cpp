#include "firmware_link/session/planner_watch.h"

#include <algorithm>

namespace firmware_link {
namespace {

constexpr std::size_t kHalf = kPlannerBlocks / 2;

}  // namespace

std::size_t planner_blocks_of(const Move& move) {
  if (!move.arc) return 1;
  const std::int32_t blocks = (move.arc->length_um + kArcBlockUm - 1) / kArcBlockUm;
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(blocks, 1)), 1, kPlannerBlocks);
}

void PlannerWatch::drop_oldest() {
  first_ = (first_ + 1) % ends_.size();
  --count_;
}

void PlannerWatch::add_block(Duration nominal, Instant now) {
  const Instant begin = count_ == 0 ? now : ends_[(first_ + count_ - 1) % ends_.size()];
  ends_[(first_ + count_++) % ends_.size()] = begin + nominal;
  armed_ = armed_ || count_ >= kHalf;
}

void PlannerWatch::advance(Instant now) {
  while (count_ > 0 && ends_[first_] <= now) {
    if (armed_ && count_ < kHalf && ends_[first_] > at_) low_ += ends_[first_] - at_;
    at_ = std::max(at_, ends_[first_]);
    drop_oldest();
  }
  if (armed_ && count_ < kHalf && now > at_) low_ += now - at_;
  at_ = std::max(at_, now);
}

void PlannerWatch::accepted_move(Duration nominal, Instant now, std::size_t blocks) {
  advance(now);
  if (nominal.count() <= 0) return;
  last_nominal_ = nominal / static_cast<Duration::rep>(blocks);
  for (; blocks > 0; --blocks) {
    // It was accepted, so there was room: the oldest has ended, whatever was thought of it.
    if (count_ == ends_.size()) drop_oldest();
    add_block(last_nominal_, now);
  }
}

void PlannerWatch::told_free(std::int32_t blocks_free, Instant now) {
  advance(now);
  if (blocks_free < 0 || blocks_free > 255) return;
  free_max_ = std::max(free_max_, blocks_free);
  const std::size_t used =
      std::min(ends_.size(), static_cast<std::size_t>(free_max_ - blocks_free));
  while (count_ > used) drop_oldest();
  // Blocks that should have ended by now, and have not.
  while (count_ < used) add_block(last_nominal_, now);
}

void PlannerWatch::expect_gap(Instant now) {
  advance(now);
  armed_ = false;
  count_ = 0;
}

}  // namespace firmware_link
