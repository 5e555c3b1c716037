// A slice's contour as something that travels cross.
#pragma once

#include <optional>

#include "core/geometry.h"              // Segment
#include "core/regions/region.h"        // Region
#include "core/regions/segment_grid.h"  // SegmentGrid
#include "core/units.h"                 // Length

namespace core {

// Entered in a grid only when a travel asks for it. The region must outlive it.
class SliceBoundary {
 public:
  explicit SliceBoundary(const Region& region) : region_(region) {}

  [[nodiscard]] bool crossed_by(const Segment& line) {
    if (!grid_) grid_.emplace(Length::from_mm(2), region_);
    return grid_->crosses(line);
  }

 private:
  const Region& region_;
  std::optional<SegmentGrid> grid_;
};

}  // namespace core
