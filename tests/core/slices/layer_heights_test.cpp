#include "core/slices/layer_heights.h"

#include <doctest/doctest.h>

#include <random>

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

TEST_CASE("without a height of its own the first layer is like the others") {
  core::Settings settings;
  settings.layer_height = Length::from_mm(0.3);
  CHECK_EQ(layer_heights(settings).first, Length::from_mm(0.3));
  settings.first_layer_height = Length::from_mm(0.2);
  CHECK_EQ(layer_heights(settings).first, Length::from_mm(0.2));
  CHECK_EQ(layer_heights(settings).rest, Length::from_mm(0.3));
}
