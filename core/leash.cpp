#include "core/leash.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/geometry.h"  // Point, Ring

namespace core {
namespace {

struct Place {
  double x = 0;
  double y = 0;
};

Place place(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

double squared(Place a, Place b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

// The point of the straight line from a to b that is nearest to p.
Place nearest(Place p, Place a, Place b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  if (length2 == 0) return a;
  const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0);
  return {a.x + t * dx, a.y + t * dy};
}

// Goes forward along a ring, from corner to corner or to a place before the next one.
struct Walker {
  Walker(const Ring& on, std::size_t from)
      : ring(&on), corner(from), at(place(on[from])), next(place(after(from))) {}

  [[nodiscard]] Point after(std::size_t i) const {
    return (*ring)[i + 1 < ring->size() ? i + 1 : 0];
  }

  void go_to_next() {
    at = next;
    corner = corner + 1 < ring->size() ? corner + 1 : 0;
    next = place(after(corner));
  }

  const Ring* ring;
  std::size_t corner;
  Place at;
  Place next;
};

// Goes on to the next corner of `ahead`, and with `beside` to the nearest place that is not behind
// it and not beyond its own next corner. False when the leash is too short for that.
bool go_on(Walker& ahead, Walker& beside, double reach2) {
  const Place place = nearest(ahead.next, beside.at, beside.next);
  if (squared(ahead.next, place) > reach2) return false;
  beside.at = place;
  ahead.go_to_next();
  return true;
}

// Whether `p` lies beyond the next corner, seen along the way there.
bool beyond(Place p, const Walker& walker) {
  const double dx = walker.next.x - walker.at.x, dy = walker.next.y - walker.at.y;
  return (p.x - walker.next.x) * dx + (p.y - walker.next.y) * dy >= 0;
}

// The corner before the ring's place that is nearest to p, as a rule: beside the nearest corner.
std::size_t start_corner(const Ring& ring, Place p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double away = squared(p, place(ring[i]));
    if (away >= least) continue;
    least = away;
    best = i;
  }
  const std::size_t before = best > 0 ? best - 1 : ring.size() - 1;
  const Place at_best = place(ring[best]);
  const Place on_last = nearest(p, place(ring[before]), at_best);
  return squared(p, on_last) < least ? before : best;
}

bool leashed(const Ring& ring, const Ring& other, double reach2) {
  Walker a(ring, 0);
  Walker b(other, start_corner(other, a.at));
  b.at = nearest(a.at, b.at, b.next);
  if (squared(a.at, b.at) > reach2) return false;
  const std::size_t steps_max = 2 * (ring.size() + other.size());
  std::size_t passed = 0;
  for (std::size_t i = 0; i < steps_max && passed < ring.size(); ++i) {
    // Whoever's corner comes first goes there; the other one when the leash is too short.
    bool a_goes = !beyond(a.next, b);
    if (!(a_goes ? go_on(a, b, reach2) : go_on(b, a, reach2))) {
      a_goes = !a_goes;
      if (!(a_goes ? go_on(a, b, reach2) : go_on(b, a, reach2))) return false;
    }
    passed += a_goes ? 1 : 0;
  }
  return passed == ring.size();
}

}  // namespace

bool leashed(const Region& contours, const Region& others, Length reach) {
  if (contours.rings().size() != others.rings().size()) return false;
  const auto units = static_cast<double>(reach.units());
  for (std::size_t i = 0; i < contours.rings().size(); ++i) {
    if (!leashed(contours.rings()[i], others.rings()[i], units * units)) return false;
  }
  return true;
}

}  // namespace core
