// Roads where some are to be laid otherwise (Slice::areas): cut at the borders of areas, each piece
// with the speeds and the flow that hold where it lies.
//
//              ┌────────────┐
//     ━━━━━━━━━●━━━━━━━━━━━━●━━━━━━     three pieces; the nozzle does not stop between them
//              └────────────┘
//
// Skirts, brims, rafts, supports and a spiral's turns are not cut.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"                 // Point, Segment
#include "core/motions/width_stretches.h"  // WidthStretch
#include "core/regions/point_location.h"   // PointLocation
#include "core/regions/segment_grid.h"     // SegmentGrid
#include "core/settings.h"                 // Settings
#include "core/slices/changed_areas.h"     // AreaChange, ChangedAreas
#include "core/units.h"                    // Length

namespace core {

// Shorter pieces are laid as what is before them, or, at a road's start, behind them.
inline constexpr Length kAreaPieceMin = Length::from_units(2'000);

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
    PointLocation region;
  };
  struct Piece {
    int area = WidthStretch::kNoArea;
    double length_mm = 0;
    std::vector<Point> points;
  };

  [[nodiscard]] int area_at(Point point) const;
  [[nodiscard]] std::vector<double> crossings(const Segment& way) const;
  [[nodiscard]] std::vector<Piece> pieces(const std::vector<Point>& points) const;

  std::vector<Part> parts_;
  std::vector<Segment> edges_;
  std::optional<SegmentGrid> grid_;  // of these
};

}  // namespace core
