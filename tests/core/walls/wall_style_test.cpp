#include "core/walls/wall_style.h"

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "core/walls/wall_splitter.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::BuildStyle;
using core::Length;
using core::Region;
using core::Settings;
using core::SplitLayer;

namespace {

// A block of 20 x 20 mm, the upper half of it 16 x 20 mm: 20 layers of 0.2 mm.
std::vector<SplitLayer> build(BuildStyle style) {
  Settings settings;
  settings.style = style;
  settings.wall_thickness = Length::from_mm(0.6);
  settings = core::with_style(settings);
  core::OffsetCutter cutter(settings);
  core::WallSplitter splitter(settings);
  core::WallStyle wall_style(settings);
  std::vector<SplitLayer> layers;
  const auto take = [&](std::optional<SplitLayer> layer) {
    if (!layer.has_value()) return false;
    layers.push_back(wall_style.apply(*std::move(layer)));
    return true;
  };
  for (int n = 0; n < 20; ++n) {
    core::Slice slice;
    slice.index = n;
    slice.height = settings.layer_height;
    slice.bottom = slice.height * n;
    slice.region = test::region_from_text(n < 10 ? "0:0 20:0 20:20 0:20" : "0:0 16:0 16:20 0:20");
    take(splitter.push({slice, cutter.cut(slice)}));
  }
  while (take(splitter.finish())) {
  }
  return layers;
}

TEST_CASE("regular is dense everywhere") {
  for (const SplitLayer& layer : build(BuildStyle::kRegular)) {
    CHECK(layer.loose.empty());
    CHECK_EQ(layer.solid, layer.slice.region);
  }
}

TEST_CASE("fast is loose just where the whole layer is hidden, within three perimeters") {
  const std::vector<SplitLayer> layers = build(BuildStyle::kFast);
  REQUIRE_EQ(layers.size(), 20);
  for (int n = 0; n < 20; ++n) {
    CAPTURE(n);
    const SplitLayer& layer = layers[static_cast<std::size_t>(n)];
    // T = 3: caps, and the three layers below the step.
    const bool hidden = (n >= 3 && n < 7) || (n >= 10 && n < 17);
    CHECK_EQ(layer.loose.empty(), !hidden);
    CHECK_EQ(layer.offsets->perimeters.size(), 3);
    if (hidden) CHECK_EQ(layer.loose, layer.offsets->interior);
    CHECK_LE(test::widest_difference(core::unite(layer.solid, layer.loose), layer.slice.region), 2);
  }
}

TEST_CASE("thin-wall is loose on every layer within the caps, with or without a step above") {
  const std::vector<SplitLayer> layers = build(BuildStyle::kThinWall);
  for (int n = 3; n < 17; ++n) {
    CAPTURE(n);
    CHECK_GT(layers[static_cast<std::size_t>(n)].loose.area_mm2(), 200);
  }
}

}  // namespace
