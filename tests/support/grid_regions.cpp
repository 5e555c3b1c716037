#include "tests/support/grid_regions.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tests/support/region_checks.h"  // is_clean

namespace test {
namespace {

using core::Point;
using core::Region;
using core::Ring;

// Oriented edges whose reverse cancels them.
using Boundary = std::multimap<Point, Point>;

void add_triangle(Boundary& boundary, Point a, Point b, Point c) {
  const std::pair<Point, Point> edges[] = {{a, b}, {b, c}, {c, a}};
  for (const auto& [from, to] : edges) {
    const auto [first, last] = boundary.equal_range(to);
    const auto opposite =
        std::find_if(first, last, [p = from](const auto& edge) { return edge.second == p; });
    if (opposite != last) {
      boundary.erase(opposite);
    } else {
      boundary.emplace(from, to);
    }
  }
}

// Rings that turn as far left as they can where several go on: wedges of the inside stay apart.
std::vector<Ring> link(Boundary& boundary) {
  std::vector<Ring> rings;
  while (!boundary.empty()) {
    Ring ring;
    auto edge = boundary.begin();
    for (;;) {
      const Point from = edge->first, to = edge->second;
      boundary.erase(edge);
      ring.push_back(from);
      if (to == ring.front()) break;
      const auto [first, last] = boundary.equal_range(to);
      edge = first;
      for (auto other = first; other != last; ++other) {
        if (core::cross(from, to, other->second) > core::cross(from, to, edge->second))
          edge = other;
      }
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

std::vector<Ring> random_cells(Random& random) {
  Boundary boundary;
  const int size = random.integer(2, 9);
  const double fill = random.between(0.3, 0.8);
  for (int x = 0; x < size; ++x) {
    for (int y = 0; y < size; ++y) {
      const Point corners[] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
      const bool first = random.unit() < fill;
      const bool second = random.unit() < 0.6 ? first : random.unit() < fill;
      const int turn = random.integer(0, 1);
      const auto corner = [&](int i) { return corners[(i + turn) % 4]; };
      if (first) add_triangle(boundary, corner(0), corner(1), corner(2));
      if (second) add_triangle(boundary, corner(0), corner(2), corner(3));
    }
  }
  return link(boundary);
}

std::vector<Ring> random_rings(Random& random) {
  std::vector<Ring> rings;
  const int count = random.integer(1, 3);
  for (int i = 0; i < count; ++i) {
    Ring ring;
    const int points = random.integer(3, i == 0 ? 9 : 6);
    for (int k = 0; k < points; ++k) {
      ring.push_back({random.integer(0, 16), random.integer(0, 16)});
    }
    const bool outer = i == 0 || random.integer(0, 1) == 0;
    if ((core::doubled_area_units(ring) > 0) != outer) std::reverse(ring.begin(), ring.end());
    rings.push_back(std::move(ring));
  }
  return rings;
}

Point moved(Point p, int motion, int scale) {
  p = {p.x * scale, p.y * scale};
  if (motion == 1) return {-p.y, p.x};
  if (motion == 2) return {p.x + 123'456'789, p.y - 400'000'000};
  if (motion == 3) return {-p.x, p.y};
  return p;
}

}  // namespace

Region random_grid_region(Random& random, int scale) {
  std::vector<Ring> rings;
  if (random.integer(0, 2) == 0) {
    rings = random_cells(random);
  } else {
    do {
      rings = random_rings(random);
    } while (!is_clean(Region::from_clean_rings(rings)));
  }
  const int motion = random.integer(0, 3);
  for (Ring& ring : rings) {
    for (Point& p : ring) p = moved(p, motion, scale);
    if (motion == 3) std::reverse(ring.begin(), ring.end());
  }
  return Region::from_clean_rings(std::move(rings));
}

}  // namespace test
