#include "core/walls/corners_ahead.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <vector>

using namespace core;

namespace {

SplitLayer layer_of(LayerIndex index) {
  SplitLayer layer;
  layer.slice.index = index;
  return layer;
}

// A window that settles layer n when slice n + `behind` is in it; its first layers at once.
std::vector<SplitLayer> run(int layers, int behind, LayerIndex first, LayerIndex end,
                            std::vector<std::shared_ptr<const CornerIndex>>& corners) {
  CornersAhead ahead(layers);
  std::vector<SplitLayer> out;
  LayerIndex pushed = first;
  std::size_t waiting = 0;
  const auto drain = [&] {
    while (auto layer = ahead.next()) out.push_back(*std::move(layer)), --waiting;
    CHECK_LE(waiting, static_cast<std::size_t>(layers) + 1);
  };
  for (LayerIndex i = first; i < end; ++i) {
    corners.push_back(std::make_shared<const CornerIndex>(Region(), Length::from_mm(1)));
    ahead.see(i, corners.back());
    for (; pushed <= i && (i < first + behind || pushed <= i - behind); ++pushed) {
      ahead.push(layer_of(pushed)), ++waiting;
    }
    drain();
  }
  ahead.end();
  for (; pushed < end; ++pushed) ahead.push(layer_of(pushed)), ++waiting;
  drain();
  CHECK_EQ(waiting, 0);
  return out;
}

}  // namespace

TEST_CASE("every layer leaves in order with the corners of the slices above it, never too early") {
  for (const int layers : {0, 1, 3, 8}) {
    for (const int behind : {8, 10}) {
      for (const LayerIndex first : {LayerIndex{0}, LayerIndex{5}}) {
        for (const LayerIndex end : {first, first + 1, first + 4, first + 40}) {
          CAPTURE(layers);
          CAPTURE(behind);
          CAPTURE(end);
          std::vector<std::shared_ptr<const CornerIndex>> corners;
          const auto out = run(layers, behind, first, end, corners);
          REQUIRE_EQ(static_cast<LayerIndex>(out.size()), end - first);
          for (std::size_t i = 0; i < out.size(); ++i) {
            CHECK_EQ(out[i].slice.index, first + static_cast<LayerIndex>(i));
            const std::size_t left = out.size() - 1 - i;
            REQUIRE_EQ(out[i].corners_above.size(),
                       std::min<std::size_t>(left, static_cast<std::size_t>(layers)));
            for (std::size_t k = 0; k < out[i].corners_above.size(); ++k) {
              CHECK_EQ(out[i].corners_above[k], corners[i + 1 + k]);
            }
          }
        }
      }
    }
  }
}
