#include "host/part/height_fill.h"

#include <algorithm>

namespace host {

void HeightFill::add_outside(std::int64_t z) {
  std::int64_t bin = z >> shift_;
  if (last_ < first_) {
    first_ = last_ = bin;
    filled_.set(0);
    return;
  }
  while (std::max(bin, last_) - std::min(bin, first_) >= static_cast<std::int64_t>(kBins)) {
    widen();
    bin = z >> shift_;
  }
  if (bin < first_) {
    filled_ <<= static_cast<std::size_t>(first_ - bin);
    first_ = bin;
  }
  last_ = std::max(last_, bin);
  filled_.set(static_cast<std::size_t>(bin - first_));
}

void HeightFill::widen() {
  std::bitset<kBins> wider;
  const std::int64_t first = first_ >> 1;
  for (std::int64_t bin = first_; bin <= last_; ++bin) {
    if (filled_.test(static_cast<std::size_t>(bin - first_))) {
      wider.set(static_cast<std::size_t>((bin >> 1) - first));
    }
  }
  filled_ = wider;
  first_ = first;
  last_ >>= 1;
  ++shift_;
}

HeightFill::Stretch HeightFill::longest_empty() const {
  Stretch longest;
  std::int64_t before = first_;
  for (std::int64_t bin = first_; bin <= last_; ++bin) {
    if (!filled_.test(static_cast<std::size_t>(bin - first_))) continue;
    const Stretch stretch{(before + 1) << shift_, bin << shift_};
    if (stretch.high - stretch.low > longest.high - longest.low) longest = stretch;
    before = bin;
  }
  return longest;
}

}  // namespace host
