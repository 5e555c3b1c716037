// Where some facets lie, layer by layer: what of them is between a layer's plane and that of the
// layer below, seen from above.
//
//     plane n      ─────╱───────          a facet that is cut by both planes leaves a strip, a flat
//                     ╱▒                  one all of itself, in one layer; where it is seen from
//     plane n−1    ─╱▒▒▒────────          below, what of slice n hangs over slice n−1 is that strip
//                   └──┘
//
// Points on a plane are where plane_sweep.h puts them, bit for bit, and a corner on it counts as
// above it, too.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/geometry.h"              // Triangle
#include "core/regions/region.h"        // Region
#include "core/result.h"                // Result
#include "core/slices/layer_heights.h"  // LayerHeights
#include "core/units.h"                 // LayerIndex

namespace core {

class FacetSlabs {
 public:
  // Gives the next facet in order of lowest z, or nothing at the end. REQUIRES: x and y within
  // ±kCoordinateMax.
  using FacetSource = std::function<Result<std::optional<Triangle>>()>;

  FacetSlabs(LayerHeights heights, FacetSource source);

  // What of the facets lies in the next layer's slab, from layer 0 on. Empty in layer 0, which
  // hangs over nothing. An error is the source's, and final.
  // COSTS: memory for the facets that reach into the slab; a union of their pieces.
  [[nodiscard]] Result<Region> next();

 private:
  [[nodiscard]] Status take_facets_below(std::int64_t doubled_z);

  LayerHeights heights_;
  FacetSource source_;
  LayerIndex next_index_ = 0;
  std::int64_t below_ = 0;  // doubled height of the plane that was reached last
  std::vector<Triangle> held_;
  std::optional<Triangle> waiting_;
  bool source_ended_ = false;
};

}  // namespace core
