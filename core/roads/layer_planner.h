// Plans a layer that is split: applies the style, then plans the roads. Layers that are alike share
// one plan, so that a prismatic part is planned twice in all:
//
//     layers in order ──> reserve() ──┬── a new plan ──> fill() in any thread ──┐
//                                     └── that of the layer two below ──────────┴──> plan
//
// Two below, because the fill of the layer below is turned.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/roads/hanging_places.h"  // HangingPlaces
#include "core/roads/loose_fill.h"      // changes_with_height
#include "core/roads/road.h"            // Road
#include "core/roads/road_planner.h"    // RoadPlanner
#include "core/settings.h"              // Settings
#include "core/walls/split_layer.h"     // SplitLayer
#include "core/walls/wall_style.h"      // WallStyle

namespace core {

struct LayerPlan {
  SplitLayer split;            // as the window says
  SplitLayer layer;            // as the style wants it
  std::vector<Road> roads;     // in printing order
  HangingPlaces hanging;       // known where roads are wanted
  double regularised_mm3 = 0;  // moved from loose to solid, to be printable (regularise.h)
};

class LayerPlanner {
 public:
  struct Reservation {
    std::shared_ptr<LayerPlan> plan;  // never null; its layer's index is that of who came first
    bool to_fill = false;             // this caller has to call fill(), nobody else does
  };

  // REQUIRES: with_style() was applied.
  explicit LayerPlanner(const Settings& settings)
      : settings_(settings),
        style_(settings),
        roads_(settings),
        loose_changes_(changes_with_height(settings.loose_pattern)) {}

  // COSTS: a comparison.
  [[nodiscard]] Reservation reserve(SplitLayer split);

  // COSTS: as WallStyle and, where roads are wanted, RoadPlanner and hanging_places().
  void fill(LayerPlan& plan, bool with_roads) const;

  // Layers that got the plan of an equal one.
  [[nodiscard]] std::int64_t reused() const { return reused_; }

 private:
  Settings settings_;
  WallStyle style_;
  RoadPlanner roads_;
  bool loose_changes_;  // from layer to layer, whatever the layers are like
  std::array<std::shared_ptr<LayerPlan>, 2> last_;  // of even and odd layers
  std::int64_t reused_ = 0;
};

}  // namespace core
