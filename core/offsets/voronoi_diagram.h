// The Voronoi diagram of a region's contours, checked, in arrays of our own.
//
// Sites are the contours' corners and edges. Every cell is walked counter-clockwise; half an edge
// has its cell's site on its left and its twin's on its right:
//
//     site of the twin          A vertex's height is its signed distance to the contours:
//    o------------------>o      positive inside, negative outside, 0 on them.
//     site of the edge
//
// Used by voronoi_mountain (offsets) and medial_axis only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"  // Point, Ring

namespace core {

struct VoronoiSite {
  Point a;
  Point b;  // equal to a: a corner; otherwise the edge from a to b, the region on its left

  [[nodiscard]] bool is_corner() const { return a == b; }
};

struct VoronoiVertex {
  double x = 0;  // units
  double y = 0;
  double height = 0;
};

struct VoronoiEdge {
  static constexpr std::uint32_t kInfinity = UINT32_MAX;  // as a vertex

  std::uint32_t from = kInfinity;
  std::uint32_t twin = 0;
  std::uint32_t next = 0;
  std::uint32_t previous = 0;
  std::uint32_t site = 0;
  bool primary = true;  // false: between an edge and its own corner
};

struct VoronoiDiagram {
  std::vector<VoronoiSite> sites;
  std::vector<VoronoiVertex> vertices;
  std::vector<VoronoiEdge> edges;
  int turns = 0;  // how often the rings had to be turned before the diagram passed its checks

  [[nodiscard]] std::uint32_t to(std::uint32_t edge) const { return edges[edges[edge].twin].from; }
  [[nodiscard]] const VoronoiSite& site_of(std::uint32_t edge) const {
    return sites[edges[edge].site];
  }
};

// The diagram of a clean region's rings. It is built from rings turned by other angles until one
// passes all checks: turns first_turn, first_turn + 1, … up to kDiagramTurnsMax; then nullopt.
[[nodiscard]] std::optional<VoronoiDiagram> make_voronoi_diagram(const std::vector<Ring>& rings,
                                                                 int first_turn);

// From (x, y) to the corner, or to the nearest point of the edge. Units.
[[nodiscard]] double distance_to(const VoronoiSite& site, double x, double y);

}  // namespace core
