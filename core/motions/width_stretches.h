// Cuts a road whose width changes along its way into stretches that are laid with one width each,
// and where the layer below holds it otherwise (Road::holds).
//
//     ▁▁▁▂▂▃▃▄▄▄▄▄▄▄▃▃▂▂▁▁▁     the road's width
//     ├──┼─┼─┼───────┼─┼─┼──┤   the stretches: each lays what its piece of the road holds
//
// The nozzle does not stop between two stretches. A road of one width is one stretch.
#pragma once

#include <vector>

#include "core/geometry.h"    // Point
#include "core/roads/road.h"  // Road
#include "core/units.h"       // Length

namespace core {

struct WidthStretch {
  static constexpr int kNoArea = -1;

  RoadKind kind = RoadKind::kSolid;  // kOverhangPerimeter where a perimeter is in the air
  Hold hold = Hold::kWhole;
  Length width;
  double area_mm2 = 0;        // cross-section, in the mean
  bool closed = false;        // the whole of a closed road
  std::vector<Point> points;  // the first is the last of the stretch before
  int area{kNoArea};          // of those where roads are laid otherwise (laid_areas.h)
};

// Widths within a stretch differ by at most this share of the narrowest, but where it would be
// shorter than kWidthPieceMin.
inline constexpr double kWidthChangeShare = 0.05;
inline constexpr Length kWidthPieceMin = Length::from_units(4'000);

// ENSURES: the stretches' volumes sum up to the road's. COSTS: O(points + pieces).
[[nodiscard]] std::vector<WidthStretch> width_stretches(Road road, Length height);

}  // namespace core
