#include "core/motions/spiral_rise.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"  // RIND_CHECK

namespace core {

double SpiralRise::flow(double share) const {
  if (at_top_) return 1 - share;
  const double below = turn_.below.mm() / height_.mm();
  return below + share * (1 - below);
}

std::vector<SpiralRise::Step> SpiralRise::advance(double length_mm) {
  const double change = std::abs(flow(1) - flow(0));
  const double wanted = std::ceil(change * length_mm / (length_mm_ * kSpiralGapStep));
  const int parts = std::max(1, static_cast<int>(wanted));
  std::vector<Step> steps;
  for (int i = 0; i < parts; ++i) {
    const double share = (i + 1.0) / parts;
    const double middle = std::min(1.0, (done_mm_ + length_mm * (i + 0.5) / parts) / length_mm_);
    const double end = std::min(1.0, (done_mm_ + length_mm * share) / length_mm_);
    const Length risen =
        at_top_ ? height_
                : Length::from_units(std::llround(static_cast<double>(height_.units()) * end));
    steps.push_back({share, flow(middle), bottom_ + risen});
  }
  done_mm_ += length_mm;
  return steps;
}

void SpiralRise::begin_top_round() {
  RIND_CHECK(turn_.last && !at_top_);
  at_top_ = true;
  done_mm_ = 0;
}

}  // namespace core
