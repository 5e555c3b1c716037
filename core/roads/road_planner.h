// Turns a layer, split into wall and inside, into roads, island by island:
//
//     ┌───────────────┐   perimeters    roads along the contour, as many and as wide as fit
//     │ ┌───────────┐ │                 (perimeters.h)
//     │ │╱╱╱╱╱╱╱╱╱╱╱│ │   the wall      parallel roads, joined at their ends (line_fill.h)
//     │ │╱╱╱     ╱╱╱│ │   its gaps      roads of fitting width where whole ones don't fit, so that
//     │ │╱╱╱  ╱  ╱╱╱│ │                 the wall is dense (gap_fill.h)
//     │ │╱╱╱ ╱   ╱╱╱│ │   the inside    a pattern, anchored in the wall (loose_fill.h)
//
// The first layer has a skirt, too. Above the floor of a spiral vase there is one perimeter
// (vase_roads.h). What is printed when is decided later (road_order.h), because
// a closed road's start depends on the layer below.
#pragma once

#include "core/roads/layer_roads.h"  // LayerRoads
#include "core/settings.h"           // Settings
#include "core/units.h"              // Length
#include "core/walls/split_layer.h"  // SplitLayer

namespace core {

// The wall is filled this far beyond its inner edge. So what rounding, notches between rows and
// slivers too thin for a road would leave open is dense as well.
inline constexpr Length kWallGrace = Length::from_units(500);

// Half of kBeadSeam (bead_cover.h): the wall's outline needs no point that moves it by less.
inline constexpr Length kWallSimplify = Length::from_units(150);

class RoadPlanner {
 public:
  // REQUIRES: settings in their ranges.
  explicit RoadPlanner(const Settings& settings);

  // ENSURES: no bead leaves the slice except by rounding, every road has two points or more; the
  // same layer always gives the same roads. No roads where none fits: all narrower than
  // road_width_min.
  // REQUIRES: layer.offsets as OffsetCutter makes them with the same settings.
  [[nodiscard]] LayerRoads plan(const SplitLayer& layer) const;

 private:
  [[nodiscard]] LayerRoads plan_vase(const SplitLayer& layer) const;

  Settings settings_;
  Settings first_settings_;  // of the first layer
};

}  // namespace core
