#include "core/walls/layer_neighbours.h"

#include <doctest/doctest.h>

#include <vector>

using core::LayerNeighbours;
using core::Length;
using core::Region;
using core::SplitLayer;

namespace {

SplitLayer layer_of(core::LayerIndex index, std::int32_t side) {
  SplitLayer layer;
  layer.slice.index = index;
  layer.slice.height = Length::from_units(1'000 + index);
  layer.slice.region = Region::from_clean_rings({{{0, 0}, {side, 0}, {side, side}, {0, side}}});
  layer.loose = Region::from_clean_rings({{{10, 10}, {side / 2, 10}, {side / 2, side / 2}}});
  return layer;
}

}  // namespace

TEST_CASE("each layer knows the slices under it and over it, in order") {
  LayerNeighbours neighbours;
  std::vector<SplitLayer> settled;
  constexpr core::LayerIndex kLayers = 6;
  for (core::LayerIndex i = 0; i < kLayers; ++i) {
    auto next = neighbours.push(layer_of(i, static_cast<std::int32_t>(1'000 + 100 * i)));
    CHECK_EQ(next.has_value(), i > 0);
    if (next) settled.push_back(*std::move(next));
  }
  auto last = neighbours.finish();
  REQUIRE(last.has_value());
  settled.push_back(*std::move(last));
  CHECK_FALSE(neighbours.finish().has_value());
  REQUIRE_EQ(settled.size(), kLayers);
  CHECK_EQ(settled.front().below, nullptr);
  CHECK_EQ(settled.back().above, nullptr);
  for (std::size_t i = 0; i < settled.size(); ++i) {
    CHECK_EQ(settled[i].slice.index, static_cast<core::LayerIndex>(i));
    if (i > 0) CHECK(*settled[i].below == settled[i - 1].slice.region);
    if (i > 0) CHECK(*settled[i].below_loose == settled[i - 1].loose);
    if (i > 0) CHECK_EQ(settled[i].below_height, settled[i - 1].slice.height);
    if (i + 1 < settled.size()) CHECK(*settled[i].above == settled[i + 1].slice.region);
  }
}

TEST_CASE("equal slices share one copy") {
  LayerNeighbours neighbours;
  auto offsets = std::make_shared<core::SliceOffsets>();
  offsets->content = 3;
  std::vector<SplitLayer> settled;
  for (core::LayerIndex i = 0; i < 3; ++i) {
    SplitLayer layer = layer_of(i, 1'000);
    layer.offsets = offsets;
    if (auto next = neighbours.push(std::move(layer))) settled.push_back(*std::move(next));
  }
  REQUIRE_EQ(settled.size(), 2);
  CHECK_EQ(settled[1].below, settled[1].above);
}
