// Parts as stacks of layers, with the inner offsets that the window needs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/offsets/layer_offsets.h"  // Layer
#include "core/regions/region.h"         // Region
#include "tools/parts/part_maker.h"      // Part

namespace test {

struct LayerStack {
  std::string name;
  std::vector<core::Region> slices;
  std::vector<core::Region> inners;  // inners[n] within slices[n]
};

// As input of the window; `layer_height` is 0.2 mm.
core::Layer layer_of(const LayerStack& stack, std::size_t n);

LayerStack upside_down(LayerStack stack);
// The lowest `layers` layers.
LayerStack prefix(LayerStack stack, std::size_t layers);

// Bodies of revolution and the like, polygons of 36 points; the inner offset is known exactly:
// cylinder, cone, sphere, hourglass, tube that leans, stairs.
std::vector<LayerStack> round_stacks(int layers, double wall_mm);

// An independent random region on every layer: the worst case.
LayerStack unlike_stack(int layers, std::uint64_t seed);

// Islands with holes that wander and waver from layer to layer, as a part's slices do; the inner
// offsets, at 0.8 mm, are the mountain's.
LayerStack wandering_stack(int layers, std::uint64_t seed);

// A mesh cut into about `layers` slices, with the mountain's inner offsets at 0.8 mm.
LayerStack sliced_stack(const std::string& name, const parts::Part& part, int layers);

}  // namespace test
