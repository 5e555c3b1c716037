#include "tools/oracles/reference_boolean.h"

#include <boost/polygon/polygon.hpp>

#include "core/check.h"                  // RIND_CHECK
#include "core/limits.h"                 // kCoordinateMax
#include "core/regions/contact_check.h"  // surely_clean

namespace core::reference {
namespace {

namespace polygon = boost::polygon;
using BoostPoint = polygon::point_data<int>;
using PolygonSet = polygon::polygon_set_data<int>;
using Edges = std::vector<PolygonSet::element_type>;
using Operation = polygon::arbitrary_boolean_op<int>;

enum class Direction { kAsIs, kReversed };

// Boost re-orients whole polygons on insertion; signed edges keep the rings' real winding numbers.
void add_edges(const std::vector<Ring>& rings, Direction direction, Edges& edges) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i];
      Point b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a == b) continue;
      int count = direction == Direction::kAsIs ? 1 : -1;
      if (a.x == b.x) count = -count;
      if (b < a) {
        std::swap(a, b);
        count = -count;
      }
      edges.push_back({{BoostPoint(a.x, a.y), BoostPoint(b.x, b.y)}, count});
    }
  }
}

Edges directed_edges_of(const std::vector<Ring>& rings, Direction direction = Direction::kAsIs) {
  Edges edges;
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.size();
  edges.reserve(count);
  add_edges(rings, direction, edges);
  return edges;
}

// Boost repeats the first point at the end, and leaves points on straight runs.
template <typename Polygon>
void add_ring(const Polygon& boundary, std::vector<Ring>& rings) {
  Ring ring;
  ring.reserve(boundary.size());
  for (const BoostPoint& boost_point : boundary) {
    const Point p{boost_point.x(), boost_point.y()};
    while (ring.size() > 1 && cross(ring[ring.size() - 2], ring.back(), p) == 0) ring.pop_back();
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  }
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  while (ring.size() > 2 && cross(ring[ring.size() - 2], ring.back(), ring.front()) == 0) {
    ring.pop_back();
  }
  if (ring.size() > 2 && cross(ring.back(), ring[0], ring[1]) == 0) ring.erase(ring.begin());
  if (ring.size() >= 3 && doubled_area_units(ring) != 0) rings.push_back(std::move(ring));
}

Region combine(const Edges& a, const Edges& b, Operation::BOOLEAN_OP_TYPE type) {
  PolygonSet result;
  Operation operation;
  operation.execute(result, a.begin(), a.end(), b.begin(), b.end(), type);
  std::vector<polygon::polygon_with_holes_data<int>> pieces;
  result.get(pieces);
  std::vector<Ring> rings;
  for (const auto& piece : pieces) {
    add_ring(piece.self_.coords_, rings);
    for (const auto& hole : piece.holes_) add_ring(hole.coords_, rings);
  }
  return Region::from_clean_rings(std::move(rings));
}

Region both(const Region& a, const Region& b) {
  std::vector<Ring> rings = a.rings();
  rings.insert(rings.end(), b.rings().begin(), b.rings().end());
  return Region::from_clean_rings(std::move(rings));
}

bool apart(const Region& a, const Region& b) { return !a.box().overlaps(b.box()); }

}  // namespace

Region clean(const std::vector<Ring>& rings, FillRule rule) {
  for (const Ring& ring : rings) {
    for (const Point p : ring) {
      RIND_CHECK(p.x >= -kCoordinateMax && p.x <= kCoordinateMax);
      RIND_CHECK(p.y >= -kCoordinateMax && p.y <= kCoordinateMax);
    }
  }
  if (surely_clean(rings)) return Region::from_clean_rings(rings);
  const Edges edges = directed_edges_of(rings);
  // For Boost, a point is covered if its winding number is above 0. If it is below 0, the reversed
  // rings cover it.
  const Edges turned =
      rule == FillRule::kNonZero ? directed_edges_of(rings, Direction::kReversed) : Edges();
  return combine(edges, turned, Operation::BOOLEAN_OR);
}

Region unite(const Region& a, const Region& b) {
  if (a.empty() || a == b) return b;
  if (b.empty()) return a;
  if (apart(a, b)) return both(a, b);
  return combine(directed_edges_of(a.rings()), directed_edges_of(b.rings()), Operation::BOOLEAN_OR);
}

Region intersect(const Region& a, const Region& b) {
  if (a.empty() || b.empty() || apart(a, b)) return {};
  if (a == b) return a;
  return combine(directed_edges_of(a.rings()), directed_edges_of(b.rings()),
                 Operation::BOOLEAN_AND);
}

Region subtract(const Region& a, const Region& b) {
  if (a.empty() || a == b) return {};
  if (b.empty() || apart(a, b)) return a;
  return combine(directed_edges_of(a.rings()), directed_edges_of(b.rings()),
                 Operation::BOOLEAN_NOT);
}

Region exclusive_or(const Region& a, const Region& b) {
  if (a == b) return {};
  if (a.empty()) return b;
  if (b.empty()) return a;
  if (apart(a, b)) return both(a, b);
  return combine(directed_edges_of(a.rings()), directed_edges_of(b.rings()),
                 Operation::BOOLEAN_XOR);
}

}  // namespace core::reference
