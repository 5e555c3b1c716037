#include "core/walls/wall_splitter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/region.h"
#include "core/walls/split_layer.h"  // SplitLayer
#include "tests/support/layer_stacks.h"
#include "tests/support/paper_formula.h"
#include "tests/support/region_checks.h"

using core::Region;
using core::SplitLayer;
using core::WallSplitter;
using test::LayerStack;

namespace {

// Results of booleans are equal up to slivers of this width, in units (core/booleans/boolean.h).
constexpr double kSliverUnits = 2;

struct RegionOperations {
  static Region unite(const Region& a, const Region& b) { return core::unite(a, b); }
  static Region intersect(const Region& a, const Region& b) { return core::intersect(a, b); }
  static Region subtract(const Region& a, const Region& b) { return core::subtract(a, b); }
};

std::vector<SplitLayer> split(const LayerStack& stack, int t, WallSplitter& splitter) {
  std::vector<SplitLayer> result;
  const auto take = [&](std::optional<SplitLayer> layer) {
    const bool taken = layer.has_value();
    if (taken) result.push_back(*std::move(layer));
    return taken;
  };
  const auto bound = static_cast<std::size_t>(t);
  for (std::size_t n = 0; n < stack.slices.size(); ++n) {
    REQUIRE_EQ(splitter.next_index(), static_cast<core::LayerIndex>(n));
    take(splitter.push(test::layer_of(stack, n)));
    const WallSplitter::Usage usage = splitter.usage();
    REQUIRE_LE(usage.operations_last, std::bit_width(2 * bound) + 1);
    REQUIRE_LE(usage.layers_held, bound);
    REQUIRE_LE(usage.layers_held_peak, bound + 1);
    REQUIRE_LE(usage.regions_held, 2 * bound);
  }
  while (take(splitter.finish())) {
  }
  return result;
}

std::vector<SplitLayer> split(const LayerStack& stack, int t) {
  WallSplitter splitter(t);
  return split(stack, t, splitter);
}

std::vector<LayerStack> all_stacks(int layers) {
  std::vector<LayerStack> stacks = test::round_stacks(layers, 0.8);
  for (const std::uint64_t seed : {1u, 2u}) {
    stacks.push_back(test::wandering_stack(layers, seed));
    stacks.back().name += " " + std::to_string(seed);
  }
  return stacks;
}

}  // namespace

TEST_CASE("solid is what the paper's formula says") {
  std::vector<LayerStack> stacks = test::round_stacks(13, 0.8);
  stacks.push_back(test::wandering_stack(13, 1));
  stacks.push_back(test::unlike_stack(13, 3));
  stacks.push_back(test::sliced_stack("demo", parts::demo(), 13));
  stacks.push_back(test::sliced_stack("screw", parts::screw(), 13));
  double widest = 0;
  double loose_mm2 = 0;
  for (const LayerStack& stack : stacks) {
    CAPTURE(stack.name);
    for (const int t : {1, 2, 3, 5}) {
      CAPTURE(t);
      const std::vector<SplitLayer> layers = split(stack, t);
      REQUIRE_EQ(layers.size(), stack.slices.size());
      // The formula takes 6T booleans a layer; every third will do but for T = 1.
      for (std::size_t n = 0; n < layers.size(); n += t == 1 ? 1 : 3) {
        CAPTURE(n);
        const Region expected =
            test::paper_solid<RegionOperations>(stack.slices, stack.inners, static_cast<int>(n), t);
        const double width = test::widest_difference(layers[n].solid, expected);
        CHECK_LE(width, kSliverUnits);
        widest = std::max(widest, width);
        loose_mm2 += layers[n].loose.area_mm2();
      }
    }
  }
  MESSAGE("widest difference: " << widest << " units; loose: " << loose_mm2 << " mm²");
  CHECK_GT(loose_mm2, 10'000);  // not vacuous
}

TEST_CASE("solid and loose make up the slice and share nothing") {
  for (const LayerStack& stack : all_stacks(10)) {
    CAPTURE(stack.name);
    for (const SplitLayer& layer : split(stack, 2)) {
      CAPTURE(layer.slice.index);
      const Region& slice = layer.slice.region;
      CHECK(test::is_clean(layer.solid));
      CHECK(test::is_clean(layer.loose));
      CHECK_LE(test::widest_difference(core::unite(layer.solid, layer.loose), slice), kSliverUnits);
      CHECK_LE(test::widest_difference(core::intersect(layer.solid, layer.loose), Region()),
               kSliverUnits);
      CHECK_LE(
          test::widest_difference(
              core::subtract(layer.loose, layer.offsets->wall_inners.front().region), Region()),
          kSliverUnits);
    }
  }
}

TEST_CASE("the loose region shrinks as T grows") {
  for (const LayerStack& stack : all_stacks(10)) {
    CAPTURE(stack.name);
    std::vector<SplitLayer> before = split(stack, 1);
    for (const int t : {2, 3, 4}) {
      CAPTURE(t);
      std::vector<SplitLayer> after = split(stack, t);
      for (std::size_t n = 0; n < after.size(); ++n) {
        CAPTURE(n);
        const Region grown = core::subtract(after[n].loose, before[n].loose);
        CHECK_LE(test::widest_difference(grown, Region()), kSliverUnits);
      }
      before = std::move(after);
    }
  }
}

TEST_CASE("a part upside down gives the same layers in reverse") {
  for (const LayerStack& stack : all_stacks(10)) {
    CAPTURE(stack.name);
    const std::vector<SplitLayer> up = split(stack, 3);
    const std::vector<SplitLayer> down = split(test::upside_down(stack), 3);
    for (std::size_t n = 0; n < up.size(); ++n) {
      CAPTURE(n);
      CHECK_LE(test::widest_difference(up[n].loose, down[up.size() - 1 - n].loose), kSliverUnits);
    }
  }
}

TEST_CASE("a constant stack is loose between its caps, and nowhere else") {
  const LayerStack cylinder = test::round_stacks(12, 0.8).front();
  for (const int t : {1, 3, 5, 6}) {
    CAPTURE(t);
    const std::vector<SplitLayer> layers = split(cylinder, t);
    for (int n = 0; n < 12; ++n) {
      CAPTURE(n);
      const SplitLayer& layer = layers[static_cast<std::size_t>(n)];
      if (n < t || n >= 12 - t) {
        CHECK(layer.loose.empty());
        CHECK_EQ(layer.solid, layer.slice.region);
      } else {
        CHECK_EQ(test::widest_difference(layer.loose, layer.offsets->wall_inners.front().region),
                 0);
      }
    }
  }
}

TEST_CASE("what was settled does not change with what comes later") {
  const LayerStack stack = test::wandering_stack(14, 4);
  constexpr int t = 2;
  const std::vector<SplitLayer> whole = split(stack, t);
  for (std::size_t height = 0; height <= stack.slices.size(); ++height) {
    CAPTURE(height);
    const std::vector<SplitLayer> part = split(test::prefix(stack, height), t);
    REQUIRE_EQ(part.size(), height);
    for (std::size_t n = 0; n + t < height; ++n) {
      CHECK_EQ(part[n].loose, whole[n].loose);
      CHECK_EQ(part[n].solid, whole[n].solid);
    }
  }
}

TEST_CASE("layers pass through whole and in order, whatever the height") {
  const LayerStack stack = test::wandering_stack(9, 5);
  for (std::size_t height = 0; height <= 9; ++height) {
    for (const int t : {1, 2, 4, 9}) {
      const std::vector<SplitLayer> layers = split(test::prefix(stack, height), t);
      REQUIRE_EQ(layers.size(), height);
      for (std::size_t n = 0; n < height; ++n) {
        const core::Layer expected = test::layer_of(stack, n);
        CHECK_EQ(layers[n].slice.index, expected.slice.index);
        CHECK_EQ(layers[n].slice.bottom, expected.slice.bottom);
        CHECK_EQ(layers[n].slice.region, expected.slice.region);
        CHECK_EQ(layers[n].offsets->wall_inners.front().region,
                 expected.offsets->wall_inners.front().region);
      }
    }
  }
}

TEST_CASE("the largest window costs what the limits say, and what it holds stays the same") {
  LayerStack stack = test::round_stacks(1, 0.8).front();
  constexpr int t = core::kWallLayersMax;
  const auto grow_to = [&](std::size_t layers) {
    stack.slices.resize(layers, stack.slices.front());
    stack.inners.resize(layers, stack.inners.front());
    WallSplitter splitter(t);
    (void)split(stack, t, splitter);
    return splitter.usage();
  };
  const WallSplitter::Usage small = grow_to(2 * t + 2), tall = grow_to(6 * t);
  CHECK_EQ(small.operations_worst, core::kFoldCostMax + 1);
  CHECK_EQ(tall.operations_worst, small.operations_worst);
  CHECK_EQ(tall.layers_held_peak, t + 1);
  CHECK_EQ(tall.layers_held_peak, small.layers_held_peak);
  CHECK_EQ(tall.regions_held_peak, core::kWindowLayersMax - 1);
  CHECK_EQ(tall.regions_held_peak, small.regions_held_peak);
  CHECK_EQ(tall.layers_held, 0);
}
