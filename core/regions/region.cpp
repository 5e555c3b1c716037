#include "core/regions/region.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

#include "core/trigonometry.h"  // hypotenuse
#include "core/units.h"         // kUnitsPerMm

namespace core {
namespace {

enum class Side { kOutside, kBoundary, kInside };

// Where (x, y) / 2 lies; halves, so that an edge's midpoint can be asked for exactly.
Side side_of_ring(const Ring& ring, std::int64_t x, std::int64_t y) {
  int winding = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
    const std::int64_t ay = 2 * std::int64_t{a.y}, by = 2 * std::int64_t{b.y};
    const bool a_above = ay > y, b_above = by > y;
    if (a_above == b_above && ay != y && by != y) continue;
    const std::int64_t ax = 2 * std::int64_t{a.x}, bx = 2 * std::int64_t{b.x};
    // Doubled differences reach 2^31: each product fits 64 bits, their difference might not.
    const std::int64_t left = (bx - ax) * (y - ay), right = (by - ay) * (x - ax);
    if (left == right && std::min(ax, bx) <= x && x <= std::max(ax, bx) && std::min(ay, by) <= y &&
        y <= std::max(ay, by)) {
      return Side::kBoundary;
    }
    if (a_above == b_above) continue;
    if (b_above && left > right) ++winding;
    if (a_above && left < right) --winding;
  }
  return winding != 0 ? Side::kInside : Side::kOutside;
}

// The rings may touch, so a vertex on the other's boundary decides nothing.
bool lies_within(const Ring& inner, const Ring& outer) {
  for (const Point p : inner) {
    const Side side = side_of_ring(outer, 2 * std::int64_t{p.x}, 2 * std::int64_t{p.y});
    if (side != Side::kBoundary) return side == Side::kInside;
  }
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Point a = inner[i];
    const Point b = inner[i + 1 == inner.size() ? 0 : i + 1];
    const Side side = side_of_ring(outer, std::int64_t{a.x} + b.x, std::int64_t{a.y} + b.y);
    if (side != Side::kBoundary) return side == Side::kInside;
  }
  return true;
}

bool box_contains(const Box& outer, const Box& inner) {
  return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && inner.max.x <= outer.max.x &&
         inner.max.y <= outer.max.y;
}

// Two points at a time, with vectors as GCC and Clang have them on every processor.
void add_ring(const Ring& ring, Box& box) {
  using TwoPoints [[gnu::vector_size(16)]] = std::int32_t;
  static_assert(sizeof(Point) == 8);
  TwoPoints least{box.min.x, box.min.y, box.min.x, box.min.y};
  TwoPoints most{box.max.x, box.max.y, box.max.x, box.max.y};
  for (std::size_t i = 0; i < ring.size(); i += 2) {
    TwoPoints two;
    std::memcpy(&two, ring.data() + std::min(i, ring.size() - 2), sizeof two);
    least = two < least ? two : least;
    most = two > most ? two : most;
  }
  box = {{std::min(least[0], least[2]), std::min(least[1], least[3])},
         {std::max(most[0], most[2]), std::max(most[1], most[3])}};
}

}  // namespace

std::size_t Region::point_count() const {
  std::size_t count = 0;
  for (const Ring& ring : rings_) count += ring.size();
  return count;
}

double Region::area_mm2() const {
  double doubled = 0;
  for (const Ring& ring : rings_) doubled += doubled_area_units(ring);
  return doubled / 2 / (kUnitsPerMm * kUnitsPerMm);
}

double Region::perimeter_mm() const {
  double units = 0;
  for (const Ring& ring : rings_) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
      units += hypotenuse(static_cast<double>(b.x) - a.x, static_cast<double>(b.y) - a.y);
    }
  }
  return units / kUnitsPerMm;
}

Box Region::box() const {
  Box box;
  for (const Ring& ring : rings_) add_ring(ring, box);
  return box;
}

bool Region::contains(Point point) const {
  int depth = 0;
  for (const Ring& ring : rings_) {
    const Side side = side_of_ring(ring, 2 * std::int64_t{point.x}, 2 * std::int64_t{point.y});
    if (side == Side::kBoundary) return true;
    if (side == Side::kInside) depth += doubled_area_units(ring) > 0 ? 1 : -1;
  }
  return depth > 0;
}

double doubled_area_units(const Ring& ring) {
  double doubled = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    doubled += static_cast<double>(cross(ring[0], ring[i - 1], ring[i]));
  }
  return doubled;
}

void append_rings(Island island, std::vector<Ring>& rings) {
  rings.push_back(std::move(island.outer));
  rings.insert(rings.end(), std::make_move_iterator(island.holes.begin()),
               std::make_move_iterator(island.holes.end()));
}

Region region_of(Island island) {
  std::vector<Ring> rings;
  append_rings(std::move(island), rings);
  return Region::from_clean_rings(std::move(rings));
}

std::vector<Island> islands(const Region& region) {
  struct Outer {
    Box box;
    double area;
  };
  std::vector<Island> result;
  std::vector<Outer> outers;
  std::vector<const Ring*> holes;
  for (const Ring& ring : region.rings()) {
    const double area = doubled_area_units(ring);
    if (area > 0) {
      result.push_back({ring, {}});
      outers.push_back({box_of(ring), area});
    } else {
      holes.push_back(&ring);
    }
  }
  for (const Ring* hole : holes) {
    const Box box = box_of(*hole);
    std::optional<std::size_t> parent;
    for (std::size_t i = 0; i < outers.size(); ++i) {
      if (parent && outers[i].area >= outers[*parent].area) continue;
      if (box_contains(outers[i].box, box) && lies_within(*hole, result[i].outer)) parent = i;
    }
    if (parent) result[*parent].holes.push_back(*hole);
  }
  return result;
}

}  // namespace core
