#include "core/regions/ring_corners.h"

#include <algorithm>
#include <cmath>

#include "core/regions/polyline.h"  // distance_units, between
#include "core/trigonometry.h"      // arc_tangent
#include "core/vector.h"            // Vector

namespace core {

namespace {

// One arm away from a corner the ring turns less than this share of what it turns there.
constexpr double kProminence = 0.8;

// The ring's places by their way from its first point.
class RingWay {
 public:
  RingWay(const Ring& ring, Length arm) : ring_(ring) {
    from_start_.reserve(ring.size() + 1);
    from_start_.push_back(0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point next = ring[i + 1 < ring.size() ? i + 1 : 0];
      from_start_.push_back(from_start_.back() + distance_units(ring[i], next));
    }
    arm_ = std::min(static_cast<double>(arm.units()), from_start_.back() / 4);
  }

  [[nodiscard]] double arm() const { return arm_; }
  [[nodiscard]] double to(std::size_t point) const { return from_start_[point]; }

  [[nodiscard]] double turn_at(double way) const {
    const Vector here = at(way), in = here - at(way - arm_), out = at(way + arm_) - here;
    return arc_tangent(cross(in, out), dot(in, out));
  }

  // Along the ring, the shorter way round.
  [[nodiscard]] double apart(std::size_t a, std::size_t b) const {
    const double one = std::abs(from_start_[a] - from_start_[b]);
    return std::min(one, from_start_.back() - one);
  }

 private:
  [[nodiscard]] Vector at(double way) const {
    const double whole = from_start_.back();
    if (way < 0) way += whole;
    if (way >= whole) way -= whole;
    const auto next = std::upper_bound(from_start_.begin() + 1, from_start_.end() - 1, way);
    const auto i = static_cast<std::size_t>(next - from_start_.begin()) - 1;
    const Vector a = to_vector(ring_[i]);
    const Vector b = to_vector(ring_[i + 1 < ring_.size() ? i + 1 : 0]);
    const double length = from_start_[i + 1] - from_start_[i];
    return length > 0 ? a + (b - a) * ((way - from_start_[i]) / length) : a;
  }

  const Ring& ring_;
  std::vector<double> from_start_;  // by point; the last one is the whole length
  double arm_ = 0;
};

// Whether no other point within an arm turns more the same way; of equal ones the first counts.
bool sharpest(const RingWay& way, const std::vector<double>& turns, std::size_t i) {
  const std::size_t count = turns.size();
  const double sign = turns[i] < 0 ? -1 : 1;
  for (const std::size_t step : {std::size_t{1}, count - 1}) {
    for (std::size_t k = (i + step) % count; k != i; k = (k + step) % count) {
      if (way.apart(i, k) > way.arm()) break;
      if (turns[k] * sign > turns[i] * sign) return false;
      if (turns[k] == turns[i] && k < i) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<RingCorner> ring_corners(const Ring& ring, Length arm) {
  const RingWay way(ring, arm);
  std::vector<RingCorner> corners;
  if (way.arm() <= 0) return corners;
  std::vector<double> turns(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) turns[i] = way.turn_at(way.to(i));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double turn = turns[i];
    if (std::abs(turn) < kCornerTurnMin || !sharpest(way, turns, i)) continue;
    const double sign = turn < 0 ? -1 : 1;
    const double away = std::max(way.turn_at(way.to(i) - way.arm()) * sign,
                                 way.turn_at(way.to(i) + way.arm()) * sign);
    if (away < kProminence * turn * sign) corners.push_back({{ring[i], i}, turn});
  }
  return corners;
}

RingPlace nearest_place(const Ring& ring, Point to) {
  RingPlace best;
  double best_units = -1;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
    const double px = static_cast<double>(to.x) - a.x, py = static_cast<double>(to.y) - a.y;
    const double length2 = dx * dx + dy * dy;
    const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
    const double ox = px - t * dx, oy = py - t * dy;
    const double away2 = ox * ox + oy * oy;
    if (best_units >= 0 && away2 >= best_units) continue;
    best_units = away2;
    best = {between(a, b, t), i};
  }
  if (best_units <= 1) best.at = to;
  const std::size_t next = best.edge + 1 < ring.size() ? best.edge + 1 : 0;
  if (best.at == ring[next]) best.edge = next;
  return best;
}

}  // namespace core
