#include "core/slices/height_ceiling.h"

#include <algorithm>
#include <limits>

#include "core/check.h"  // RIND_CHECK

namespace core {
namespace {

// Higher than any part, and far from where sums overflow.
constexpr Length kEndless = Length::from_units(std::numeric_limits<std::int64_t>::max() / 4);

// What a limit leaves at some distance.
Length raised(Length limit, Length distance) {
  return limit + Length::from_units(distance.units() / kCeilingRun);
}

// The distance from which on `limit` leaves all of `height`.
Length run_to(Length limit, Length height) {
  return std::max(Length(), height - limit) * kCeilingRun;
}

}  // namespace

HeightCeiling::HeightCeiling(const HeightLimits& limits, std::int64_t bed_z)
    : highest_(limits.bounds().highest), width_(limits.bin_width()) {
  if (limits.last() < limits.first()) return;
  bottom_ = Length::from_units(limits.first() * width_ - bed_z);
  const Length width = Length::from_units(width_);
  Length below = highest_;
  for (std::int64_t bin = limits.first(); bin <= limits.last(); ++bin) {
    const Length limit = limits.at_bin(bin);
    bins_.push_back({limit, below, highest_});
    below = std::min({limit, raised(below, width), highest_});
  }
  for (std::size_t i = bins_.size() - 1; i > 0; --i) {
    const Bin& over = bins_[i];
    bins_[i - 1].above = std::min({over.limit, raised(over.above, width), highest_});
  }
}

Length HeightCeiling::at(Length z) const {
  if (bins_.empty()) return highest_;
  if (z < bottom_) {
    const Bin& bin = bins_.front();
    const Length edge = std::min(bin.limit, raised(bin.above, Length::from_units(width_)));
    return std::min(highest_, raised(edge, bottom_ - z));
  }
  if (z >= top()) {
    const Bin& bin = bins_.back();
    const Length edge = std::min(bin.limit, raised(bin.below, Length::from_units(width_)));
    return std::min(highest_, raised(edge, z - top()));
  }
  const std::size_t number = bin_at(z);
  const Bin& bin = bins_[number];
  const Length up = z - bin_bottom(number);
  return std::min(
      {bin.limit, raised(bin.below, up), raised(bin.above, Length::from_units(width_) - up)});
}

// Within a bin it is the least of a rising line, a falling one and a level one: least at an end.
Length HeightCeiling::least(Length from, Length to) const {
  RIND_CHECK(from <= to);
  Length least = std::min(at(from), at(to));
  if (bins_.empty() || to < bottom_ || from >= top()) return least;
  std::size_t edge = from < bottom_ ? 0 : bin_at(from) + 1;
  for (; edge <= bins_.size() && bin_bottom(edge) < to; ++edge) {
    least = std::min(least, at(bin_bottom(edge)));
  }
  return least;
}

Length HeightCeiling::level_until(Length z) const {
  if (bins_.empty()) return kEndless;
  const Length here = at(z);
  if (z < bottom_) {
    if (here != highest_) return z;
    return std::max(z, bottom_ - run_to(at(bottom_), highest_));
  }
  if (z >= top()) return here == highest_ ? kEndless : z;
  const std::size_t number = bin_at(z);
  const Bin& bin = bins_[number];
  if (here != bin.limit) return z;
  return std::max(z, bin_bottom(number + 1) - run_to(bin.above, bin.limit));
}

}  // namespace core
