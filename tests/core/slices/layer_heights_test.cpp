#include "core/slices/layer_heights.h"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using core::HeightBand;
using core::LayerHeights;
using core::LayerIndex;
using core::Length;

namespace {

LayerHeights heights_of(std::int64_t first, std::int64_t rest) {
  return {Length::from_units(first), Length::from_units(rest)};
}

LayerIndex count_of(std::int64_t top, const LayerHeights& heights) {
  return heights.count(Length::from_units(top));
}

}  // namespace

TEST_CASE("a layer is there if its plane, halfway up, is not above the part") {
  const LayerHeights even = heights_of(2'000, 2'000);
  CHECK_EQ(count_of(0, even), 0);
  CHECK_EQ(count_of(999, even), 0);
  CHECK_EQ(count_of(1'000, even), 1);
  CHECK_EQ(count_of(2'999, even), 1);
  CHECK_EQ(count_of(3'000, even), 2);
  // Odd layer heights: the plane is between two units.
  CHECK_EQ(count_of(2, heights_of(5, 5)), 0);
  CHECK_EQ(count_of(3, heights_of(5, 5)), 1);
  const LayerHeights thick_first = heights_of(3'000, 1'000);
  CHECK_EQ(count_of(1'499, thick_first), 0);
  CHECK_EQ(count_of(1'500, thick_first), 1);
  CHECK_EQ(count_of(3'499, thick_first), 1);
  CHECK_EQ(count_of(3'500, thick_first), 2);
}

TEST_CASE("layers lie on one another, and are counted as they are cut") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    const LayerHeights heights = heights_of(1 + static_cast<std::int64_t>(random() % 50),
                                            1 + static_cast<std::int64_t>(random() % 50));
    const auto top = static_cast<std::int64_t>(random() % 2'000);
    LayerIndex layers = 0;
    Length bottom;
    while (heights.doubled_plane(layers) <= 2 * top) {
      REQUIRE_EQ(heights.bottom(layers), bottom);
      REQUIRE_EQ(heights.doubled_plane(layers), (bottom * 2 + heights.height(layers)).units());
      bottom += heights.height(layers++);
    }
    CHECK_EQ(count_of(top, heights), layers);
  }
}

TEST_CASE("runs of layers answer as a walk over all layers does") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    std::vector<HeightBand> bands;
    std::vector<Length> layers;
    Length bottom;
    for (std::size_t band = 1 + random() % 12; band > 0; --band) {
      const Length height = Length::from_units(1 + static_cast<std::int64_t>(random() % 50));
      bands.push_back({static_cast<LayerIndex>(layers.size()), bottom, height});
      for (std::size_t layer = 1 + random() % 5; layer > 0; --layer) {
        layers.push_back(height);
        bottom += height;
      }
    }
    // The last one goes on.
    for (int layer = 0; layer < 20; ++layer) layers.push_back(bands.back().height);
    const LayerHeights heights(bands);
    Length walked;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
      const auto index = static_cast<LayerIndex>(layer);
      REQUIRE_EQ(heights.height(index), layers[layer]);
      REQUIRE_EQ(heights.bottom(index), walked);
      REQUIRE_EQ(heights.doubled_plane(index), (walked * 2 + layers[layer]).units());
      walked += layers[layer];
    }
    const std::int64_t sure = walked.units() - layers.back().units();
    for (std::int64_t top = 0; top < sure; ++top) {
      LayerIndex count = 0;
      while (heights.doubled_plane(count) <= 2 * top) ++count;
      REQUIRE_EQ(count_of(top, heights), count);
    }
  }
}
