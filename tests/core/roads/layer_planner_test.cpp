#include "core/roads/layer_planner.h"

#include <doctest/doctest.h>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

SplitLayer split(const Region& slice, const Region& loose, const Settings& settings,
                 LayerIndex index) {
  SplitLayer layer;
  layer.slice.index = index;
  layer.slice.height = settings.layer_height;
  layer.slice.bottom = settings.layer_height * index;
  layer.slice.region = slice;
  OffsetCutter cutter(settings);
  layer.offsets = cutter.cut(layer.slice);
  layer.loose = loose;
  layer.solid = subtract(slice, loose);
  return layer;
}

// The layers of one part, planned one after the other, and each beside a plan of its own.
class Plans {
 public:
  explicit Plans(const Settings& settings) : settings_(settings), planner_(settings) {}

  // Whether the layer got the plan of one below.
  bool reuses(const SplitLayer& layer) {
    LayerPlanner::Reservation reserved = planner_.reserve(layer);
    if (reserved.to_fill) planner_.fill(*reserved.plan, true);
    LayerPlanner afresh(settings_);
    const LayerPlanner::Reservation own = afresh.reserve(layer);
    REQUIRE(own.to_fill);
    afresh.fill(*own.plan, true);
    afresh.resume_from(planner_.seam_memory());
    const std::vector<Road> roads = ordered(planner_, reserved.plan, layer.slice.index);
    const std::vector<Road> own_roads = ordered(afresh, own.plan, layer.slice.index);
    CHECK_EQ(planner_.seam_memory(), afresh.seam_memory());
    REQUIRE_EQ(roads.size(), own_roads.size());
    for (std::size_t i = 0; i < own_roads.size(); ++i) {
      CHECK_EQ(roads[i].points, own_roads[i].points);
      CHECK_EQ(roads[i].width, own_roads[i].width);
    }
    CHECK_EQ(reserved.plan->layer.loose, own.plan->layer.loose);
    CHECK_EQ(reserved.plan->layer.solid, own.plan->layer.solid);
    CHECK_EQ(reserved.plan->regularised_mm3, own.plan->regularised_mm3);
    return !reserved.to_fill;
  }

  [[nodiscard]] std::int64_t reused() const { return planner_.reused(); }
  // Layers whose roads were put in order.
  [[nodiscard]] int orders() const { return orders_; }

 private:
  std::vector<Road> ordered(LayerPlanner& planner, const std::shared_ptr<LayerPlan>& plan,
                            LayerIndex index) {
    const LayerPlanner::Ordering ordering = planner.place_seams(plan, index);
    if (ordering.to_order) {
      planner.order(*plan, ordering);
      if (&planner == &planner_) ++orders_;
    }
    return *ordering.roads;
  }

  int orders_ = 0;
  Settings settings_;
  LayerPlanner planner_;
};

const Region kSquare = test::region_from_text("0:0 30:0 30:20 0:20");
const Region kLarger = test::region_from_text("0:0 31:0 31:20 0:20");
const Region kInside = test::region_from_text("5:5 25:5 25:15 5:15");

TEST_CASE("a layer like the one two below gets its plan, and no other does") {
  const Settings settings;
  Plans plans(settings);
  for (LayerIndex i = 0; i < 8; ++i) {
    CAPTURE(i);
    // The first layer's skirt is its own: layer 2 cannot have its roads.
    CHECK_EQ(plans.reuses(split(kSquare, kInside, settings, i)), i >= 3);
  }
  CHECK_FALSE(plans.reuses(split(kLarger, kInside, settings, 8)));
  CHECK_FALSE(plans.reuses(split(kSquare, {}, settings, 9)));
  CHECK(plans.reuses(split(kLarger, kInside, settings, 10)));
  SplitLayer thicker = split(kLarger, kInside, settings, 12);
  thicker.slice.height = Length::from_mm(0.3);
  CHECK_FALSE(plans.reuses(thicker));
  CHECK_EQ(plans.reused(), 6);
  CHECK_EQ(plans.orders(), 12 - 6);
}

TEST_CASE("a plan is shared and its order is not where seams differ") {
  Settings settings;
  settings.seam = SeamPosition::kRandom;
  Plans plans(settings);
  for (LayerIndex i = 1; i < 8; ++i)
    static_cast<void>(plans.reuses(split(kSquare, kInside, settings, i)));
  CHECK_EQ(plans.reused(), 5);
  CHECK_EQ(plans.orders(), 7);
}

// Volume of the loose roads.
double loose_mm3(const LayerPlan& plan) {
  double sum = 0;
  for (const IslandRoads& island : plan.roads.islands) {
    for (const Road& road : island) {
      if (road.kind != RoadKind::kLoose) continue;
      const Length height = plan.layer.slice.height * road.layers;
      sum += length_mm(road) * bead_area_mm2(road.width, height);
    }
  }
  return sum;
}

TEST_CASE("the inside of a block is laid once, as much as in all its layers") {
  for (const LoosePattern pattern : {LoosePattern::kLines, LoosePattern::kGyroid}) {
    Settings settings;
    settings.layer_height = Length::from_mm(0.1);
    settings.loose_every_layers = 3;
    settings.loose_pattern = pattern;
    LooseBlocks blocks(settings);
    LayerPlanner planner(settings);
    for (LayerIndex i = 0; i < 18; ++i) blocks.push(split(kSquare, kInside, settings, i));
    std::vector<double> laid;
    while (auto layer = blocks.next()) {
      const LayerPlanner::Reservation reserved = planner.reserve(*std::move(layer));
      if (reserved.to_fill) planner.fill(*reserved.plan, true);
      laid.push_back(loose_mm3(*reserved.plan));
    }
    REQUIRE_EQ(laid.size(), 18);
    const double asked = 0.2 * kInside.area_mm2() * 0.3;
    for (std::size_t i = 0; i < laid.size(); ++i) {
      CAPTURE(i);
      if (i % 3 == 2) {
        CHECK(laid[i] == doctest::Approx(asked).epsilon(0.03));
      } else {
        CHECK_EQ(laid[i], 0);
      }
    }
    // The rows of the next block are turned; those of the one after it are the same. The first
    // layer's skirt is its own.
    CHECK_EQ(planner.reused(), pattern == LoosePattern::kLines ? 18 - 6 - 1 : 0);
  }
}

TEST_CASE("a rough surface is another one in each layer, on the same plan") {
  Settings settings;
  settings.fuzzy_skin = FuzzySkin::kOuter;
  Plans plans(settings);
  for (LayerIndex i = 1; i < 8; ++i)
    static_cast<void>(plans.reuses(split(kSquare, kInside, settings, i)));
  CHECK_EQ(plans.reused(), 5);
  CHECK_EQ(plans.orders(), 7);
}

TEST_CASE("without roads only the style is applied") {
  Settings settings;
  settings.style = BuildStyle::kRegular;
  LayerPlanner planner(settings);
  const LayerPlanner::Reservation reserved = planner.reserve(split(kSquare, kInside, settings, 3));
  planner.fill(*reserved.plan, false);
  CHECK(reserved.plan->roads.islands.empty());
  CHECK(reserved.plan->layer.loose.empty());
  CHECK_EQ(reserved.plan->layer.solid, kSquare);
  CHECK_EQ(reserved.plan->regularised_mm3, 0);
}

TEST_CASE("what regularisation moves is told") {
  Settings settings;
  settings.loose_area_min_mm2 = 1'000;
  LayerPlanner planner(settings);
  const LayerPlanner::Reservation reserved = planner.reserve(split(kSquare, kInside, settings, 3));
  planner.fill(*reserved.plan, false);
  CHECK(reserved.plan->layer.loose.empty());
  CHECK_EQ(reserved.plan->regularised_mm3, doctest::Approx(20 * 10 * 0.2));
}

}  // namespace
