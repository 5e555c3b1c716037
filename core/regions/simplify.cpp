#include "core/regions/simplify.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/vector.h"  // Vector, dot, cross

namespace core {
namespace {

// Rounding moves a point by at most 0.71 units, and a line between two such points as much.
constexpr double kRoundingUnits = 1;

Vector towards(Point from, Point to) { return to_vector(to) - to_vector(from); }

// How far p is from the straight line from a to b, squared.
double squared_distance(Point p, Point a, Point b) {
  const Vector along = towards(a, b), to_p = towards(a, p);
  const double squared = dot(along, along), place = dot(along, to_p);
  if (place <= 0) return dot(to_p, to_p);
  if (place >= squared) {
    const Vector from_b = towards(b, p);
    return dot(from_b, from_b);
  }
  const auto doubled_area = static_cast<double>(cross(a, b, p));
  return doubled_area * doubled_area / squared;
}

void start_at_lowest(Ring& ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
}

// The directions that pass every point since `from` within the tolerance.
class Sleeve {
 public:
  Sleeve(Point from, double tolerance) : from_(from), tolerance_(tolerance) {}

  // Whether a line to `to` passes all points taken so far.
  [[nodiscard]] bool holds(Point to) const {
    if (empty_) return true;
    const Vector d = towards(from_, to);
    return cross(right_, d) >= 0 && cross(d, left_) >= 0 && dot(d, last_) >= dot(last_, last_);
  }

  void take(Point to) {
    last_ = towards(from_, to);
    const double length = std::sqrt(dot(last_, last_));
    if (length <= tolerance_) return;
    // Turned by the angle at which the tolerance is seen.
    const double sine = tolerance_ / length, cosine = std::sqrt(1 - sine * sine);
    const Vector left{last_.x * cosine - last_.y * sine, last_.y * cosine + last_.x * sine};
    const Vector right{last_.x * cosine + last_.y * sine, last_.y * cosine - last_.x * sine};
    left_ = empty_ || cross(left, left_) > 0 ? left : left_;
    right_ = empty_ || cross(right, right_) < 0 ? right : right_;
    empty_ = false;
  }

 private:
  Point from_;
  double tolerance_;
  Vector last_, left_, right_;
  bool empty_ = true;
};

// Drops points that a straight line passes; the ring starts at a point that is kept.
Ring straightened(const Ring& ring, double tolerance) {
  Ring kept{ring.front()};
  Sleeve sleeve(ring.front(), tolerance);
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Point next = i + 1 == ring.size() ? ring.front() : ring[i + 1];
    sleeve.take(ring[i]);
    if (sleeve.holds(next)) continue;
    kept.push_back(ring[i]);
    sleeve = Sleeve(ring[i], tolerance);
  }
  return kept;
}

// Marks the points to keep between two that are kept.
class ChordSplitter {
 public:
  ChordSplitter(const Ring& ring, double tolerance)
      : ring_(ring), squared_tolerance_(tolerance * tolerance), keep_(ring.size(), false) {}

  void keep(std::size_t index) { keep_[index] = true; }

  // `last` may be ring.size(): the first point again.
  void split(std::size_t first, std::size_t last) {
    runs_.emplace_back(first, last);
    while (!runs_.empty()) {
      const auto [from, to] = runs_.back();
      runs_.pop_back();
      const auto [farthest, squared] = farthest_between(from, to);
      if (squared <= squared_tolerance_) continue;
      keep_[farthest] = true;
      runs_.emplace_back(from, farthest);
      runs_.emplace_back(farthest, to);
    }
  }

  // The points kept, in ascending order.
  [[nodiscard]] std::vector<std::size_t> kept() const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < keep_.size(); ++i) {
      if (keep_[i]) indices.push_back(i);
    }
    return indices;
  }

  [[nodiscard]] bool chord_passes(std::size_t from, std::size_t to) const {
    return farthest_between(from, to).second <= squared_tolerance_;
  }

 private:
  [[nodiscard]] Point at(std::size_t index) const {
    return ring_[index < ring_.size() ? index : index - ring_.size()];
  }

  // With its distance squared.
  [[nodiscard]] std::pair<std::size_t, double> farthest_between(std::size_t from,
                                                                std::size_t to) const {
    std::pair<std::size_t, double> farthest{from, -1};
    const Point a = at(from), b = at(to);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double squared = squared_distance(at(i), a, b);
      if (squared > farthest.second) farthest = {i, squared};
    }
    return farthest;
  }

  const Ring& ring_;
  double squared_tolerance_;
  std::vector<bool> keep_;
  std::vector<std::pair<std::size_t, std::size_t>> runs_;
};

std::size_t farthest_from_first(const Ring& ring) {
  const auto squared = [&ring](Point p) {
    const Vector d = towards(ring.front(), p);
    return dot(d, d);
  };
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (squared(ring[i]) > squared(ring[farthest])) farthest = i;
  }
  return farthest;
}

Ring with_chords(const Ring& ring, double tolerance) {
  const std::size_t far = farthest_from_first(ring);
  ChordSplitter splitter(ring, tolerance);
  std::vector<std::size_t> fixed;
  for (std::size_t i = 0; i < far; i += kSimplifyRunMax) fixed.push_back(i);
  for (std::size_t i = far; i < ring.size(); i += kSimplifyRunMax) fixed.push_back(i);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    splitter.keep(fixed[i]);
    splitter.split(fixed[i], i + 1 < fixed.size() ? fixed[i + 1] : ring.size());
  }
  std::vector<std::size_t> kept = splitter.kept();
  // The points it started with were kept without being asked for.
  for (std::size_t i = 0; i < kept.size() && kept.size() > 3;) {
    const bool unasked = std::binary_search(fixed.begin(), fixed.end(), kept[i]);
    const std::size_t before = i > 0 ? kept[i - 1] : kept.back();
    std::size_t after = i + 1 < kept.size() ? kept[i + 1] : kept.front();
    if (after <= before) after += ring.size();
    if (unasked && splitter.chord_passes(before, after)) {
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  Ring result;
  for (const std::size_t index : kept) result.push_back(ring[index]);
  return result;
}

}  // namespace

Ring simplify(const Ring& ring, Length tolerance) {
  const double units = static_cast<double>(tolerance.units());
  Ring result;
  for (const Point p : ring) {
    if (result.empty() || result.back() != p) result.push_back(p);
  }
  while (result.size() > 1 && result.front() == result.back()) result.pop_back();
  if (result.size() < 3) return {};
  start_at_lowest(result);
  result = straightened(result, std::min(units, kRoundingUnits));
  if (result.size() < 3) return {};
  if (units > kRoundingUnits) result = with_chords(result, units);
  if (result.size() < 3) return {};
  start_at_lowest(result);
  return result;
}

std::vector<std::size_t> kept_points(const std::vector<Point>& line, Length tolerance) {
  if (line.empty()) return {};
  std::vector<std::size_t> kept;
  kept.reserve(line.size());
  kept.push_back(0);
  Sleeve sleeve(line.front(), static_cast<double>(tolerance.units()));
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    sleeve.take(line[i]);
    if (sleeve.holds(line[i + 1])) continue;
    kept.push_back(i);
    sleeve = Sleeve(line[i], static_cast<double>(tolerance.units()));
  }
  if (line.size() > 1) kept.push_back(line.size() - 1);
  return kept;
}

}  // namespace core
