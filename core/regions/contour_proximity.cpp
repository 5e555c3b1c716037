#include "core/regions/contour_proximity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/geometry.h"              // Point, Ring
#include "core/regions/polyline.h"      // between, distance_mm
#include "core/regions/segment_grid.h"  // SegmentGrid
#include "core/vector.h"                // Vector, dot

namespace core {
namespace {

double squared_distance(Vector a, Vector b) { return dot(a - b, a - b); }

// Goes forward along a ring, from corner to corner or to a place before the next one.
class Walker {
 public:
  Walker(const Ring& ring, std::size_t corner) : ring_(&ring), next_corner_(corner) {
    next_ = to_vector(ring[corner]);
    pass();
  }

  [[nodiscard]] Vector next() const { return next_; }

  // Where along the edge that it is on the place nearest to p is: 0 its start, 1 its end.
  [[nodiscard]] double share_at(Vector p) const { return dot(p - from_, along_) * per_length2_; }

  // The place there, but neither behind where it is nor beyond the edge.
  [[nodiscard]] Vector ahead(double share) const {
    const double t = std::min(std::max(share, share_), 1.0);
    return from_ + along_ * t;
  }

  void go_to(double share) { share_ = std::min(std::max(share, share_), 1.0); }

  // On to the next corner.
  void pass() {
    from_ = next_;
    next_corner_ = next_corner_ + 1 < ring_->size() ? next_corner_ + 1 : 0;
    next_ = to_vector((*ring_)[next_corner_]);
    along_ = next_ - from_;
    const double length2 = dot(along_, along_);
    per_length2_ = length2 > 0 ? 1 / length2 : 0;
    share_ = 0;
  }

 private:
  const Ring* ring_;
  std::size_t next_corner_;
  Vector from_, next_, along_;
  double per_length2_ = 0;
  double share_ = 0;
};

// Moves `ahead` to its next corner, and `beside` as near to it as it may go. False, and nothing is
// moved, when that is out of reach.
bool advance(Walker& ahead, Walker& beside, double share, double reach2) {
  if (squared_distance(ahead.next(), beside.ahead(share)) > reach2) return false;
  beside.go_to(share);
  ahead.pass();
  return true;
}

// The corner before the ring's place that is nearest to p, as a rule: beside the nearest corner.
std::size_t start_corner(const Ring& ring, Vector p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double away = squared_distance(p, to_vector(ring[i]));
    if (away >= least) continue;
    least = away;
    best = i;
  }
  const std::size_t before = best > 0 ? best - 1 : ring.size() - 1;
  const Walker last(ring, before);
  return squared_distance(p, last.ahead(last.share_at(p))) < least ? before : best;
}

bool frechet_within(const Ring& ring, const Ring& other, double reach2) {
  const Vector start = to_vector(ring.front());
  Walker a(ring, 0);
  Walker b(other, start_corner(other, start));
  b.go_to(b.share_at(start));
  if (squared_distance(start, b.ahead(0)) > reach2) return false;
  const std::size_t steps_max = 2 * (ring.size() + other.size());
  std::size_t passed = 0;
  for (std::size_t i = 0; i < steps_max && passed < ring.size(); ++i) {
    // The walker whose corner comes first goes there; if that is too far, the other one.
    const double b_share = b.share_at(a.next());
    if (b_share < 1 && advance(a, b, b_share, reach2)) {
      ++passed;
    } else if (!advance(b, a, a.share_at(b.next()), reach2)) {
      if (b_share < 1 || !advance(a, b, b_share, reach2)) return false;
      ++passed;
    }
  }
  return passed == ring.size();
}

// Goes through rings of like first points, on both sides of number `ring`, for one that it is near
// and that is not taken. Their count where there is none.
std::size_t ring_near(const std::vector<Ring>& rings, std::size_t number,
                      const std::vector<Ring>& others, const std::vector<bool>& taken,
                      double reach) {
  const auto x = static_cast<double>(rings[number].front().x);
  const auto alike = [&](std::size_t i) { return std::abs(others[i].front().x - x) <= reach; };
  const auto fits = [&](std::size_t i) {
    return !taken[i] && frechet_within(rings[number], others[i], reach * reach);
  };
  for (std::size_t i = number + 1; i < others.size() && alike(i); ++i) {
    if (fits(i)) return i;
  }
  for (std::size_t i = number; i > 0 && alike(i - 1); --i) {
    if (fits(i - 1)) return i - 1;
  }
  return others.size();
}

}  // namespace

bool frechet_within(const Region& contours, const Region& others, Length reach) {
  const std::vector<Ring>&rings = contours.rings(), &beside = others.rings();
  if (rings.size() != beside.size()) return false;
  const auto units = static_cast<double>(reach.units());
  std::vector<bool> taken;  // of the others, once a ring is not near that of its number
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const bool free = taken.empty() || !taken[i];
    std::size_t near = i;
    if (!free || !frechet_within(rings[i], beside[i], units * units)) {
      if (taken.empty()) {
        taken.resize(rings.size());
        std::fill_n(taken.begin(), i, true);
      }
      near = ring_near(rings, i, beside, taken, units);
      if (near == rings.size()) return false;
    }
    if (!taken.empty()) taken[near] = true;
  }
  return true;
}

bool stays_near(const Region& contours, const Region& others, Length reach, Length step) {
  if (frechet_within(contours, others, reach)) return true;
  const SegmentGrid grid(reach, others);
  for (const Ring& ring : contours.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      const int parts = 1 + static_cast<int>(distance_mm(a, b) / step.mm());
      for (int part = 0; part < parts; ++part) {
        if (!grid.any_within(between(a, b, part / static_cast<double>(parts)), reach)) return false;
      }
    }
  }
  return true;
}

}  // namespace core
