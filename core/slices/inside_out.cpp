#include "core/slices/inside_out.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/booleans/boolean.h"  // clean
#include "core/regions/polyline.h"  // distance_units
#include "core/regions/region.h"    // doubled_area_units
#include "core/rounded.h"           // rounded

namespace core {
namespace {

// So near to a contour it can't be said on which side of it a place is.
constexpr std::int64_t kBesideUnits = 2;

// Slivers are up to about so wide.
constexpr double kSliverUnits = 4;

// Places at equal distances along the ring.
std::vector<Point> samples_of(const Ring& ring) {
  double length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    length += distance_units(ring[i], ring[(i + 1) % ring.size()]);
  }
  const double step = length / kTurnSamples;
  std::vector<Point> samples;
  samples.reserve(kTurnSamples);
  double next = step / 2, behind = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double edge = distance_units(a, b);
    for (; edge > 0 && next <= behind + edge && samples.size() < kTurnSamples; next += step) {
      const double share = (next - behind) / edge;
      samples.push_back(
          {rounded(a.x + share * (double(b.x) - a.x)), rounded(a.y + share * (double(b.y) - a.y))});
    }
    behind += edge;
  }
  return samples;
}

bool beside(Point p, Point a, Point b) {
  if (p.x < std::min(a.x, b.x) - kBesideUnits || p.x > std::max(a.x, b.x) + kBesideUnits) {
    return false;
  }
  const double distance = std::abs(static_cast<double>(cross(a, b, p)));
  return distance <= static_cast<double>(kBesideUnits) * distance_units(a, b);
}

// How often the ring winds around the place; nothing where it passes by.
std::optional<int> winding(const Ring& ring, Point p) {
  int sum = 0;
  Point a = ring.back();
  for (const Point b : ring) {
    const std::int32_t low = std::min(a.y, b.y), high = std::max(a.y, b.y);
    if (p.y >= low - kBesideUnits && p.y <= high + kBesideUnits) {
      if (beside(p, a, b)) return std::nullopt;
      if ((a.y <= p.y) != (b.y <= p.y)) {
        const bool left = cross(a, b, p) > 0;
        if (b.y > a.y && left) ++sum;
        if (b.y < a.y && !left) --sum;
      }
    }
    a = b;
  }
  return sum;
}

class Turner {
 public:
  explicit Turner(std::vector<Ring>& rings) : rings_(rings) {
    for (const Ring& ring : rings) {
      boxes_.push_back(box_of(ring));
      clockwise_.push_back(doubled_area_units(ring) < 0);
    }
  }

  [[nodiscard]] TurnedRings turn(const std::optional<Box>& unsure) {
    turn_bodies();
    turn_holes_of_turned();
    turn_islands();
    if (unsure) turn_hole_walls(*unsure);
    return turned_;
  }

  enum class Count { kAll, kCounterClockwise };

  // The windings of all rings but one at its samples, those beside a contour left out; empty when
  // there is no time left for it.
  [[nodiscard]] std::vector<int> others_at(const std::vector<Point>& samples, std::size_t but,
                                           Count count) {
    std::vector<int> sums;
    for (const Point p : samples) {
      if (work_ > kTurnWorkMax) return {};
      int sum = 0;
      bool clear = true;
      for (std::size_t i = 0; i < rings_.size() && clear; ++i) {
        if (i == but || !holds(boxes_[i], p)) continue;
        if (clockwise_[i] && count == Count::kCounterClockwise) continue;
        work_ += static_cast<std::int64_t>(rings_[i].size());
        const std::optional<int> one = winding(rings_[i], p);
        clear = one.has_value();
        sum += one.value_or(0);
      }
      if (clear) sums.push_back(sum);
    }
    return sums;
  }

 private:
  static bool holds(const Box& box, Point p) {
    return p.x >= box.min.x - kBesideUnits && p.x <= box.max.x + kBesideUnits &&
           p.y >= box.min.y - kBesideUnits && p.y <= box.max.y + kBesideUnits;
  }

  void reverse(std::size_t ring) {
    std::reverse(rings_[ring].begin() + 1, rings_[ring].end());
    clockwise_[ring] = !clockwise_[ring];
    ++turned_.count;
    if (!turned_.first) turned_.first = rings_[ring].front();
  }

  // Clockwise ones that stand out of all that run counter-clockwise.
  void turn_bodies() {
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (!clockwise_[i]) continue;
      const std::vector<int> others = others_at(samples_of(rings_[i]), i, Count::kCounterClockwise);
      if (std::count(others.begin(), others.end(), 0) >= kTurnSamplesOut) bodies_.push_back(i);
    }
    for (const std::size_t body : bodies_) reverse(body);
  }

  // Clockwise ones that lie in a hole with all their length.
  void turn_islands() {
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (!clockwise_[i]) continue;
      const std::vector<int> others = others_at(samples_of(rings_[i]), i, Count::kAll);
      const bool in_hole = std::all_of(others.begin(), others.end(), [](int w) { return w <= 0; });
      if (in_hole && static_cast<int>(others.size()) >= kTurnSamplesOut) reverse(i);
    }
  }

  // Counter-clockwise ones that lie in more turned bodies than in others.
  void turn_holes_of_turned() {
    std::vector<bool> is_body(rings_.size(), false);
    for (const std::size_t body : bodies_) is_body[body] = true;
    std::vector<std::size_t> holes;
    for (std::size_t i = 0; i < rings_.size() && !bodies_.empty(); ++i) {
      if (is_body[i] || clockwise_[i]) continue;
      int bodies = 0, others = 0;
      for (std::size_t j = 0; j < rings_.size(); ++j) {
        if (j == i || clockwise_[j] || !boxes_[j].overlaps(boxes_[i]) || !lies_within(i, j))
          continue;
        ++(is_body[j] ? bodies : others);
      }
      if (bodies > others) holes.push_back(i);
    }
    for (const std::size_t hole : holes) reverse(hole);
  }

  [[nodiscard]] bool lies_within(std::size_t inner, std::size_t outer) {
    work_ += kTurnSamples * static_cast<std::int64_t>(rings_[outer].size());
    if (work_ > kTurnWorkMax) return false;
    int inside = 0;
    for (const Point p : samples_of(rings_[inner])) {
      const std::optional<int> one = winding(rings_[outer], p);
      if (!one) continue;
      if (*one == 0) return false;
      ++inside;
    }
    return inside >= kTurnSamplesOut;
  }

  // Counter-clockwise ones all along which the others enclose it already, from the outside in.
  void turn_hole_walls(const Box& unsure) {
    std::vector<std::size_t> order(rings_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> areas;
    for (const Ring& ring : rings_) areas.push_back(std::abs(doubled_area_units(ring)));
    std::sort(order.begin(), order.end(), [&areas](std::size_t a, std::size_t b) {
      return areas[a] != areas[b] ? areas[a] > areas[b] : a < b;
    });
    for (const std::size_t i : order) {
      if (clockwise_[i] || !(unsure.empty() || boxes_[i].overlaps(unsure))) continue;
      const std::vector<int> others = others_at(samples_of(rings_[i]), i, Count::kAll);
      const bool within = std::all_of(others.begin(), others.end(), [](int w) { return w >= 1; });
      if (within && static_cast<int>(others.size()) >= kTurnSamplesOut) reverse(i);
    }
  }

  std::vector<Ring>& rings_;
  std::vector<Box> boxes_;
  std::vector<bool> clockwise_;
  std::vector<std::size_t> bodies_;  // that were turned
  std::int64_t work_ = 0;
  TurnedRings turned_;
};

// Where rings wind around the other way, a corner of it; nothing where that is only slivers, as
// where contours touch.
std::optional<Point> broad_reverse(std::vector<Ring> rings) {
  for (Ring& ring : rings) std::reverse(ring.begin(), ring.end());
  const Region reverse = clean(rings, FillRule::kPositive);
  for (const Ring& ring : reverse.rings()) {
    double length = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      length += distance_units(ring[i], ring[(i + 1) % ring.size()]);
    }
    if (std::abs(doubled_area_units(ring)) > kSliverUnits * length) return ring.front();
  }
  return std::nullopt;
}

}  // namespace

TurnedRings turn_inside_out(std::vector<Ring>& rings, const std::optional<Box>& unsure) {
  const std::optional<Point> reverse = broad_reverse(rings);
  if (!unsure && !reverse) return {};
  TurnedRings turned = Turner(rings).turn(unsure);
  if (turned.count == 0 && reverse) turned = {1, reverse};
  return turned;
}

bool stands_out(const Ring& ring, const std::vector<Ring>& rings) {
  std::vector<Ring> others = rings;
  const std::vector<int> windings =
      Turner(others).others_at(samples_of(ring), rings.size(), Turner::Count::kAll);
  return std::count(windings.begin(), windings.end(), 0) >= kTurnSamplesOut;
}

}  // namespace core
