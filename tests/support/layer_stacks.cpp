#include "tests/support/layer_stacks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/booleans/boolean.h"
#include "core/geometry.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/slices/plane_sweep.h"
#include "core/units.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"

namespace test {
namespace {

using core::Length;
using core::Region;
using core::Ring;

constexpr int kRoundPoints = 36;
constexpr double kLayerHeightMm = 0.2;

struct Round {
  double x_mm = 0;
  double outer_mm = 0;  // radius
  double bore_mm = 0;   // radius; 0: none
};

Ring circle(double x_mm, double radius_mm, bool counter_clockwise) {
  Ring ring;
  for (int i = 0; i < kRoundPoints; ++i) {
    const double angle = (counter_clockwise ? 2 : -2) * std::numbers::pi * i / kRoundPoints;
    ring.push_back(
        {static_cast<std::int32_t>(Length::from_mm(x_mm + radius_mm * std::cos(angle)).units()),
         static_cast<std::int32_t>(Length::from_mm(radius_mm * std::sin(angle)).units())});
  }
  return ring;
}

Region region_of(const Round& round) {
  if (round.outer_mm < 0.01 || round.outer_mm - round.bore_mm < 0.01) return Region();
  std::vector<Ring> rings{circle(round.x_mm, round.outer_mm, true)};
  if (round.bore_mm > 0.01) rings.push_back(circle(round.x_mm, round.bore_mm, false));
  return Region::from_clean_rings(std::move(rings));
}

template <typename ShapeAt>
LayerStack round_stack(const std::string& name, int layers, double wall_mm, ShapeAt shape_at) {
  LayerStack stack{name, {}, {}};
  for (int n = 0; n < layers; ++n) {
    Round round = shape_at((n + 0.5) / layers);
    stack.slices.push_back(region_of(round));
    round.outer_mm -= wall_mm;
    if (round.bore_mm > 0.01) round.bore_mm += wall_mm;
    stack.inners.push_back(region_of(round));
  }
  return stack;
}

Region inner_offset(const Region& slice) {
  return core::offset(slice, Length::from_mm(0.8), Length::from_mm(0.02));
}

}  // namespace

core::Layer layer_of(const LayerStack& stack, std::size_t n) {
  core::Layer layer;
  layer.slice.index = static_cast<core::LayerIndex>(n);
  layer.slice.height = Length::from_mm(kLayerHeightMm);
  layer.slice.bottom = layer.slice.height * layer.slice.index;
  layer.slice.region = stack.slices[n];
  core::SliceOffsets offsets;
  offsets.content = layer.slice.index;
  offsets.wall_inners.push_back({Length(), stack.inners[n]});
  layer.offsets = std::make_shared<core::SliceOffsets>(std::move(offsets));
  return layer;
}

LayerStack upside_down(LayerStack stack) {
  std::reverse(stack.slices.begin(), stack.slices.end());
  std::reverse(stack.inners.begin(), stack.inners.end());
  return stack;
}

LayerStack prefix(LayerStack stack, std::size_t layers) {
  stack.slices.resize(std::min(layers, stack.slices.size()));
  stack.inners.resize(stack.slices.size());
  return stack;
}

std::vector<LayerStack> round_stacks(int layers, double wall_mm) {
  const auto make = [&](const char* name, auto shape_at) {
    return round_stack(name, layers, wall_mm, shape_at);
  };
  return {
      make("cylinder",
           [](double) {
             return Round{0, 8, 0};
           }),
      make("cone",
           [](double t) {
             return Round{0, 12 * (1 - t), 0};
           }),
      make("sphere",
           [](double t) {
             return Round{0, 10 * std::sqrt(1 - (2 * t - 1) * (2 * t - 1)), 0};
           }),
      make("hourglass",
           [](double t) {
             return Round{0, 2 + 10 * std::abs(2 * t - 1), 0};
           }),
      make("leaning tube",
           [](double t) {
             return Round{12 * t, 9, 4 + 2 * t};
           }),
      make("stairs",
           [](double t) {
             return Round{0, 3 + 2 * std::floor(5 * t), 0};
           }),
  };
}

LayerStack unlike_stack(int layers, std::uint64_t seed) {
  Random random(seed);
  LayerStack stack{"unlike", {}, {}};
  for (int n = 0; n < layers; ++n) {
    stack.slices.push_back(random_region(random, 24, 20));
    stack.inners.push_back(core::intersect(stack.slices.back(), random_region(random, 24, 20)));
  }
  return stack;
}

LayerStack wandering_stack(int layers, std::uint64_t seed) {
  Random random(seed);
  struct Blob {
    std::uint64_t seed;
    double x_mm, y_mm, radius_mm, drift_mm, growth_mm;
    bool hole;
  };
  std::vector<Blob> blobs;
  for (int i = 0; i < 5; ++i) {
    const bool hole = i >= 3;
    blobs.push_back({seed + static_cast<std::uint64_t>(i), random.between(-8, 8),
                     random.between(-8, 8), random.between(4, 8) / (hole ? 3 : 1),
                     random.between(-0.3, 0.3), random.between(-0.2, 0.2), hole});
  }
  LayerStack stack{"wandering", {}, {}};
  for (int n = 0; n < layers; ++n) {
    Region slice;
    for (const Blob& blob : blobs) {
      // The same wavering outline on every layer, a little elsewhere, a little larger or smaller.
      Random outline(blob.seed);
      const double radius = std::max(0.3, blob.radius_mm + n * blob.growth_mm);
      const Ring ring =
          random_blob(outline, 32, blob.x_mm + n * blob.drift_mm, blob.y_mm, radius, 0.2);
      const Region piece = core::clean({ring}, core::FillRule::kNonZero);
      slice = blob.hole ? core::subtract(slice, piece) : core::unite(slice, piece);
    }
    stack.inners.push_back(inner_offset(slice));
    stack.slices.push_back(std::move(slice));
  }
  return stack;
}

LayerStack sliced_stack(const std::string& name, const parts::Part& part, int layers) {
  std::vector<core::Triangle> triangles = triangles_of(part);
  std::int64_t top = 0;
  for (const core::Triangle& triangle : triangles) top = std::max(top, triangle.highest_z());
  core::PlaneSweep::Options options = exact_options();
  const Length height = Length::from_units(top / layers);
  options.heights = {height, height};
  options.simplify_tolerance = Length::from_mm(0.05);
  LayerStack stack{name, {}, {}};
  for (core::Slice& slice : sweep(std::move(triangles), options).slices) {
    stack.inners.push_back(inner_offset(slice.region));
    stack.slices.push_back(std::move(slice.region));
  }
  return stack;
}

}  // namespace test
