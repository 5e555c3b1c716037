#include "core/walls/loose_blocks.h"

#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using namespace core;

namespace {

// A part whose slices and insides wander from layer to layer.
std::vector<SplitLayer> wandering(const Settings& settings, LayerIndex first, int count,
                                  std::uint64_t seed) {
  std::vector<SplitLayer> layers;
  OffsetCutter cutter(settings);
  test::Random random(seed);
  for (int i = 0; i < count; ++i) {
    SplitLayer layer;
    layer.slice.index = first + i;
    layer.slice.height = settings.layer_height;
    layer.slice.bottom = settings.layer_height * layer.slice.index;
    const double x = random.between(20, 22), y = random.between(20, 22);
    layer.slice.region = clean({test::random_blob(random, 40, x, y, 16, 0.1)}, FillRule::kNonZero);
    layer.loose = clean({test::random_blob(random, 40, x, y, 11, 0.3)}, FillRule::kNonZero);
    layer.offsets = cutter.cut(layer.slice);
    layers.push_back(std::move(layer));
  }
  return layers;
}

std::vector<SplitLayer> through(LooseBlocks& blocks, const std::vector<SplitLayer>& layers) {
  std::vector<SplitLayer> out;
  const auto take = [&] {
    while (auto layer = blocks.next()) out.push_back(*std::move(layer));
  };
  for (const SplitLayer& layer : layers) {
    blocks.push(layer);
    take();
  }
  blocks.end();
  take();
  return out;
}

Settings of_blocks(int layers) {
  Settings settings;
  settings.layer_height = Length::from_mm(0.1);
  settings.loose_every_layers = layers;
  settings.loose_width_min = Length();  // so that points can be asked one by one
  settings.loose_area_min_mm2 = 0;
  return settings;
}

bool holds(const Region& region, Point at) { return test::signed_distance(region, at.x, at.y) > 0; }

}  // namespace

TEST_CASE("a block is no thicker than the nozzle's bore and a road's width") {
  Settings settings;
  settings.loose_every_layers = 5;
  CHECK_EQ(loose_block_layers(settings), 2);
  settings.layer_height = Length::from_mm(0.1);
  CHECK_EQ(loose_block_layers(settings), 4);
  settings.road_width = Length::from_mm(0.35);
  CHECK_EQ(loose_block_layers(settings), 3);
  settings.loose_every_layers = 2;
  CHECK_EQ(loose_block_layers(settings), 2);
  settings.layer_height = Length::from_mm(0.39);
  CHECK_EQ(loose_block_layers(settings), 1);
  settings.layer_height = Length::from_mm(0.6);
  CHECK_EQ(loose_block_layers(settings), 1);
}

TEST_CASE("what is laid at once is what is loose in every layer of the block, within perimeters") {
  const Settings settings = of_blocks(3);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    const std::vector<SplitLayer> layers = wandering(settings, 6, 9, seed);
    LooseBlocks blocks(settings);
    const std::vector<SplitLayer> out = through(blocks, layers);
    REQUIRE_EQ(out.size(), layers.size());
    test::Random random(seed + 100);
    int in_block = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      CAPTURE(i);
      const LooseBlock& block = out[i].block;
      CHECK_EQ(out[i].slice.index, layers[i].slice.index);
      REQUIRE(block.region);
      CHECK_EQ(block.number, out[i].slice.index / 3);
      CHECK_EQ(block.layers, i % 3 == 2 ? 3 : 0);
      for (int k = 0; k < 200; ++k) {
        const Point at{static_cast<std::int32_t>(random.between(5, 37) * kUnitsPerMm),
                       static_cast<std::int32_t>(random.between(5, 37) * kUnitsPerMm)};
        bool in_all = true;
        for (std::size_t j = i - i % 3; j < i - i % 3 + 3; ++j) {
          in_all = in_all && holds(layers[j].loose, at) && holds(layers[j].offsets->interior, at);
        }
        CHECK_EQ(holds(*block.region, at), in_all);
        in_block += in_all ? 1 : 0;
      }
    }
    CHECK_GT(in_block, 100);
  }
}

TEST_CASE("blocks count from the bed; part of one, unequal layers and one solid layer are none") {
  const Settings settings = of_blocks(3);
  std::vector<SplitLayer> layers = wandering(settings, 4, 13, 7);  // 4 … 16
  layers[3].slice.height = Length::from_mm(0.15);                  // of layers 6 … 8
  layers[10].loose = {};                                           // of layers 12 … 14
  LooseBlocks blocks(settings);
  const std::vector<SplitLayer> out = through(blocks, layers);
  REQUIRE_EQ(out.size(), layers.size());
  for (const SplitLayer& layer : out) {
    const LayerIndex index = layer.slice.index;
    CAPTURE(index);
    CHECK_EQ(layer.block.region != nullptr, index >= 9 && index < 12);
  }
}

TEST_CASE("a file's layers that are higher than the settings' make no block that is too thick") {
  const Settings settings = of_blocks(3);
  for (const double height_mm : {0.13, 0.14}) {
    CAPTURE(height_mm);
    std::vector<SplitLayer> layers = wandering(settings, 3, 9, 11);
    for (SplitLayer& layer : layers) layer.slice.height = Length::from_mm(height_mm);
    LooseBlocks blocks(settings);
    for (const SplitLayer& layer : through(blocks, layers)) {
      CHECK_EQ(layer.block.region != nullptr, height_mm * 3 <= settings.nozzle_diameter.mm());
    }
  }
}

TEST_CASE("layers are held until their block is known, and no longer") {
  const Settings settings = of_blocks(4);
  LooseBlocks blocks(settings);
  for (const SplitLayer& layer : wandering(settings, 0, 8, 3)) {
    blocks.push(layer);
    int out = 0;
    while (blocks.next()) ++out;
    CHECK_EQ(out, layer.slice.index % 4 == 3 ? 4 : 0);
  }
  Settings none = settings;
  none.loose_every_layers = 1;
  LooseBlocks passing(none);
  for (const SplitLayer& layer : wandering(none, 0, 3, 3)) {
    passing.push(layer);
    REQUIRE(passing.next().has_value());
    CHECK_FALSE(passing.next().has_value());
  }
}
