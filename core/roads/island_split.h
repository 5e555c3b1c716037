// Splits what belongs to a slice by the slice's islands, so that each island is planned alone.
//
//        ╭───────╮   ╭────╮      A point within an island sees, on the way to the left, an edge
//        │ ◀──·  │   │◀·  │      of that island first: its outer ring's, or a hole's.
//        ╰───────╯   ╰────╯
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"             // Point, Ring
#include "core/regions/edge_strips.h"  // EdgeStrips
#include "core/regions/region.h"       // Region

namespace core {

class IslandSplit {
 public:
  // COSTS: O(points).
  explicit IslandSplit(const Region& slice);

  [[nodiscard]] const std::vector<Region>& islands() const { return islands_; }

  // The rings of a region that lies within the slice, by island, in their order.
  // COSTS: for each ring, the edges at the height of one of its points; nothing for one island.
  [[nodiscard]] std::vector<Region> split(Region region) const;

  // Of a point within the slice.
  [[nodiscard]] std::size_t island_of(Point point) const {
    return islands_.size() > 1 ? island_at(point) : 0;
  }

 private:
  // Of the edge that is seen first; island 0 where there is none.
  [[nodiscard]] std::uint32_t island_at(Point point) const;

  std::vector<Region> islands_;
  EdgeStrips edges_{{}};                  // of several islands; none of one
  std::vector<std::uint32_t> island_of_;  // by edge
};

}  // namespace core
