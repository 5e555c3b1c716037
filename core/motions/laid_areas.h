// Roads where some are to be laid otherwise (Slice::areas): cut at the borders of areas, each piece
// with the speeds and the flow that hold where it lies. The nozzle does not stop between them.
//
// Skirts, brims, rafts, supports and a spiral's turns are not cut.
#pragma once

#include <memory>
#include <vector>

#include "core/motions/width_stretches.h"  // WidthStretch
#include "core/roads/area_pieces.h"        // AreaPieces
#include "core/roads/road.h"               // RoadKind
#include "core/settings.h"                 // Settings
#include "core/slices/changed_areas.h"     // AreaChange, ChangedAreas

namespace core {

[[nodiscard]] Settings laid_settings(Settings settings, const AreaChange& change);

// The share of a road's cross-section that is laid.
[[nodiscard]] double flow_share(const AreaChange& change, RoadKind kind);

class LaidAreas {
 public:
  LaidAreas() = default;  // nowhere
  // Null: nowhere. COSTS: as parted(); O(points).
  LaidAreas(const std::shared_ptr<const ChangedAreas>& areas, const Settings& settings);

  // ENSURES: the pieces are the stretches, in their order; each lies within its area, but for
  // kAreaPieceMin. COSTS: nothing without areas; else a look at the grid for each segment.
  [[nodiscard]] std::vector<WidthStretch> cut(std::vector<WidthStretch> stretches) const;

  // Those that hold for a stretch, or null: the print's own.
  [[nodiscard]] const Settings* settings_of(const WidthStretch& stretch) const {
    return stretch.area < 0 ? nullptr : &parts_[static_cast<std::size_t>(stretch.area)].settings;
  }

 private:
  struct Part {
    AreaChange change;
    Settings settings;
  };

  std::vector<Part> parts_;
  AreaPieces pieces_;  // of these
};

}  // namespace core
