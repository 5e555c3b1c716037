#include "core/regions/simplify.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
void straighten(const Ring& ring, double tolerance, Ring& kept) {
  kept.assign(1, ring.front());
  Sleeve sleeve(ring.front(), tolerance);
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Point next = i + 1 == ring.size() ? ring.front() : ring[i + 1];
    sleeve.take(ring[i]);
    if (sleeve.holds(next)) continue;
    kept.push_back(ring[i]);
    sleeve = Sleeve(ring[i], tolerance);
  }
}

std::size_t farthest_from_first(const Ring& ring) {
  std::size_t farthest = 0;
  double farthest_squared = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Vector d = towards(ring.front(), ring[i]);
    const double squared = dot(d, d);
    if (squared > farthest_squared) farthest = i, farthest_squared = squared;
  }
  return farthest;
}

// Replaces runs of points by their chords. Its memory is used again for the next ring.
class ChordSplitter {
 public:
  // Indices of the points to keep, in ascending order.
  const std::vector<std::size_t>& split(const Ring& ring, double tolerance) {
    ring_ = &ring;
    squared_tolerance_ = tolerance * tolerance;
    keep_.assign(ring.size(), 0);
    const std::size_t far = farthest_from_first(ring);
    fixed_.clear();
    for (std::size_t i = 0; i < far; i += kSimplifyRunMax) fixed_.push_back(i);
    for (std::size_t i = far; i < ring.size(); i += kSimplifyRunMax) fixed_.push_back(i);
    for (std::size_t i = 0; i < fixed_.size(); ++i) {
      keep_[fixed_[i]] = 1;
      split_run(fixed_[i], i + 1 < fixed_.size() ? fixed_[i + 1] : ring.size());
    }
    kept_.clear();
    for (std::size_t i = 0; i < keep_.size(); ++i) {
      if (keep_[i] != 0) kept_.push_back(i);
    }
    drop_unasked();
    return kept_;
  }

 private:
  // Marks the points to keep between two that are kept. `last` may be the ring's size: the first
  // point again.
  void split_run(std::size_t first, std::size_t last) {
    runs_.clear();
    runs_.emplace_back(first, last);
    while (!runs_.empty()) {
      const auto [from, to] = runs_.back();
      runs_.pop_back();
      const auto [farthest, squared] = farthest_between(from, to);
      if (squared <= squared_tolerance_) continue;
      keep_[farthest] = 1;
      runs_.emplace_back(from, farthest);
      runs_.emplace_back(farthest, to);
    }
  }

  // The points it started with were kept without being asked for.
  void drop_unasked() {
    for (std::size_t i = 0; i < kept_.size() && kept_.size() > 3;) {
      const bool unasked = std::binary_search(fixed_.begin(), fixed_.end(), kept_[i]);
      const std::size_t before = i > 0 ? kept_[i - 1] : kept_.back();
      std::size_t after = i + 1 < kept_.size() ? kept_[i + 1] : kept_.front();
      if (after <= before) after += ring_->size();
      if (unasked && farthest_between(before, after).second <= squared_tolerance_) {
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
  }

  [[nodiscard]] Point at(std::size_t index) const {
    return (*ring_)[index < ring_->size() ? index : index - ring_->size()];
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

  const Ring* ring_ = nullptr;
  double squared_tolerance_ = 0;
  std::vector<std::uint8_t> keep_;  // by point
  std::vector<std::pair<std::size_t, std::size_t>> runs_;
  std::vector<std::size_t> fixed_;
  std::vector<std::size_t> kept_;
};

// Each thread keeps this, so that the result alone is allocated.
struct Scratch {
  Ring distinct;
  Ring straight;
  ChordSplitter splitter;
};

}  // namespace

Ring simplify(const Ring& ring, Length tolerance) {
  thread_local Scratch scratch;
  const double units = static_cast<double>(tolerance.units());
  Ring& distinct = scratch.distinct;
  distinct.clear();
  for (const Point p : ring) {
    if (distinct.empty() || distinct.back() != p) distinct.push_back(p);
  }
  while (distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
  if (distinct.size() < 3) return {};
  start_at_lowest(distinct);
  Ring& straight = scratch.straight;
  straighten(distinct, std::min(units, kRoundingUnits), straight);
  if (straight.size() < 3) return {};
  Ring result;
  if (units > kRoundingUnits) {
    const std::vector<std::size_t>& kept = scratch.splitter.split(straight, units);
    if (kept.size() < 3) return {};
    result.reserve(kept.size());
    for (const std::size_t index : kept) result.push_back(straight[index]);
  } else {
    result = straight;
  }
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
