#include "core/sections/wall_gauge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/trigonometry.h"  // hypotenuse

namespace core {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 40;

// What is not covered, from one end of the line to the other.
Intervals gaps(const Intervals& slice) { return subtract({{-kFar, kFar}}, slice); }

class Gauge {
 public:
  Gauge(Intervals loose, Length height) : loose_(std::move(loose)), height_(height) {}

  // Outside at these intervals, from `height` on away from the loose points.
  void meet(const Intervals& outside, Length height) {
    const double rise = height.mm() - height_.mm();
    for (const Interval& spot : loose_) {
      for (const Interval& gap : outside) {
        Length from = Length::from_units(spot.to), to = Length::from_units(gap.from);
        if (gap.to < spot.from) {
          from = Length::from_units(spot.from);
          to = Length::from_units(gap.to);
        } else if (gap.from <= spot.to) {
          // One above the other: in the middle of what they share.
          const std::int64_t low = std::max(spot.from, gap.from), high = std::min(spot.to, gap.to);
          from = to = Length::from_units(low + (high - low) / 2);
        }
        const double distance = hypotenuse((to - from).mm(), rise);
        if (thinnest_ && thinnest_->thickness_mm <= distance) continue;
        thinnest_ = ThinnestWall{distance, from, height_, to, height};
      }
    }
  }

  [[nodiscard]] const std::optional<ThinnestWall>& thinnest() const { return thinnest_; }

 private:
  Intervals loose_;
  Length height_;
  std::optional<ThinnestWall> thinnest_;
};

}  // namespace

std::optional<ThinnestWall> thinnest_wall(const LayerWindow& window, const SectionLine& line) {
  const Slice& slice = window.layer().slice;
  Intervals loose = section_of(window.layer().loose, line);
  if (loose.empty()) return std::nullopt;
  const Length middle = slice.bottom + Length::from_units(slice.height.units() / 2);
  Gauge gauge(std::move(loose), middle);
  for (const LayerWindow::Neighbour& neighbour : window.neighbours()) {
    const Slice& other = neighbour.layer->slice;
    const Length height = other.index == slice.index  ? middle
                          : other.index > slice.index ? other.bottom
                                                      : other.top();
    gauge.meet(gaps(section_of(other.region, line)), height);
  }
  gauge.meet({{-kFar, kFar}}, Length());
  return gauge.thinnest();
}

}  // namespace core
