#include "core/roads/layer_planner.h"

#include <algorithm>
#include <utility>

#include "core/roads/crumbs.h"       // drop_crumbs
#include "core/roads/fuzzy_skin.h"   // make_fuzzy
#include "core/roads/road_order.h"   // printing_order
#include "core/roads/short_ways.h"   // lay_short_ways
#include "core/walls/spiral_vase.h"  // in_vase, starts_vase

namespace core {
namespace {

using Neighbour = std::shared_ptr<const Region>;

bool alike(const Neighbour& a, const Neighbour& b) { return a == b || (a && b && *a == *b); }

bool alike(const std::shared_ptr<const Branches>& a, const std::shared_ptr<const Branches>& b) {
  return a == b || (a && b && *a == *b);
}

bool alike(const LooseBlock& a, const LooseBlock& b) {
  return alike(a.region, b.region) && a.layers == b.layers;
}

bool alike(const std::shared_ptr<const ChangedAreas>& a,
           const std::shared_ptr<const ChangedAreas>& b) {
  return a == b || (a && b && *a == *b);
}

// What is solid follows from the slice and what is loose. The first layer has a skirt.
bool alike(const SplitLayer& a, const SplitLayer& b) {
  return a.slice.index != 0 && a.slice.height == b.slice.height && a.loose == b.loose &&
         a.slice.region == b.slice.region && alike(a.below, b.below) && alike(a.above, b.above) &&
         alike(a.below_loose, b.below_loose) && a.below_height == b.below_height &&
         a.corners_above == b.corners_above && alike(a.support_below, b.support_below) &&
         alike(a.window_loose, b.window_loose) && alike(a.block, b.block) &&
         alike(a.slice.areas, b.slice.areas) && alike(a.branches, b.branches) &&
         alike(a.below_branches, b.below_branches);
}

// Above the floor of a vase or not, likewise.
bool alike_in_vase(const SplitLayer& a, const SplitLayer& b, const Settings& settings) {
  return in_vase(a.slice, settings) == in_vase(b.slice, settings) &&
         starts_vase(a, settings) == starts_vase(b, settings);
}

bool some_change_with_height(const std::shared_ptr<const ChangedAreas>& areas) {
  if (!areas) return false;
  return std::any_of(areas->begin(), areas->end(), [](const ChangedArea& area) {
    return area.change.pattern && changes_with_height(*area.change.pattern);
  });
}

// A vase has no inside that could hang, or hold.
HangingPlaces hanging_of(const SplitLayer& layer, const Settings& settings) {
  if (!in_vase(layer.slice, settings)) return hanging_places(layer, settings);
  SplitLayer ring = layer;
  ring.slice.region = layer.solid;
  if (over_vase(layer, settings)) {
    ring.below = std::make_shared<const Region>(vase_ring(*layer.below, settings));
  }
  return hanging_places(ring, settings);
}

}  // namespace

LayerPlanner::Reservation LayerPlanner::reserve(SplitLayer split) {
  std::shared_ptr<LayerPlan>& last = last_[turn_of(split.slice.index)];
  const bool changes = loose_changes_ || some_change_with_height(split.slice.areas);
  const bool anew = changes && !split.loose.empty();
  if (last && !anew && alike(last->split, split) && alike_in_vase(last->split, split, settings_)) {
    ++reused_;
    return {last, false};
  }
  last = std::make_shared<LayerPlan>();
  last->split = std::move(split);
  return {last, true};
}

void LayerPlanner::fill(LayerPlan& plan, bool with_roads) const {
  plan.layer = style_.apply(plan.split);
  const double moved_mm2 = plan.split.loose.area_mm2() - plan.layer.loose.area_mm2();
  plan.regularised_mm3 = style_.only_regularises() ? moved_mm2 * plan.layer.slice.height.mm() : 0;
  plan.hanging = hanging_of(plan.layer, settings_);
  if (!with_roads) return;
  plan.roads = roads_.plan(plan.layer);
  plan.seams = seam_loops(plan.layer, plan.roads);
  if (!settings_.avoid_crossing_perimeters) return;
  const Slice& slice = plan.layer.slice;
  const Settings& settings = slice.index == 0 ? first_layer_settings(settings_) : settings_;
  plan.travel_space = std::make_unique<TravelSpace>(slice.region, settings.road_width,
                                                    settings_.avoid_crossing_max_detour);
}

LayerPlanner::Ordering LayerPlanner::place_seams(const std::shared_ptr<LayerPlan>& plan,
                                                 LayerIndex index) {
  std::vector<RingPlace> places = seams_.place(index, plan->roads, plan->seams);
  Ordered& last = last_ordered_[turn_of(index)];
  const bool fuzzy = settings_.fuzzy_skin != FuzzySkin::kNone;
  if (last.plan == plan && last.ordering.seams == places && !fuzzy) {
    Ordering again = last.ordering;
    again.to_order = false;
    return again;
  }
  last = {plan, {std::make_shared<std::vector<Road>>(), std::move(places), index, true}};
  return last.ordering;
}

void LayerPlanner::order(const LayerPlan& plan, const Ordering& ordering) const {
  LayerRoads roads = plan.roads;
  set_starts(plan.seams, ordering.seams, roads);
  *ordering.roads = printing_order(std::move(roads));
  lay_short_ways(plan.layer.slice.region, settings_, *ordering.roads);
  drop_crumbs(plan.layer, settings_, *ordering.roads);
  make_fuzzy(*ordering.roads, ordering.index, settings_);
}

}  // namespace core
