#include "core/motions/width_stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_mm

namespace core {
namespace {

class Stretches {
 public:
  Stretches(const Road& road, Length height)
      : kind_(road.kind), last_(road.points.front()), height_(height) {}

  // On to a point, as the width changes from a to b.
  void add(Point to, double a, double b, Hold hold) {
    const double mm = distance_mm(last_, to);
    if (mm == 0) return;
    if (done_.empty() || done_.back().hold != hold || too_wide(a, b)) {
      done_.push_back({laid_as(kind_, hold), hold, Length(), 0, false, {last_}});
      sums_.emplace_back();
    }
    done_.back().points.push_back(to);
    Sums& sums = sums_.back();
    sums.low = std::min({sums.low, a, b});
    sums.high = std::max({sums.high, a, b});
    sums.length_mm += mm;
    sums.width_mm2 += mm * (a + b) / 2;
    sums.volume_mm3 += mm *
                       (road_area_mm2(kind_, Length::from_mm(a), height_) +
                        road_area_mm2(kind_, Length::from_mm(b), height_)) /
                       2;
    last_ = to;
  }

  [[nodiscard]] std::vector<WidthStretch> finish() {
    join_last();
    for (std::size_t i = 0; i < done_.size(); ++i) {
      done_[i].width = Length::from_mm(sums_[i].width_mm2 / sums_[i].length_mm);
      done_[i].area_mm2 = sums_[i].volume_mm3 / sums_[i].length_mm;
    }
    return std::move(done_);
  }

 private:
  // Of a stretch.
  struct Sums {
    double low = std::numeric_limits<double>::infinity(), high = 0;  // its widths
    double length_mm = 0;
    double width_mm2 = 0;
    double volume_mm3 = 0;
  };

  // Whether widths from a to b are too different for the stretch at hand.
  [[nodiscard]] bool too_wide(double a, double b) const {
    const Sums& sums = sums_.back();
    if (sums.length_mm < kWidthPieceMin.mm()) return false;
    return std::max({a, b, sums.high}) > std::min({a, b, sums.low}) * (1 + kWidthChangeShare);
  }

  // A last stretch that is too short is part of the one before.
  void join_last() {
    if (done_.size() < 2 || sums_.back().length_mm >= kWidthPieceMin.mm()) return;
    const WidthStretch& last = done_.back();
    WidthStretch& before = done_[done_.size() - 2];
    if (before.hold != last.hold) return;
    before.points.insert(before.points.end(), last.points.begin() + 1, last.points.end());
    Sums& sums = sums_[sums_.size() - 2];
    sums.length_mm += sums_.back().length_mm;
    sums.width_mm2 += sums_.back().width_mm2;
    sums.volume_mm3 += sums_.back().volume_mm3;
    done_.pop_back();
    sums_.pop_back();
  }

  RoadKind kind_;
  Point last_;
  Length height_;
  std::vector<WidthStretch> done_;
  std::vector<Sums> sums_;  // of each of them
};

std::size_t pieces_of(double length_mm, double a, double b) {
  const double change = std::abs(a - b) / (std::min(a, b) * kWidthChangeShare);
  const double pieces = std::min(std::ceil(change), std::floor(length_mm / kWidthPieceMin.mm()));
  return static_cast<std::size_t>(std::max(1.0, pieces));
}

}  // namespace

std::vector<WidthStretch> width_stretches(Road road, Length height) {
  const Hold first = hold_from(road, 0);
  const bool alike =
      std::all_of(road.holds.begin(), road.holds.end(), [&](Hold hold) { return hold == first; });
  if (road.widths.empty() && alike) {
    const double area_mm2 = road_area_mm2(road.kind, road.width, height);
    std::vector<WidthStretch> whole(1);
    whole.front() = {laid_as(road.kind, first), first, road.width, area_mm2, road.closed,
                     std::move(road.points)};
    return whole;
  }
  Stretches stretches(road, height);
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
    const std::size_t j = (i + 1) % count;
    const Point from = road.points[i], to = road.points[j];
    const double a = width_at(road, i).mm(), b = width_at(road, j).mm();
    const std::size_t pieces = pieces_of(distance_mm(from, to), a, b);
    for (std::size_t k = 0; k < pieces; ++k) {
      const double t0 = static_cast<double>(k) / static_cast<double>(pieces);
      const double t1 = static_cast<double>(k + 1) / static_cast<double>(pieces);
      stretches.add(between(from, to, t1), a + (b - a) * t0, a + (b - a) * t1, hold_from(road, i));
    }
  }
  return stretches.finish();
}

}  // namespace core
