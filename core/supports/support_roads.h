// Roads of supports: a sheath around each piece, and rows in it, which stand on those below as
// walls. Dense layers have rows near to one another, across the others. Branches have none.
//
//     ╔═══════════╗
//     ║ │   │   │ ║     support            rows support_spacing apart
//     ║ │   │   │ ║
//     ╚═══════════╝
#pragma once

#include <memory>
#include <vector>

#include "core/roads/road.h"             // Road
#include "core/settings.h"               // Settings
#include "core/supports/support_fold.h"  // SupportLayer
#include "core/units.h"                  // Length

namespace core {

// Of the rows of layers that are not dense: (number + ½) · distance, across their angle.
[[nodiscard]] Length support_row_distance(Length height, const Settings& settings);

// In the order of printing. ENSURES: with a flow of 1, no bead leaves the region except by
// rounding.
// COSTS: as the perimeters and the fill of one layer with one perimeter.
[[nodiscard]] std::vector<Road> support_roads(const SupportLayer& layer, Length height,
                                              const Settings& settings);

// The layer's roads with those of its supports before them, but behind skirt and brim.
[[nodiscard]] std::vector<Road> with_supports(const std::vector<Road>& supports,
                                              const std::vector<Road>& roads);

struct SupportPlan {
  SupportLayer layer;
  Length height;
  std::vector<Road> roads;  // once it is filled
};

// Plans layer after layer; those that are alike share a plan.
//
//     layers in order ──> reserve() ──┬── a new plan ──> fill() in any thread
//                                     └── that of the layer below
class SupportPlanner {
 public:
  struct Reservation {
    std::shared_ptr<SupportPlan> plan;  // null: nothing is laid
    bool to_fill = false;               // this caller has to call fill(), nobody else does
  };

  // REQUIRES: settings in their ranges.
  explicit SupportPlanner(const Settings& settings) : settings_(settings) {}

  // COSTS: a comparison of addresses.
  [[nodiscard]] Reservation reserve(const SupportLayer& layer, Length height);
  void fill(SupportPlan& plan) const;

 private:
  Settings settings_;
  std::shared_ptr<SupportPlan> last_;
};

}  // namespace core
