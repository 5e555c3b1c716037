#include "tests/support/tree_stacks.h"

#include <memory>

#include "core/booleans/boolean.h"
#include "core/supports/tree_fold.h"
#include "core/supports/tree_reach.h"
#include "core/supports/tree_standing.h"
#include "tests/support/random_regions.h"

namespace test {

using core::Length;
using core::Region;

core::Settings tree_settings(core::SupportPlace place, double layer_height_mm) {
  core::Settings settings;
  settings.bed_x = settings.bed_y = Length::from_mm(200);
  settings.layer_height = Length::from_mm(layer_height_mm);
  settings.supports = place;
  settings.support_style = core::SupportStyle::kTree;
  return settings;
}

std::vector<Region> ledges(std::uint64_t seed, int layers) {
  Random random(seed);
  std::vector<Region> slices;
  while (slices.size() < static_cast<std::size_t>(layers)) {
    std::vector<core::Ring> rings;
    const int blobs = random.integer(1, 3);
    for (int i = 0; i < blobs; ++i) {
      const double radius = random.between(2, 10);
      const double x = random.between(30, 50), y = random.between(30, 50);
      rings.push_back(random_blob(random, 12, x, y, radius, 0.3));
    }
    const Region slice = core::clean(rings, core::FillRule::kNonZero);
    const int alike = random.integer(3, 12);
    for (int i = 0; i < alike; ++i) slices.push_back(slice);
  }
  slices.resize(static_cast<std::size_t>(layers));
  return slices;
}

std::vector<core::SharedRegion> avoided_in(const std::vector<Region>& slices,
                                           const core::Settings& settings) {
  core::TreeReach reach(settings);
  std::vector<core::SharedRegion> avoided;
  for (const Region& slice : slices) avoided.push_back(reach.push(slice, settings.layer_height));
  return avoided;
}

TreeStack trees_for(const std::vector<Region>& slices, const core::Settings& settings) {
  const std::vector<core::SharedRegion> avoided = avoided_in(slices, settings);
  TreeStack stack;
  stack.layers.resize(slices.size());
  stack.nodes.resize(slices.size());
  core::TreeFold fold(settings);
  const auto take = [&] {
    while (auto layer = fold.next()) {
      const auto n = static_cast<std::size_t>(layer->index);
      stack.layers[n] = *layer;
      stack.nodes[n] = fold.nodes();
    }
  };
  core::SharedRegion last;
  for (std::size_t i = slices.size(); i-- > 0;) {
    if (!last || !(*last == slices[i])) last = std::make_shared<const Region>(slices[i]);
    const Length height = settings.layer_height;
    fold.push(
        {static_cast<core::LayerIndex>(i), height * static_cast<std::int64_t>(i), height, last},
        avoided[i]);
    take();
  }
  fold.end();
  take();
  core::TreeStanding standing;
  for (core::SupportLayer& layer : stack.layers) layer = standing.standing(layer);
  return stack;
}

}  // namespace test
