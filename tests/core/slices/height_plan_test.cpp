#include "core/slices/height_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/limits.h"
#include "core/slices/height_ceiling.h"
#include "core/slices/height_ranges.h"
#include "tests/support/adaptive_heights.h"

using core::HeightLimits;
using core::LayerHeights;
using core::LayerIndex;
using core::Length;
using core::Settings;
using core::Triangle;

namespace {

double upwards(const Triangle& t) {
  const auto& [a, b, c] = t.corners;
  const double ux = b.x - a.x, uy = b.y - a.y, uz = static_cast<double>(b.z - a.z);
  const double vx = c.x - a.x, vy = c.y - a.y, vz = static_cast<double>(c.z - a.z);
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  return std::abs(nz) / std::sqrt(nx * nx + ny * ny + nz * nz);
}

std::vector<Triangle> random_facets(std::mt19937& random, std::int64_t top) {
  std::vector<Triangle> facets;
  const auto below = [&](std::int64_t most) { return static_cast<std::int64_t>(random()) % most; };
  for (int i = 0; i < 12; ++i) {
    const std::int64_t low = below(top), span = 20 + below(40'000);
    const auto wide = static_cast<std::int32_t>(1 + below(40'000));
    facets.push_back({{core::Vertex{0, 0, low}, {0, 9'000, low}, {wide, 0, low + span}}});
  }
  return facets;
}

// Where the heights of neighbours are free: neither of a range nor below one.
struct Ranges {
  explicit Ranges(const Settings& settings) : all(core::height_ranges(settings).value()) {}

  [[nodiscard]] bool holds(Length bottom) const {
    return std::any_of(all.begin(), all.end(), [&](const core::HeightRange& range) {
      return bottom >= range.from && bottom < range.end();
    });
  }
  [[nodiscard]] bool is_near_below(Length bottom) const {
    return std::any_of(all.begin(), all.end(), [&](const core::HeightRange& range) {
      return bottom < range.from && range.from - bottom < Length::from_mm(0.6);
    });
  }
  std::vector<core::HeightRange> all;
};

void check_ranges(const LayerHeights& heights, const Ranges& ranges, Length top) {
  for (const core::HeightRange& range : ranges.all) {
    if (range.from >= top) continue;
    LayerIndex first = 0;
    while (heights.bottom(first) < range.from) ++first;
    REQUIRE_EQ(heights.bottom(first), range.from);
    for (LayerIndex k = 0; k < range.layers(); ++k) {
      REQUIRE_EQ(heights.height(first + k), range.height);
    }
    REQUIRE_EQ(heights.bottom(first + range.layers()), range.end());
  }
}

}  // namespace

TEST_CASE("the first layer, ranges, and elsewhere layer_height, exact to the unit") {
  Settings settings;
  settings.first_layer_height = Length::from_mm(0.25);
  settings.height_range = {"20-21 0.3", "10.05-12.5 0.1"};
  const LayerHeights heights = core::layer_heights(settings);
  // 9.8 mm up to the range: 49 whole layers.
  const std::vector<core::HeightBand> expected = {
      {0, Length(), Length::from_mm(0.25)},
      {1, Length::from_mm(0.25), Length::from_mm(0.2)},
      {50, Length::from_mm(10.05), Length::from_mm(0.1)},
      {75, Length::from_mm(12.55), Length::from_mm(0.2)},
      // 7.45 mm: 36 whole layers, and 0.25 mm in two.
      {111, Length::from_mm(19.75), Length::from_mm(0.125)},
      {113, Length::from_mm(20), Length::from_mm(0.3)},
      {117, Length::from_mm(21.2), Length::from_mm(0.2)}};
  CHECK(heights.bands() == expected);
  check_ranges(heights, Ranges(settings), Length::from_mm(30));
}

TEST_CASE("random ranges: all heights elsewhere are layer_height, or fit what is left below one") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  int tried = 0;
  while (tried < 200) {
    Settings settings;
    settings.layer_height = Length::from_units(1'000 + static_cast<std::int64_t>(random() % 2'000));
    std::int64_t z = 0;
    for (std::size_t k = 1 + random() % 4; k > 0; --k) {
      const std::int64_t from = z + static_cast<std::int64_t>(random() % 30'000);
      z = from + 1 + static_cast<std::int64_t>(random() % 30'000);
      const auto mm = [](std::int64_t units) {
        return std::to_string(Length::from_units(units).mm());
      };
      settings.height_range.push_back(mm(from) + "-" + mm(z) + " " +
                                      mm(100 + static_cast<std::int64_t>(random() % 3'000)));
    }
    if (!core::height_ranges(settings).ok()) continue;
    ++tried;
    const LayerHeights heights = core::layer_heights(settings);
    const Ranges ranges(settings);
    const Length top = Length::from_units(z + 50'000);
    check_ranges(heights, ranges, top);
    for (LayerIndex n = 1; heights.bottom(n) < top; ++n) {
      if (ranges.holds(heights.bottom(n)) || heights.height(n) == settings.layer_height) continue;
      REQUIRE(ranges.is_near_below(heights.bottom(n)));
      REQUIRE_LT(heights.height(n), settings.layer_height);
      REQUIRE_GE(heights.height(n) * 2, settings.layer_height - Length::from_units(1));
    }
  }
}

TEST_CASE(
    "adaptive layers: as high as every facet that they cross allows, and changing gradually") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    Settings settings = test::adaptive_settings();
    if (i % 2 == 1) {
      const std::string from = std::to_string(2'000 + random() % 1'000);
      settings.height_range = {"2." + from + "-3.4 0.1", "6-7 0.25", "7.27-7.5 0.05"};
    }
    const Length top = Length::from_mm(12);
    std::vector<Triangle> facets = random_facets(random, top.units());
    const bool flat = i % 4 >= 2;
    for (int k = 0; flat && k < 12; ++k) {
      const auto z = static_cast<std::int64_t>(random() % 120'000);
      facets.push_back({{core::Vertex{0, 0, z}, {20'000, 0, z}, {0, 20'000, z}}});
    }
    const LayerHeights heights = test::adaptive_heights_of(settings, facets, top);
    const Ranges ranges(settings);
    check_ranges(heights, ranges, top);
    const auto bounds = core::adaptive_bounds(settings);
    CHECK_EQ(heights.height(0), settings.layer_height);
    for (LayerIndex n = 1; n < heights.count(top); ++n) {
      CAPTURE(n);
      const Length bottom = heights.bottom(n), height = heights.height(n);
      if (ranges.holds(bottom)) continue;
      REQUIRE_LE(height, bounds.highest);
      if (!ranges.is_near_below(bottom)) {
        REQUIRE_EQ(height.units() % core::kHeightStep.units(), 0);
        REQUIRE_GE(height, bounds.lowest);
      }
      REQUIRE_GE(height * 2, bounds.lowest - Length::from_units(1));
      if (height > bounds.lowest) {
        for (const Triangle& facet : facets) {
          if (facet.lowest_z() >= (bottom + height).units()) continue;
          if (facet.highest_z() <= bottom.units() || facet.lowest_z() == facet.highest_z())
            continue;
          REQUIRE_LE(height.mm() * upwards(facet), settings.cusp_height.mm() + 1e-6);
        }
      }
      const Length before = heights.height(n - 1);
      if (n == 1 || flat || ranges.holds(heights.bottom(n - 1)) || ranges.is_near_below(bottom)) {
        continue;
      }
      const double step = core::kHeightStep.mm();
      REQUIRE_LE(height.mm(), before.mm() * 9 / 8 + 2 * step);
      REQUIRE_GE(height.mm(), before.mm() * 8 / 9 - 2 * step);
    }
  }
}

TEST_CASE("adaptive layers get lower towards a range of lower ones, and higher behind it") {
  Settings settings = test::adaptive_settings();
  settings.height_range = {"10-12 0.1"};
  const LayerHeights heights = test::adaptive_heights_of(settings, {}, Length::from_mm(20));
  LayerIndex first = 0;
  while (heights.bottom(first) < Length::from_mm(10)) ++first;
  CHECK_LE(heights.height(first - 1), Length::from_mm(0.13));
  CHECK_LE(heights.height(first - 4), Length::from_mm(0.18));
  CHECK_EQ(heights.height(first - 15), Length::from_mm(0.3));
  CHECK_LE(heights.height(first + 20), Length::from_mm(0.11));
  CHECK_EQ(heights.height(first + 35), Length::from_mm(0.3));
}

TEST_CASE("layers that fit what is left below a range keep under the ceiling, too") {
  for (int units = 30'000; units < 33'000; units += 7) {
    CAPTURE(units);
    Settings settings = test::adaptive_settings();
    const Length from = Length::from_units(units);
    settings.height_range = {std::to_string(from.mm()).substr(0, 6) + "-5 0.0725"};
    const core::HeightRange range = core::height_ranges(settings).value()[0];
    HeightLimits limits = *core::adaptive_limits(settings);
    limits.limit(range.from.units(), range.end().units(), range.height);
    const core::HeightCeiling ceiling(limits, 0);
    const LayerHeights heights = test::adaptive_heights_of(settings, {}, Length::from_mm(5));
    for (LayerIndex n = 1; heights.bottom(n) < from; ++n) {
      const Length bottom = heights.bottom(n), height = heights.height(n);
      REQUIRE_LE(height, ceiling.least(bottom, bottom + height));
    }
  }
}

TEST_CASE("no adaptive layer could be a step higher") {
  std::mt19937 random(3);
  const Settings settings = test::adaptive_settings();
  const Length top = Length::from_mm(12);
  for (int i = 0; i < 50; ++i) {
    HeightLimits limits = *core::adaptive_limits(settings);
    for (const Triangle& facet : random_facets(random, top.units())) limits.add(facet);
    const core::HeightCeiling ceiling(limits, 0);
    const LayerHeights heights = core::adaptive_heights(settings, limits, 0, top);
    for (LayerIndex n = 1; n < heights.count(top); ++n) {
      const Length bottom = heights.bottom(n), higher = heights.height(n) + core::kHeightStep;
      REQUIRE(
          (higher > limits.bounds().highest || ceiling.least(bottom, bottom + higher) < higher));
    }
  }
}

TEST_CASE("more flat faces than there are bands") {
  const Settings settings = test::adaptive_settings();
  HeightLimits limits = *core::adaptive_limits(settings);
  for (std::int64_t z = 5'000; z < 20'000'000; z += 2'500) {
    limits.add({{core::Vertex{0, 0, z}, {20'000, 0, z}, {0, 20'000, z}}});
  }
  const LayerHeights heights =
      core::adaptive_heights(settings, limits, 0, Length::from_units(20'000'000));
  CHECK_LE(heights.bands().size(), core::kHeightBandsMax);
  CHECK_LT(heights.count(Length::from_units(20'000'000)), 2'000 / 0.2);
}

TEST_CASE("a part of a million layers takes no more memory than one of a thousand") {
  const Settings settings = test::adaptive_settings();
  std::mt19937 random(9);
  for (const double mm : {100.0, 1e3, 1e5, 1e9}) {
    CAPTURE(mm);
    const Length top = Length::from_mm(mm);
    HeightLimits limits = *core::adaptive_limits(settings);
    for (int i = 0; i < 20'000; ++i) {
      const auto low = static_cast<std::int64_t>(static_cast<double>(random()) / 4294967296.0 *
                                                 static_cast<double>(top.units() - 20'000));
      limits.limit(low, low + 1'500,
                   Length::from_units(500 + static_cast<std::int64_t>(random() % 2'500)));
    }
    const LayerHeights heights = core::adaptive_heights(settings, limits, 0, top);
    CHECK_LE(heights.bands().size(), core::kHeightBandsMax);
    CHECK_GT(heights.bands().size(), 10);
    const LayerIndex count = heights.count(top);
    CHECK_GT(static_cast<double>(count), mm / 0.31);
    CHECK_LT(static_cast<double>(count), mm / 0.069);
    CHECK_LT((heights.bottom(count - 1) + heights.height(count - 1) - top).mm(), 0.3);
  }
}

TEST_CASE("more changes than there are bands: slopes count for more height, no limit is broken") {
  Settings settings = test::adaptive_settings();
  settings.layer_height_min = Length::from_mm(0.05);
  HeightLimits limits = *core::adaptive_limits(settings);
  // Up and down all the way, within the first bins' reach.
  const Length top = Length::from_mm(830);
  for (std::int64_t z = 0; z < top.units(); z += 512) {
    const std::int64_t up = z / 512 % 40;
    limits.limit(z, z + 512, Length::from_units(500 + 60 * std::min(up, 40 - up)));
  }
  const LayerHeights heights = core::adaptive_heights(settings, limits, 0, top);
  CHECK_LE(heights.bands().size(), core::kHeightBandsMax);
  const core::HeightCeiling ceiling(limits, 0);
  for (LayerIndex n = 1; n < heights.count(top); ++n) {
    const Length bottom = heights.bottom(n), height = heights.height(n);
    REQUIRE_LE(height, ceiling.least(bottom, bottom + height));
  }
}

TEST_CASE("a range that reaches far above the part limits no more than one that ends at its top") {
  std::mt19937 random(7);
  const Length top = Length::from_mm(40);
  const std::vector<Triangle> facets = random_facets(random, top.units());
  Settings near = test::adaptive_settings(), far = near;
  near.height_range = {"20-40 0.2"};
  far.height_range = {"20-1000000 0.2"};
  const LayerHeights as_near = test::adaptive_heights_of(near, facets, top);
  const LayerHeights as_far = test::adaptive_heights_of(far, facets, top);
  for (LayerIndex layer = 0; as_near.bottom(layer) < Length::from_mm(20); ++layer) {
    CAPTURE(layer);
    REQUIRE_EQ(as_far.height(layer), as_near.height(layer));
  }
}
