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

void PlannerWatch::add_block(Duration nominal, Instant now) {
  const Instant start = ends_.empty() ? now : ends_.back();
  ends_.push(start + nominal);
  armed_ = armed_ || ends_.size() >= kHalf;
}

void PlannerWatch::advance(Instant now) {
  while (!ends_.empty() && ends_.front() <= now) {
    if (armed_ && ends_.size() < kHalf && ends_.front() > at_) low_ += ends_.front() - at_;
    at_ = std::max(at_, ends_.front());
    (void)ends_.pop();
  }
  if (armed_ && ends_.size() < kHalf && now > at_) low_ += now - at_;
  at_ = std::max(at_, now);
}

void PlannerWatch::accepted_move(Duration nominal, Instant now, std::size_t blocks) {
  advance(now);
  if (nominal.count() <= 0) return;
  last_nominal_ = nominal / static_cast<Duration::rep>(blocks);
  for (; blocks > 0; --blocks) {
    // It was accepted, so there was room: the oldest has ended, whatever was thought of it.
    if (ends_.full()) (void)ends_.pop();
    add_block(last_nominal_, now);
  }
}

void PlannerWatch::told_free(std::int32_t blocks_free, Instant now) {
  advance(now);
  if (blocks_free < 0 || blocks_free > 255) return;
  free_max_ = std::max(free_max_, blocks_free);
  const std::size_t used =
      std::min(kPlannerBlocks, static_cast<std::size_t>(free_max_ - blocks_free));
  while (ends_.size() > used) (void)ends_.pop();
  // Blocks that should have ended by now, and have not.
  while (ends_.size() < used) add_block(last_nominal_, now);
}

void PlannerWatch::expect_gap(Instant now) {
  advance(now);
  armed_ = false;
  ends_.clear();
}

}  // namespace firmware_link
