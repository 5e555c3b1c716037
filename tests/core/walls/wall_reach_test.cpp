#include "core/walls/wall_reach.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/support/random_regions.h"

using core::Length;
using core::Settings;
using core::Slice;
using core::WallReach;
using test::Random;

namespace {

std::vector<Slice> stack(Random& random, int layers) {
  std::vector<Slice> slices;
  Length bottom;
  for (int i = 0; i < layers; ++i) {
    Slice slice;
    slice.index = i;
    slice.bottom = bottom;
    slice.height = Length::from_units(random.integer(500, 4'000));
    bottom = slice.top();
    slices.push_back(slice);
  }
  return slices;
}

// From the mid-plane of one slab to the nearest point of another, in units.
double gap(const Slice& from, const Slice& to) {
  const double middle =
      static_cast<double>(from.bottom.units()) + static_cast<double>(from.height.units()) / 2;
  if (from.index == to.index) return 0;
  return to.index > from.index ? static_cast<double>(to.bottom.units()) - middle
                               : middle - static_cast<double>(to.top().units());
}

}  // namespace

TEST_CASE("a ball reaches what is nearer than its radius, and as deep as its circle there") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const std::vector<Slice> slices = stack(random, 30);
    const double w = random.integer(1'000, 20'000);
    const WallReach reach(Length::from_units(static_cast<std::int64_t>(w)));
    for (const Slice& from : slices) {
      for (const Slice& to : slices) {
        const double z = gap(from, to);
        CHECK_EQ(reach.includes(from, to), z < w);
        if (z >= w) continue;
        CHECK(std::abs(static_cast<double>(reach.depth(from, to).units()) -
                       std::sqrt(w * w - z * z)) <= 0.5 + 1e-6);
      }
      // The bed is at height 0; a layer on the newest one would have its near face at its top.
      Slice below, above;
      below.index = -1;
      CHECK_EQ(reach.includes_bed(from), gap(from, below) < w);
      above.index = 30;
      above.bottom = slices.back().top();
      CHECK_EQ(reach.ends_within(slices.back(), from), gap(from, above) >= w);
    }
  }
}

TEST_CASE("a cylinder, and the fast style, count layers") {
  Random random(1);
  const std::vector<Slice> slices = stack(random, 20);
  Settings cylinder;
  cylinder.wall_shape = core::WallShape::kCylinder;
  cylinder.wall_layers = 3;
  Settings fast = cylinder;
  fast.wall_shape = core::WallShape::kBall;
  fast.style = core::BuildStyle::kFast;
  for (const Settings& settings : {cylinder, fast}) {
    const WallReach reach(settings);
    const int t = core::wall_layers(settings);
    for (const Slice& from : slices) {
      CHECK_EQ(reach.includes_bed(from), from.index < t);
      CHECK_EQ(reach.ends_within(slices.back(), from), 19 - from.index >= t);
      for (const Slice& to : slices) {
        CHECK_EQ(reach.includes(from, to), std::abs(from.index - to.index) <= t);
        CHECK_EQ(reach.depth(from, to), settings.wall_thickness);
      }
    }
  }
}

TEST_CASE("layers are visited from the nearest outwards, and a direction ends once") {
  const auto visited = [](std::size_t count, std::size_t centre, std::size_t low,
                          std::size_t high) {
    std::vector<std::size_t> order;
    core::visit_outwards(count, centre, [&](std::size_t number) {
      if (number < low || number > high) return false;
      order.push_back(number);
      return true;
    });
    return order;
  };
  using Order = std::vector<std::size_t>;
  CHECK_EQ(visited(7, 3, 0, 6), Order{3, 4, 2, 5, 1, 6, 0});
  CHECK_EQ(visited(7, 1, 0, 6), Order{1, 2, 0, 3, 4, 5, 6});
  CHECK_EQ(visited(7, 3, 3, 6), Order{3, 4, 5, 6});
  CHECK_EQ(visited(1, 0, 0, 0), Order{0});
  CHECK(visited(3, 1, 5, 6).empty());
}
