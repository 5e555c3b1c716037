#include "tests/support/region_checks.h"

#include <algorithm>
#include <cmath>

#include "core/booleans/boolean.h"
#include "core/units.h"

namespace test {

using core::cross;
using core::Island;
using core::Point;
using core::Region;
using core::Ring;
using core::Segment;

namespace {

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

// An interior crossing, or a stretch in common.
bool cross_or_overlap(const Segment& a, const Segment& b) {
  const int b0 = sign(cross(a.from, a.to, b.from)), b1 = sign(cross(a.from, a.to, b.to));
  const int a0 = sign(cross(b.from, b.to, a.from)), a1 = sign(cross(b.from, b.to, a.to));
  if (b0 == 0 && b1 == 0) {
    return std::max(std::min(a.from, a.to), std::min(b.from, b.to)) <
           std::min(std::max(a.from, a.to), std::max(b.from, b.to));
  }
  return b0 * b1 < 0 && a0 * a1 < 0;
}

long double exact(std::int64_t value) { return static_cast<long double>(value); }

// Winding number just left of the point a + (b - a) · k / 8, exactly: coordinates times 8, and a
// step to the left that is smaller than anything. Returns -1000 if another edge runs through it.
int winding_beside(const std::vector<Segment>& edges, std::size_t which, std::int64_t k) {
  const Segment& own = edges[which];
  const std::int64_t dx = std::int64_t{own.to.x} - own.from.x;
  const std::int64_t dy = std::int64_t{own.to.y} - own.from.y;
  const std::int64_t px = 8 * std::int64_t{own.from.x} + k * dx;
  const std::int64_t py = 8 * std::int64_t{own.from.y} + k * dy;
  int winding = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::int64_t ax = 8 * std::int64_t{edges[i].from.x}, bx = 8 * std::int64_t{edges[i].to.x};
    const std::int64_t ay = 8 * std::int64_t{edges[i].from.y}, by = 8 * std::int64_t{edges[i].to.y};
    // The step to the left is (-dy, dx) · ε: it decides ties of a vertex at the ray's height.
    const auto above = [&](std::int64_t y) { return y != py ? y > py : dx < 0; };
    long double turn = exact(bx - ax) * exact(py - ay) - exact(by - ay) * exact(px - ax);
    if (i == which) {
      turn = 1;  // the step goes to its left
    } else if (turn == 0 && std::min(ax, bx) <= px && px <= std::max(ax, bx) &&
               std::min(ay, by) <= py && py <= std::max(ay, by)) {
      return -1000;
    }
    if (!above(ay) && above(by) && turn > 0) ++winding;
    if (above(ay) && !above(by)) {
      if (i == which ? false : turn < 0) --winding;
    }
  }
  return winding;
}

}  // namespace

bool is_clean(const Region& region) {
  for (const Ring& ring : region.rings()) {
    if (ring.size() < 3 || core::doubled_area_units(ring) == 0) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (ring[i] == ring[(i + 1) % ring.size()]) return false;
    }
  }
  const std::vector<Segment> edges = edges_of(region.rings());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      if (cross_or_overlap(edges[i], edges[j])) return false;
    }
    bool known = false;
    for (std::int64_t k = 1; k < 8 && !known; ++k) {
      const int winding = winding_beside(edges, i, k);
      known = winding != -1000;
      if (known && winding != 1) return false;
    }
    if (!known) return false;
  }
  return true;
}

int winding_number(const std::vector<Ring>& rings, double x, double y) {
  int winding = 0;
  for (const Segment& edge : edges_of(rings)) {
    const double turn = (static_cast<double>(edge.to.x) - edge.from.x) * (y - edge.from.y) -
                        (static_cast<double>(edge.to.y) - edge.from.y) * (x - edge.from.x);
    if (edge.from.y <= y && edge.to.y > y && turn > 0) ++winding;
    if (edge.to.y <= y && edge.from.y > y && turn < 0) --winding;
  }
  return winding;
}

double distance_to_boundary(const std::vector<Ring>& rings, double x, double y) {
  double nearest = 1e300;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double dx = static_cast<double>(b.x) - a.x, dy = static_cast<double>(b.y) - a.y;
      const double along = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy);
      const double t = std::clamp(along, 0.0, 1.0);
      const double ex = x - a.x - t * dx, ey = y - a.y - t * dy;
      nearest = std::min(nearest, ex * ex + ey * ey);
    }
  }
  return std::sqrt(nearest);
}

double distance_to_segment(Point point, const Segment& segment) {
  return distance_to_boundary({{segment.from, segment.to}}, point.x, point.y);
}

double signed_distance(const Region& region, double x, double y) {
  const double distance = distance_to_boundary(region.rings(), x, y);
  return winding_number(region.rings(), x, y) > 0 ? distance : -distance;
}

double widest_difference(const Region& a, const Region& b) {
  double widest = 0;
  for (Island& island : core::islands(core::exclusive_or(a, b))) {
    const Region piece = core::region_of(std::move(island));
    widest = std::max(widest, 2 * piece.area_mm2() / piece.perimeter_mm() * core::kUnitsPerMm);
  }
  return widest;
}

double boundary_distance(const Region& a, const Region& b) {
  double farthest = 0;
  for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
    for (const Ring& ring : from->rings()) {
      for (const Point p : ring) {
        farthest = std::max(farthest, distance_to_boundary(to->rings(), p.x, p.y));
      }
    }
  }
  return farthest;
}

}  // namespace test
