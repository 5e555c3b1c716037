#include "core/motions/width_stretches.h"

#include <algorithm>
#include <cmath>
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
    const double low = std::min(a, b), high = std::max(a, b);
    const bool wider = std::max(high, high_) > std::min(low, low_) * (1 + kWidthChangeShare);
    if (done_.empty() || done_.back().hold != hold || wider) {
      close();
      done_.push_back({laid_as(kind_, hold), hold, Length(), 0, false, {last_}});
      low_ = low;
      high_ = high;
    } else {
      low_ = std::min(low, low_);
      high_ = std::max(high, high_);
    }
    done_.back().points.push_back(to);
    length_mm_ += mm;
    width_mm2_ += mm * (a + b) / 2;
    volume_mm3_ += mm *
                   (road_area_mm2(kind_, Length::from_mm(a), height_) +
                    road_area_mm2(kind_, Length::from_mm(b), height_)) /
                   2;
    last_ = to;
  }

  [[nodiscard]] std::vector<WidthStretch> finish() {
    close();
    return std::move(done_);
  }

 private:
  void close() {
    if (done_.empty()) return;
    done_.back().width = Length::from_mm(width_mm2_ / length_mm_);
    done_.back().area_mm2 = volume_mm3_ / length_mm_;
    length_mm_ = width_mm2_ = volume_mm3_ = 0;
  }

  RoadKind kind_;
  Point last_;
  Length height_;
  std::vector<WidthStretch> done_;
  double low_ = 0, high_ = 0;  // widths of the stretch at hand
  double length_mm_ = 0;
  double width_mm2_ = 0;
  double volume_mm3_ = 0;
};

std::size_t pieces_of(double length_mm, double a, double b) {
  const double change = std::abs(a - b) / (std::min(a, b) * kWidthChangeShare);
  const double pieces = std::min(std::ceil(change), std::floor(length_mm / kWidthPieceMin.mm()));
  return static_cast<std::size_t>(std::max(1.0, pieces));
}

}  // namespace

std::vector<WidthStretch> width_stretches(const Road& road, Length height) {
  const Hold first = hold_from(road, 0);
  const bool alike =
      std::all_of(road.holds.begin(), road.holds.end(), [&](Hold hold) { return hold == first; });
  if (road.widths.empty() && alike) {
    const double area_mm2 = road_area_mm2(road.kind, road.width, height);
    return {{laid_as(road.kind, first), first, road.width, area_mm2, road.closed, road.points}};
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
