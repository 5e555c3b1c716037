#include "core/offsets/slice_step.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/geometry.h"               // Point, Ring
#include "core/regions/contact_check.h"  // surely_clean
#include "core/vector.h"                 // Vector, dot

namespace core {
namespace {

// Once round a ring, from a place to the same place: as a line of corners with that place at both
// ends.
class Walker {
 public:
  // `share`: how far along the edge from `corner` the place is, 0 … 1.
  Walker(const Ring& ring, std::size_t corner, double share)
      : ring_(&ring), corner_(corner), left_(ring.size() + 1), here_(to_vector(ring[corner])) {
    const Vector edge = to_vector(ring[corner + 1 < ring.size() ? corner + 1 : 0]) - here_;
    start_ = here_ = here_ + edge * share;
    aim();
  }

  [[nodiscard]] bool arrived() const { return left_ == 0; }
  [[nodiscard]] Vector here() const { return here_; }
  [[nodiscard]] Vector next() const { return next_; }

  // The place nearest to p on the way to the next corner.
  [[nodiscard]] Vector nearest(Vector p) const {
    const Vector way = next_ - here_;
    const double length2 = dot(way, way);
    const double share = length2 > 0 ? std::clamp(dot(p - here_, way) / length2, 0.0, 1.0) : 0;
    return here_ + way * share;
  }

  void go_to(Vector place) { here_ = place; }

  void pass() {
    here_ = next_;
    if (--left_ > 0) aim();
  }

 private:
  void aim() {
    corner_ = corner_ + 1 < ring_->size() ? corner_ + 1 : 0;
    next_ = left_ == 1 ? start_ : to_vector((*ring_)[corner_]);
  }

  const Ring* ring_;
  std::size_t corner_;
  std::size_t left_;  // corners to come, the place where it started among them
  Vector here_, start_{}, next_{};
};

double squared_distance(Vector a, Vector b) { return dot(a - b, a - b); }

// The walker along `ring` that starts at the place nearest to p.
Walker nearest_start(const Ring& ring, Vector p) {
  std::size_t best = 0;
  double best_share = 0, least = std::numeric_limits<double>::max();
  Vector a = to_vector(ring.front());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector b = to_vector(ring[i + 1 < ring.size() ? i + 1 : 0]);
    const Vector edge = b - a;
    const double share = std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
    const double away = squared_distance(p, a + edge * share);
    if (away < least) {
      least = away;
      best = i;
      best_share = share;
    }
    a = b;
  }
  return {ring, best, best_share};
}

// The longest leash, squared; more than `most` when it gets so long.
double leash_squared(const Ring& ring, const Ring& other, double most) {
  Walker a(ring, 0, 0);
  Walker b = nearest_start(other, a.here());
  double longest = squared_distance(a.here(), b.here());
  while (!a.arrived() || !b.arrived()) {
    if (longest > most) return longest;
    // Either goes on to its next corner, and the other as near to it as it may.
    constexpr double kNever = std::numeric_limits<double>::max();
    const Vector beside_a = b.arrived() ? b.here() : b.nearest(a.next());
    const Vector beside_b = a.arrived() ? a.here() : a.nearest(b.next());
    const double with_a = a.arrived() ? kNever : squared_distance(a.next(), beside_a);
    const double with_b = b.arrived() ? kNever : squared_distance(b.next(), beside_b);
    if (with_a <= with_b) {
      a.pass();
      if (!b.arrived()) b.go_to(beside_a);
      longest = std::max(longest, with_a);
    } else {
      b.pass();
      if (!a.arrived()) a.go_to(beside_b);
      longest = std::max(longest, with_b);
    }
  }
  return longest;
}

// Whether `smaller` lies within `larger`, told by those of their rings that differ.
bool surely_within(const std::vector<Ring>& larger, const std::vector<Ring>& smaller) {
  std::vector<Ring> between;
  for (std::size_t i = 0; i < larger.size(); ++i) {
    if (larger[i] == smaller[i]) continue;
    between.push_back(larger[i]);
    between.emplace_back(smaller[i].rbegin(), smaller[i].rend());
  }
  return surely_clean(between);
}

}  // namespace

SliceStep slice_step(const Region& below, const Region& above, Length small, Length most) {
  const std::vector<Ring>&from = below.rings(), &to = above.rings();
  if (from.size() != to.size()) return {};
  const auto units = static_cast<double>(most.units());
  double longest = 0, doubled_growth = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == to[i]) continue;
    longest = std::max(longest, leash_squared(from[i], to[i], units * units));
    if (longest > units * units) return {};
  }
  const Length leash = Length::from_units(static_cast<std::int64_t>(std::ceil(std::sqrt(longest))));
  SliceStep step{leash, leash};
  if (leash <= small) return step;
  for (std::size_t i = 0; i < from.size(); ++i) {
    doubled_growth += doubled_area_units(to[i]) - doubled_area_units(from[i]);
  }
  const bool grows = doubled_growth > 0;
  if (surely_within(grows ? to : from, grows ? from : to)) {
    (grows ? step.inwards : step.outwards) = Length();
  }
  return step;
}

}  // namespace core
