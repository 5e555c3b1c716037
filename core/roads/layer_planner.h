// Plans a layer that is split: applies the style, plans the roads, chooses the seams, then puts the
// roads in order. Layers that are alike share one plan, and one order if their seams are alike,
// so that a prismatic part is planned twice in all:
//
//     layers in order ──> reserve() ──┬── a new plan ──> fill() in any thread ──┐
//                                     └── that of the layer two below ──────────┤
//                                                                               ▼
//     roads in order <──┬── order() in any thread <── new ──┬── place_seams(), layers in order
//                       └── those of the layer two below <──┘
//
// Two below, because the fill of the layer below is turned; with blocks of n layers whose inside is
// laid at once (loose_blocks.h), 2n below. A rough surface has an order of its own in each layer.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/roads/hanging_places.h"  // HangingPlaces
#include "core/roads/layer_roads.h"     // LayerRoads
#include "core/roads/loose_fill.h"      // changes_with_height
#include "core/roads/road.h"            // Road
#include "core/roads/road_planner.h"    // RoadPlanner
#include "core/roads/seam_loops.h"      // LayerSeams
#include "core/roads/seams.h"           // SeamMemory, SeamPlacer
#include "core/roads/travel_space.h"    // TravelSpace
#include "core/settings.h"              // Settings
#include "core/walls/loose_blocks.h"    // loose_block_layers
#include "core/walls/split_layer.h"     // SplitLayer
#include "core/walls/wall_style.h"      // WallStyle

namespace core {

struct LayerPlan {
  SplitLayer split;       // as the window says
  SplitLayer layer;       // as the style wants it
  LayerRoads roads;       // not in order
  LayerSeams seams;       // what they offer
  HangingPlaces hanging;  // known where roads are wanted
  // Where the setting asks for ways around contours.
  std::unique_ptr<const TravelSpace> travel_space;
  double regularised_mm3 = 0;  // moved from loose to solid, to be printable (regularise.h)
};

class LayerPlanner {
 public:
  struct Reservation {
    std::shared_ptr<LayerPlan> plan;  // never null; its layer's index is that of who came first
    bool to_fill = false;             // this caller has to call fill(), nobody else does
  };

  struct Ordering {
    std::shared_ptr<std::vector<Road>> roads;  // in printing order, once order() was called
    std::vector<RingPlace> seams;              // of the plan's loops
    LayerIndex index = 0;                      // of the layer that asked first
    bool to_order = false;                     // this caller has to call order(), nobody else does
  };

  // REQUIRES: with_style() was applied.
  explicit LayerPlanner(const Settings& settings)
      : settings_(settings),
        style_(settings),
        roads_(settings),
        loose_changes_(changes_with_height(settings.loose_pattern)),
        seams_(settings.seam),
        last_(2 * static_cast<std::size_t>(loose_block_layers(settings))),
        last_ordered_(last_.size()) {}

  // COSTS: a comparison.
  [[nodiscard]] Reservation reserve(SplitLayer split);

  // COSTS: as WallStyle and, where roads are wanted, RoadPlanner, seam_loops(), hanging_places()
  // and, where the setting asks for it, TravelSpace.
  void fill(LayerPlan& plan, bool with_roads) const;

  // Layer by layer. COSTS: as SeamPlacer. REQUIRES: the plan is filled, with its roads.
  [[nodiscard]] Ordering place_seams(const std::shared_ptr<LayerPlan>& plan, LayerIndex index);

  // COSTS: a copy of the roads, and as printing_order().
  void order(const LayerPlan& plan, const Ordering& ordering) const;

  // What the next layer's seams depend on (seams.h), so that a print can start there.
  [[nodiscard]] const SeamMemory& seam_memory() const { return seams_.memory(); }
  void resume_from(SeamMemory memory) { seams_.resume_from(std::move(memory)); }

  // Layers that got the plan of an equal one.
  [[nodiscard]] std::int64_t reused() const { return reused_; }

 private:
  // Layers of the same turn have the same directions of fill.
  [[nodiscard]] std::size_t turn_of(LayerIndex index) const {
    return static_cast<std::size_t>(index) % last_.size();
  }

  Settings settings_;
  WallStyle style_;
  RoadPlanner roads_;
  bool loose_changes_;  // from layer to layer, whatever the layers are like
  SeamPlacer seams_;
  // By turn_of().
  std::vector<std::shared_ptr<LayerPlan>> last_;
  struct Ordered {
    std::shared_ptr<LayerPlan> plan;
    Ordering ordering;
  };
  std::vector<Ordered> last_ordered_;
  std::int64_t reused_ = 0;
};

}  // namespace core
