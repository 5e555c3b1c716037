#include "core/offsets/offset_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/check.h"    // RIND_CHECK
#include "core/limits.h"   // kCoordinateMax
#include "core/rounded.h"  // rounded
#include "core/vector.h"   // Vector, dot, cross, left_of

namespace core {
namespace {

// Of a crossing point from its sites' offsets, in units, before it is rounded to the grid.
constexpr double kCrossingErrorMax = 0.5;
// Below this angle (as a sine) the meeting of two offset lines is not computed from the lines.
constexpr double kParallel = 1e-6;

Vector unit_along(const VoronoiSite& site) {
  const Vector along = to_vector(site.b) - to_vector(site.a);
  return along * (1 / std::sqrt(dot(along, along)));
}

class Walk {
 public:
  Walk(const VoronoiDiagram& diagram, double depth)
      : diagram_(diagram), radius_(std::abs(depth)), side_(depth > 0 ? 1 : -1) {}

  std::optional<OffsetContours> run() {
    const std::size_t count = diagram_.edges.size();
    visited_.assign(count, false);
    OffsetContours contours;
    for (std::uint32_t edge = 0; edge < count; ++edge) {
      if (visited_[edge] || !comes_down(edge)) continue;
      std::optional<OffsetContour> contour = follow(edge);
      if (!contour) return std::nullopt;
      if (contour->size() >= 2) contours.push_back(std::move(*contour));
    }
    return contours;
  }

 private:
  // Farther from the contours than the offset, on its side.
  [[nodiscard]] bool far(std::uint32_t vertex) const {
    if (vertex == VoronoiEdge::kInfinity) return side_ < 0;
    return diagram_.vertices[vertex].height * side_ > radius_;
  }

  // For an edge with two far ends: whether its middle dips below the offset, which cuts it twice.
  [[nodiscard]] bool dips(std::uint32_t edge) const {
    const VoronoiSite& a = diagram_.site_of(edge);
    const VoronoiSite& b = diagram_.site_of(diagram_.edges[edge].twin);
    if (!diagram_.edges[edge].primary || (!a.is_corner() && !b.is_corner())) return false;
    const Vector corner = to_vector(a.is_corner() ? a.a : b.a);
    const VoronoiSite& other = a.is_corner() ? b : a;
    Vector axis{}, lowest{};  // the edge's lowest point, and the way along it
    if (other.is_corner()) {
      const Vector between = to_vector(other.a) - corner;
      lowest = corner + between * 0.5;
      axis = left_of(between);
    } else {
      axis = unit_along(other);
      const Vector base = to_vector(other.a);
      lowest = (corner + base + axis * dot(corner - base, axis)) * 0.5;
    }
    const Vector half = lowest - corner;
    if (dot(half, half) >= radius_ * radius_) return false;
    return dot(end_direction(edge, lowest), axis) *
               dot(end_direction(diagram_.edges[edge].twin, lowest), axis) <
           0;
  }

  // From `origin` towards the edge's end, or, if that is at infinity, along the edge.
  [[nodiscard]] Vector end_direction(std::uint32_t edge, Vector origin) const {
    const std::uint32_t to = diagram_.to(edge);
    if (to != VoronoiEdge::kInfinity) {
      return Vector{diagram_.vertices[to].x, diagram_.vertices[to].y} - origin;
    }
    const VoronoiSite& left = diagram_.site_of(edge);
    const VoronoiSite& right = diagram_.site_of(diagram_.edges[edge].twin);
    if (left.is_corner() && right.is_corner()) {
      return left_of(to_vector(right.a) - to_vector(left.a));
    }
    const VoronoiSite& straight = left.is_corner() ? right : left;
    return left_of(unit_along(straight)) * side_;
  }

  [[nodiscard]] bool comes_down(std::uint32_t edge) const {
    if (!far(diagram_.edges[edge].from)) return false;
    return !far(diagram_.to(edge)) || dips(edge);
  }
  [[nodiscard]] bool goes_up(std::uint32_t edge) const {
    return comes_down(diagram_.edges[edge].twin);
  }

  std::optional<OffsetContour> follow(std::uint32_t start) {
    std::vector<OffsetPiece> pieces;
    std::uint32_t down = start;
    std::optional<Point> from = crossing(down);
    do {
      if (!from || visited_[down]) return std::nullopt;
      visited_[down] = true;
      std::uint32_t up = diagram_.edges[down].previous;
      while (!goes_up(up)) {
        if (up == down) return std::nullopt;
        up = diagram_.edges[up].previous;
      }
      const VoronoiSite& site = diagram_.site_of(down);
      const std::uint32_t next = diagram_.edges[up].twin;
      const std::optional<Point> to = crossing(next);
      if (to && *to != *from) pieces.push_back(piece(*from, *to, site));
      from = to;
      down = next;
    } while (down != start);
    if (side_ < 0) std::reverse(pieces.begin(), pieces.end());
    return pieces;
  }

  // The walk keeps the far side on its left. An outer offset's region is on the other side.
  [[nodiscard]] OffsetPiece piece(Point from, Point to, const VoronoiSite& site) const {
    OffsetPiece result{side_ > 0 ? from : to, OffsetPiece::Kind::kLine, {}};
    if (site.is_corner()) {
      result.centre = site.a;
      result.kind =
          side_ > 0 ? OffsetPiece::Kind::kArcClockwise : OffsetPiece::Kind::kArcCounterClockwise;
    }
    return result;
  }

  // Where the edge, coming down from its far `from`, meets the offset.
  [[nodiscard]] std::optional<Point> crossing(std::uint32_t edge) const {
    const std::uint32_t twin = diagram_.edges[edge].twin;
    const VoronoiSite& a = diagram_.site_of(edge);
    const VoronoiSite& b = diagram_.site_of(twin);
    Vector best = from_sites(edge, a, b);
    double error = error_at(best, a, b);
    if (!(error <= kCrossingErrorMax / 8)) {
      for (const Vector candidate : from_vertices(edge)) {
        const double candidate_error = error_at(candidate, a, b);
        if (error <= candidate_error) continue;
        best = candidate;
        error = candidate_error;
      }
    }
    if (!(error <= kCrossingErrorMax)) return std::nullopt;
    if (std::abs(best.x) > 2.0 * kCoordinateMax || std::abs(best.y) > 2.0 * kCoordinateMax) {
      return std::nullopt;
    }
    return Point{rounded(best.x), rounded(best.y)};
  }

  [[nodiscard]] double error_at(Vector p, const VoronoiSite& a, const VoronoiSite& b) const {
    return std::max(std::abs(distance_to(a, p.x, p.y) - radius_),
                    std::abs(distance_to(b, p.x, p.y) - radius_));
  }

  // For edges along which the sites say too little, such as those between parallel sites.
  [[nodiscard]] std::array<Vector, 3> from_vertices(std::uint32_t edge) const {
    const Vector nowhere{NAN, NAN};
    std::array<Vector, 3> candidates{nowhere, nowhere, nowhere};
    const std::uint32_t ends[2] = {diagram_.edges[edge].from, diagram_.to(edge)};
    double heights[2] = {0, 0};
    for (std::size_t i = 0; i < 2; ++i) {
      if (ends[i] == VoronoiEdge::kInfinity) return candidates;
      const VoronoiVertex& vertex = diagram_.vertices[ends[i]];
      candidates[i] = {vertex.x, vertex.y};
      heights[i] = std::abs(vertex.height);
    }
    if (heights[0] != heights[1]) {
      const double part = std::clamp((radius_ - heights[0]) / (heights[1] - heights[0]), 0.0, 1.0);
      candidates[2] = candidates[0] + (candidates[1] - candidates[0]) * part;
    }
    return candidates;
  }

  [[nodiscard]] Vector from_sites(std::uint32_t edge, const VoronoiSite& a,
                                  const VoronoiSite& b) const {
    if (!a.is_corner() && !b.is_corner()) return meet_of_lines(a, b);
    const VoronoiSite& corner = a.is_corner() ? a : b;
    const VoronoiSite& other = a.is_corner() ? b : a;
    const Vector centre = to_vector(corner.a);
    Vector middle{}, along{};  // candidates lie symmetrically about the middle
    if (other.is_corner()) {
      const Vector between = to_vector(other.a) - centre;
      const double length = std::sqrt(dot(between, between));
      middle = between * 0.5;
      along = left_of(between) * (1 / length);
    } else {
      along = unit_along(other);
      const Vector normal = left_of(along) * side_;
      if (other.a == corner.a || other.b == corner.a) return centre + normal * radius_;
      middle = normal * (radius_ - dot(centre - to_vector(other.a), normal));
    }
    const double reach = std::sqrt(std::max(0.0, radius_ * radius_ - dot(middle, middle)));
    // Distances grow away from the middle, so the crossing is on the far end's side.
    const Vector outwards = end_direction(diagram_.edges[edge].twin, centre + middle);
    return centre + middle + along * (dot(outwards, along) < 0 ? -reach : reach);
  }

  [[nodiscard]] Vector meet_of_lines(const VoronoiSite& a, const VoronoiSite& b) const {
    const Vector normal_a = left_of(unit_along(a)) * side_;
    const Vector normal_b = left_of(unit_along(b)) * side_;
    const bool joined = a.b == b.a || b.b == a.a;
    if (joined) {
      const Point corner = a.b == b.a ? a.b : a.a;
      const double opening = 1 + dot(normal_a, normal_b);
      return to_vector(corner) + (normal_a + normal_b) * (radius_ / opening);
    }
    const double sine = cross(normal_a, normal_b);
    if (std::abs(sine) < kParallel) return {NAN, NAN};
    const Vector origin = to_vector(a.a);
    const double to_b = radius_ + dot(normal_b, to_vector(b.a) - origin);
    // Along a's offset from the foot of a.a until b's offset is met.
    const double way =
        (to_b - radius_ * dot(normal_a, normal_b)) / dot(left_of(normal_a), normal_b);
    return origin + normal_a * radius_ + left_of(normal_a) * way;
  }

  const VoronoiDiagram& diagram_;
  double radius_;
  double side_;
  std::vector<bool> visited_;  // edges that were come down
};

}  // namespace

std::optional<OffsetContours> walk_offset(const VoronoiDiagram& diagram, Length depth) {
  RIND_CHECK(depth != Length());
  return Walk(diagram, static_cast<double>(depth.units())).run();
}

}  // namespace core
