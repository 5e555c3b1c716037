#include "core/regions/corner_index.h"

#include <algorithm>
#include <tuple>

#include "core/regions/ring_corners.h"  // ring_corners

namespace core {

namespace {

constexpr std::int64_t kRowUnits = 20'000;

std::int64_t row_of(std::int64_t y) { return (y >= 0 ? y : y - kRowUnits + 1) / kRowUnits; }

bool before(const CornerIndex::Corner& a, const CornerIndex::Corner& b) {
  const std::int64_t row_a = row_of(a.at.y), row_b = row_of(b.at.y);
  return std::tie(row_a, a.at.x, a.at.y) < std::tie(row_b, b.at.x, b.at.y);
}

}  // namespace

CornerIndex::CornerIndex(const Region& region, Length arm) {
  for (const Ring& ring : region.rings()) {
    for (const RingCorner& corner : ring_corners(ring, arm)) {
      corners_.push_back({corner.place.at, corner.turn});
    }
  }
  std::sort(corners_.begin(), corners_.end(), before);
}

std::optional<CornerIndex::Corner> CornerIndex::nearest(Point to, double turn, Length reach) const {
  const std::int64_t r = reach.units();
  std::optional<Corner> best;
  std::int64_t best2 = r * r;
  for (std::int64_t row = row_of(to.y - r); row <= row_of(to.y + r); ++row) {
    auto at = std::partition_point(corners_.begin(), corners_.end(), [&](const Corner& corner) {
      const std::int64_t corner_row = row_of(corner.at.y);
      return corner_row < row || (corner_row == row && corner.at.x < to.x - r);
    });
    for (; at != corners_.end() && row_of(at->at.y) == row && at->at.x <= to.x + r; ++at) {
      if ((at->turn < 0) != (turn < 0)) continue;
      const std::int64_t dx = std::int64_t{at->at.x} - to.x, dy = std::int64_t{at->at.y} - to.y;
      const std::int64_t away2 = dx * dx + dy * dy;
      if (away2 > best2 || (best && away2 == best2)) continue;
      best = *at;
      best2 = away2;
    }
  }
  return best;
}

}  // namespace core
