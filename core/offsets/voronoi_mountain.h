// The Voronoi mountain of a region and its offsets (DETC2000/DAC-14285, "Generating offset
// contours"). It is like the roof of a straight skeleton, but with round edges.
//
// Take the Voronoi diagram of all contours (islands and holes, inside and outside), and lift every
// point by its signed distance to the contours. The offset at depth d is the cut at z = d:
//
//        /\      z = d > 0: an inner offset          one diagram serves any number of depths,
//     __/__\__   z = 0: the contours                 each cut costs O(edges)
//      /    \    z = d < 0: an outer offset
//
// Slower than polygon_offset.h, but independent of it: the reference in tests, and the fallback
// where polygon_offset.h finds no consistent result.
//
// Keywords: straight skeleton, medial axis, signed distance field.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/offsets/offset_contours.h"  // OffsetContours
#include "core/regions/region.h"           // Region
#include "core/units.h"                    // Length

namespace core {

class VoronoiMountain {
 public:
  // COSTS: O(n log n), some 20 µs a contour edge. Boost.Polygon's diagram can lack edges or have
  // crossing ones (boostorg/polygon#43): each is checked, and the region turned and tried again.
  explicit VoronoiMountain(const Region& region);
  ~VoronoiMountain();
  VoronoiMountain(VoronoiMountain&&) noexcept;
  VoronoiMountain& operator=(VoronoiMountain&&) noexcept;

  // Inwards for positive depths, outwards for negative ones; 0 gives the region itself.
  // A crossing point that is off its sites' offsets also turns and rebuilds the diagram; when no
  // turn helps, the offset is made of capsules: slow, its arcs within kCapsuleToleranceUnits.
  // REQUIRES: not called on one mountain by two threads at a time.
  [[nodiscard]] OffsetContours offset(Length depth) const;

  // How many diagrams failed their check so far, and were turned.
  [[nodiscard]] int retries() const;
  // How many offsets so far were made of capsules.
  [[nodiscard]] int fallbacks() const;

 private:
  struct Diagram;
  std::unique_ptr<Diagram> diagram_;
};

// The flattened offset of `region` at `depth`, for callers that need only one. polygon_offset.h
// makes it; no diagram is built unless that fails.
[[nodiscard]] Region offset(const Region& region, Length depth, Length arc_tolerance,
                            ArcForm form = ArcForm::kChords);

}  // namespace core
