// The borders between the cells of a region's sites, up to a clearance, each found from both sides.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"                 // Ring
#include "core/offsets/voronoi_diagram.h"  // VoronoiSite, VoronoiVertex

namespace core {

// Between the cells of two sites, `site` on its left, the lower number.
struct CellBorder {
  std::uint32_t site = 0;
  std::uint32_t other = 0;
  VoronoiVertex from;
  VoronoiVertex to;
};

struct CellBorders {
  std::vector<VoronoiSite> sites;  // edges in the order of the rings, then reflex corners
  std::vector<CellBorder> borders;
};

// From whose side a border is taken: that of the lower number, or the higher one. Where rounding
// decides a near tie, the two may differ.
enum class BorderSide { kLower, kHigher };

// nullopt: so many sites are near one another that the whole diagram costs less.
// COSTS: as make_narrow_diagram(). REQUIRES: a clean region's rings; clearance_max > 0, units.
[[nodiscard]] std::optional<CellBorders> find_cell_borders(const std::vector<Ring>& rings,
                                                           double clearance_max,
                                                           BorderSide side = BorderSide::kLower);

}  // namespace core
