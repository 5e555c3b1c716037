// Supports from above, held against stacks of cells, where everything can be counted.
#include "core/supports/support_fold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/supports/bed_columns.h"
#include "core/supports/hanging_regions.h"
#include "tests/support/cell_stacks.h"
#include "tests/support/layer_stacks.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;
using test::Cells;
using test::kCells;

namespace {

// By layer, from 0.
std::vector<SupportLayer> fold(const std::vector<Region>& slices, const Settings& settings,
                               bool shared = true) {
  SupportFold fold(settings);
  std::vector<SupportLayer> found(slices.size());
  const auto take = [&] {
    while (auto layer = fold.next()) found[static_cast<std::size_t>(layer->index)] = *layer;
  };
  SharedRegion last;
  for (std::size_t i = slices.size(); i-- > 0;) {
    if (!shared || !last || !(*last == slices[i])) last = std::make_shared<const Region>(slices[i]);
    const Length height = settings.layer_height;
    fold.push({static_cast<LayerIndex>(i), height * static_cast<std::int64_t>(i), height, last});
    take();
  }
  fold.end();
  take();
  return found;
}

bool any_above(const std::vector<Cells>& stack, std::size_t layer, std::size_t cell) {
  return std::any_of(stack.begin() + static_cast<std::ptrdiff_t>(layer) + 1, stack.end(),
                     [&](const Cells& cells) { return cells[cell]; });
}

}  // namespace

TEST_CASE("supports stand in every empty cell under something: everywhere, or down to the bed") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const std::vector<Cells> stack = test::random_cells(seed, 8);
    const std::vector<SupportLayer> found =
        fold(test::regions_of(stack), test::settings_of_cells());
    BedColumns columns;
    Cells open(kCells * kCells, true);
    for (std::size_t n = 0; n < stack.size(); ++n) {
      CAPTURE(n);
      Cells everywhere(open.size()), bed(open.size());
      for (std::size_t i = 0; i < open.size(); ++i) {
        everywhere[i] = !stack[n][i] && any_above(stack, n, i);
        bed[i] = open[i] && everywhere[i];
        open[i] = bed[i];
      }
      CHECK_LT(test::widest_difference(*found[n].region, test::region_of_cells(everywhere)),
               test::kCellCornerUnits);
      CHECK_LT(
          test::widest_difference(*columns.standing(found[n]).region, test::region_of_cells(bed)),
          test::kCellCornerUnits);
    }
  }
}

TEST_CASE("gaps leave out the layers over and under the part; what is near them is dense") {
  Settings settings = test::settings_of_cells();
  settings.support_top_gap_layers = 2;
  settings.support_bottom_gap_layers = 1;
  settings.support_interface_layers = 1;
  settings.support_bottom_interface_layers = 2;
  for (std::uint64_t seed = 20; seed < 30; ++seed) {
    CAPTURE(seed);
    const std::vector<Cells> stack = test::random_cells(seed, 9);
    const auto solid = [&](std::size_t n, int up, std::size_t cell) {
      const auto layer = static_cast<std::ptrdiff_t>(n) + up;
      return layer >= 0 && layer < static_cast<std::ptrdiff_t>(stack.size()) &&
             stack[static_cast<std::size_t>(layer)][cell];
    };
    const std::vector<SupportLayer> found = fold(test::regions_of(stack), settings);
    for (std::size_t n = 0; n < stack.size(); ++n) {
      CAPTURE(n);
      Cells laid(kCells * kCells), dense(laid.size());
      for (std::size_t i = 0; i < laid.size(); ++i) {
        const bool free = !solid(n, 0, i) && !solid(n, 1, i) && !solid(n, 2, i) && !solid(n, -1, i);
        laid[i] = free && n + 2 < stack.size() && any_above(stack, n + 2, i);
        // The bed is nearer than the gap.
        if (n == 0) laid[i] = !solid(0, 0, i) && any_above(stack, 0, i);
        const int gap = n == 0 ? 0 : 2;
        dense[i] = laid[i] && (solid(n, gap + 1, i) || solid(n, -2, i) || solid(n, -3, i));
      }
      CHECK_LT(test::widest_difference(*found[n].region, test::region_of_cells(laid)),
               test::kCellCornerUnits);
      CHECK_LT(test::widest_difference(*found[n].interface, test::region_of_cells(dense)),
               test::kCellCornerUnits);
    }
  }
}

TEST_CASE("100,000 equal layers leave demand as it is, bit for bit") {
  const Region post = test::rectangle_region(0.00013, 0, 5.1, 5.7);
  test::Random random(7);
  const Ring blob = test::random_blob(random, 23, 3, 3, 6, 0.4);
  const Region roof = unite(clean({blob}, FillRule::kPositive), post);
  const Settings settings = test::settings_of_cells();
  SupportFold fold(settings);
  LayerIndex index = 2'003;
  const auto push = [&](const Region& slice) {
    // A region of its own each time: nothing is known to be equal.
    const Length height = settings.layer_height;
    fold.push({--index, height * index, height, std::make_shared<const Region>(slice)});
    while (fold.next()) {
    }
  };
  push(roof);
  push(post);
  const Region demand = fold.demand();
  REQUIRE_FALSE(demand.empty());
  for (int i = 0; i < 2'000; ++i) push(post);
  CHECK(fold.demand() == demand);
  // The fold's two operations alone.
  const Region hanging = hanging_regions(post, post, settings.layer_height, settings).overhangs;
  Region carried = demand;
  for (int i = 0; i < 100'000; ++i) carried = subtract(unite(carried, hanging), post);
  CHECK(carried == demand);
}

TEST_CASE("a fold that keeps a few layers finds what one that keeps all would find") {
  Settings settings;
  settings.supports = SupportPlace::kEverywhere;
  settings.support_area_min_mm2 = 0;
  for (const std::uint64_t seed : {3u, 4u}) {
    CAPTURE(seed);
    const std::vector<Region> slices = test::wandering_stack(24, seed).slices;
    const std::vector<SupportLayer> found = fold(slices, settings);
    const std::vector<SupportLayer> unshared = fold(slices, settings, false);
    for (std::size_t n = 0; n < slices.size(); ++n) {
      CAPTURE(n);
      CHECK(*found[n].region == *unshared[n].region);
      // Under each slice above, what hangs of it and lies over none between.
      Region demand;
      for (std::size_t m = n == 0 ? 1 : n + 2; m < slices.size(); ++m) {
        HangingRegions hanging =
            hanging_regions(slices[m], slices[m - 1], settings.layer_height, settings);
        Region under = unite(hanging.overhangs, hanging.islands);
        for (std::size_t j = n; j < m; ++j) under = subtract(under, slices[j]);
        demand = unite(demand, under);
      }
      // All that is laid under an overhang is demand, but for what widens islands and thin strips.
      const Region beyond = subtract(*found[n].region, demand);
      CHECK_LT(2 * beyond.area_mm2() / std::max(beyond.perimeter_mm(), 1e-9), 2.1);
      // But for crumbs of a slice that its simplification loses.
      CHECK_LT(intersect(*found[n].region, slices[n]).area_mm2(), 1e-3);
      CHECK(subtract(*found[n].interface, *found[n].region).area_mm2() < 0.01);
    }
  }
}

TEST_CASE("what stands on the part ends there, also where the part needs no support itself") {
  Settings settings = test::settings_of_cells();
  settings.bridge_max = Length::from_mm(10);
  const Region posts =
      unite(test::rectangle_region(0, 0, 5, 10), test::rectangle_region(13, 0, 5, 10));
  const Region deck = test::rectangle_region(0, 0, 18, 10);
  std::vector<Region> slices(10, posts);
  slices.push_back(deck);
  slices.insert(slices.end(), 10, test::rectangle_region(0, 0, 5, 10));
  slices.push_back(test::rectangle_region(0, 0, 12, 10));
  const std::vector<SupportLayer> found = fold(slices, settings);
  for (std::size_t n = 0; n < slices.size(); ++n) {
    CAPTURE(n);
    CHECK_EQ(found[n].empty(), n <= 10 || n == 21);
  }
}

TEST_CASE("the base is wider towards the bed, and keeps its distance from the part") {
  Settings settings = test::settings_of_cells();
  settings.support_base_expansion = Length::from_mm(1);
  settings.support_xy_distance = Length::from_mm(0.4);
  const Region post = test::rectangle_region(0, 0, 10, 10);
  std::vector<Region> slices(30, post);
  slices.push_back(test::rectangle_region(0, 0, 20, 10));
  const std::vector<SupportLayer> found = fold(slices, settings);
  CHECK_EQ(found[10].region->area_mm2(), doctest::Approx(9.6 * 10).epsilon(0.01));
  CHECK_EQ(found[0].region->area_mm2(), doctest::Approx(10.6 * 12).epsilon(0.02));
  CHECK_EQ(found[2].region->area_mm2(), doctest::Approx(10.2 * 11.2).epsilon(0.02));
  for (const SupportLayer& layer : found) {
    for (const Ring& ring : layer.region->rings()) {
      for (const Point at : ring) {
        // Half the distance right under what hangs.
        const double least = layer.index == 29 ? 2'000 : 4'000;
        CHECK_GT(-test::signed_distance(post, at.x, at.y), least - 250);
      }
    }
  }
}

TEST_CASE("what hangs over the first layer is held by it, close to the part and widened") {
  Settings settings = test::settings_of_cells();
  settings.support_top_gap_layers = 1;
  settings.support_base_expansion = Length::from_mm(1);
  settings.support_xy_distance = Length::from_mm(0.4);
  const Region post = test::rectangle_region(0, 0, 10, 10);
  const std::vector<SupportLayer> found =
      fold({post, test::rectangle_region(0, 0, 10.6, 10)}, settings);
  CHECK(found[0].region->contains({103'000, 50'000}));
  CHECK(found[0].region->contains({115'000, 50'000}));
  CHECK_FALSE(found[0].region->contains({101'500, 50'000}));
  CHECK(found[1].empty());
}

TEST_CASE("a part without anything that hangs has no supports") {
  Settings settings;
  settings.supports = SupportPlace::kEverywhere;
  for (const test::LayerStack& stack : test::round_stacks(20, 0.8)) {
    if (stack.name != "cylinder" && stack.name != "cone") continue;
    CAPTURE(stack.name);
    for (const SupportLayer& layer : fold(stack.slices, settings)) CHECK(layer.empty());
  }
  CHECK(fold({}, settings).empty());
}
