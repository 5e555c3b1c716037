#include "core/offsets/voronoi_check.h"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.h"  // arc_tangent

namespace core {
namespace {

// Positions come out of Boost's doubles and, in turned diagrams, off a finer grid: both are far
// better than this near the part. Far vertices are worth less, in proportion.
double tolerance_at(const VoronoiVertex& vertex) {
  return 0.05 + 1e-8 * (std::abs(vertex.x) + std::abs(vertex.y));
}

// Below this a vertex counts as on the contour, and has no side.
constexpr double kOnContour = 0.25;

struct CornerEdge {
  Point corner;
  Point other;
  bool outgoing;

  bool operator<(const CornerEdge& b) const { return corner < b.corner; }
};

// Tells on which side of the contours a vertex lies that sees nothing but corners.
class CornerSectors {
 public:
  explicit CornerSectors(const std::vector<Ring>& rings) : rings_(rings) {}

  bool inside(Point corner, double x, double y) {
    if (edges_.empty()) collect();
    const auto [begin, end] =
        std::equal_range(edges_.begin(), edges_.end(), CornerEdge{corner, corner, false});
    // The region is on the left of outgoing edges: the last edge that a counter-clockwise turn
    // to (x, y) passes decides.
    const double angle = arc_tangent(y - corner.y, x - corner.x);
    double smallest_turn = 100;
    bool is_inside = false;
    for (auto edge = begin; edge != end; ++edge) {
      const double direction = arc_tangent(static_cast<double>(edge->other.y) - corner.y,
                                           static_cast<double>(edge->other.x) - corner.x);
      const double turn = angle >= direction ? angle - direction : angle - direction + 2 * M_PI;
      if (turn < smallest_turn) {
        smallest_turn = turn;
        is_inside = edge->outgoing;
      }
    }
    return is_inside;
  }

 private:
  void collect() {
    for (const Ring& ring : rings_) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
        edges_.push_back({a, b, true});
        edges_.push_back({b, a, false});
      }
    }
    std::sort(edges_.begin(), edges_.end());
  }

  const std::vector<Ring>& rings_;
  std::vector<CornerEdge> edges_;
};

bool links_agree(const VoronoiDiagram& diagram) {
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    const VoronoiEdge& next = diagram.edges[edge.next];
    if (edge.twin == i || diagram.edges[edge.twin].twin != i) return false;
    if (next.previous != i || next.site != edge.site) return false;
    if (next.from != diagram.to(i)) return false;
  }
  return true;
}

// How far left of the site's line the vertex is, times the site's length. Infinity is outside.
double left_of(const VoronoiSite& site, const VoronoiDiagram& diagram, std::uint32_t vertex) {
  if (vertex == VoronoiEdge::kInfinity) return -1;
  return (static_cast<double>(site.b.x) - site.a.x) * (diagram.vertices[vertex].y - site.a.y) -
         (static_cast<double>(site.b.y) - site.a.y) * (diagram.vertices[vertex].x - site.a.x);
}

// Where a contour runs straight on through a corner, the corner's cell is a line across it, and
// Boost has no vertex in the corner.
bool passes_through_corner(const VoronoiDiagram& diagram, std::uint32_t edge) {
  if (diagram.edges[edge].primary) return false;
  const VoronoiSite& a = diagram.site_of(edge);
  const VoronoiSite& b = diagram.site_of(diagram.edges[edge].twin);
  const VoronoiSite& straight = a.is_corner() ? b : a;
  return left_of(straight, diagram, diagram.edges[edge].from) *
             left_of(straight, diagram, diagram.to(edge)) <
         0;
}

// Every edge of the contours has a cell, whose border runs through both its ends and so keeps the
// inside apart from the outside.
bool cells_hold_their_sites(const VoronoiDiagram& diagram, std::size_t ring_edges) {
  std::vector<std::uint8_t> ends_seen(diagram.sites.size(), 0);
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    const VoronoiSite& site = diagram.sites[edge.site];
    if (!site.is_corner() && passes_through_corner(diagram, i)) {
      const Point corner = diagram.site_of(edge.twin).a;
      if (corner == site.a) ends_seen[edge.site] |= 1;
      if (corner == site.b) ends_seen[edge.site] |= 2;
    }
    if (edge.from == VoronoiEdge::kInfinity) continue;
    const VoronoiVertex& vertex = diagram.vertices[edge.from];
    const auto at = [&](Point p) {
      return std::abs(vertex.x - p.x) < kOnContour && std::abs(vertex.y - p.y) < kOnContour;
    };
    if (at(site.a)) ends_seen[edge.site] |= 1;
    if (at(site.b)) ends_seen[edge.site] |= 2;
  }
  std::size_t whole = 0;
  for (std::size_t i = 0; i < diagram.sites.size(); ++i) {
    if (diagram.sites[i].is_corner()) continue;
    if (ends_seen[i] != 3) return false;
    ++whole;
  }
  return whole == ring_edges;
}

bool measure_heights(const std::vector<Ring>& rings, VoronoiDiagram& diagram) {
  CornerSectors sectors(rings);
  std::vector<std::uint32_t> witness(diagram.vertices.size(), UINT32_MAX);
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    if (edge.from == VoronoiEdge::kInfinity) continue;
    std::uint32_t& known = witness[edge.from];
    const bool better = known == UINT32_MAX || (diagram.site_of(known).is_corner() &&
                                                !diagram.sites[edge.site].is_corner());
    if (better) known = i;
  }
  for (std::size_t i = 0; i < diagram.vertices.size(); ++i) {
    if (witness[i] == UINT32_MAX) return false;
    VoronoiVertex& vertex = diagram.vertices[i];
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) return false;
    const VoronoiSite& site = diagram.site_of(witness[i]);
    const double distance = distance_to(site, vertex.x, vertex.y);
    bool inside = false;
    if (site.is_corner()) {
      inside = distance > kOnContour && sectors.inside(site.a, vertex.x, vertex.y);
    } else {
      inside = left_of(site, diagram, static_cast<std::uint32_t>(i)) > 0;
    }
    vertex.height = inside ? distance : -distance;
  }
  return true;
}

bool vertices_are_nearest(const VoronoiDiagram& diagram) {
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    if (edge.from == VoronoiEdge::kInfinity) continue;
    const VoronoiVertex& vertex = diagram.vertices[edge.from];
    const double radius = std::abs(vertex.height), tolerance = tolerance_at(vertex);
    if (std::abs(distance_to(diagram.sites[edge.site], vertex.x, vertex.y) - radius) > tolerance) {
      return false;
    }
    const VoronoiSite& ahead = diagram.site_of(diagram.edges[edge.next].twin);
    if (distance_to(ahead, vertex.x, vertex.y) < radius - tolerance) return false;
    if (passes_through_corner(diagram, i)) continue;
    const std::uint32_t to = diagram.to(i);
    if (to == VoronoiEdge::kInfinity) {
      if (vertex.height > kOnContour) return false;
      continue;
    }
    const double other = diagram.vertices[to].height;
    if (std::min(vertex.height, other) < -kOnContour &&
        std::max(vertex.height, other) > kOnContour) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool measure_and_check(const std::vector<Ring>& rings, VoronoiDiagram& diagram) {
  std::size_t ring_edges = 0;
  for (const Ring& ring : rings) ring_edges += ring.size();
  return links_agree(diagram) && cells_hold_their_sites(diagram, ring_edges) &&
         measure_heights(rings, diagram) && vertices_are_nearest(diagram);
}

}  // namespace core
