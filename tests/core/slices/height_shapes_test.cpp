// Adaptive layers of shapes whose slopes are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "core/slices/height_plan.h"
#include "tests/support/adaptive_heights.h"
#include "tests/support/mesh.h"
#include "tools/parts/part_maker.h"

using core::LayerHeights;
using core::LayerIndex;
using core::Length;
using core::Settings;
using core::Triangle;

namespace {

// A body of revolution about an axis far enough inside the first quadrant: rings of facets between
// the points of its outline.
std::vector<Triangle> turned(const std::vector<std::pair<double, double>>& outline) {
  constexpr int kSides = 48;
  std::vector<Triangle> facets;
  const auto corner = [](const std::pair<double, double>& at, int side) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return core::Vertex{static_cast<std::int32_t>(std::lround(at.first * std::cos(angle) * 1e4)),
                        static_cast<std::int32_t>(std::lround(at.first * std::sin(angle) * 1e4)),
                        std::llround(at.second * 1e4)};
  };
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    for (int side = 0; side < kSides; ++side) {
      const core::Vertex a = corner(outline[i], side), b = corner(outline[i], side + 1);
      const core::Vertex c = corner(outline[i + 1], side + 1), d = corner(outline[i + 1], side);
      facets.push_back({{a, b, c}});
      facets.push_back({{a, c, d}});
    }
  }
  return facets;
}

// The facets' slopes are those of the outline, divided by this.
const double kInradius = std::cos(std::numbers::pi / 48);

}  // namespace

TEST_CASE("a cone's layers are as high as its slope allows, an upright wall's the highest") {
  const Settings settings = test::adaptive_settings();
  for (const double run : {0.18, 0.3, 0.5, 0.65}) {
    CAPTURE(run);
    const auto facets = turned({{40, 0}, {40 - run * 30, 30}});
    const LayerHeights heights = test::adaptive_heights_of(settings, facets, Length::from_mm(30));
    // The flats of the cone's facets are a little less steep than its edges.
    const double slope = run * kInradius;
    const double most = settings.cusp_height.mm() * std::sqrt(1 + slope * slope) / slope;
    const double steps = std::floor(std::min(most, 0.3) * 100 + 1e-3);
    REQUIRE_EQ(heights.bands().size(), 2);
    CHECK_EQ(heights.bands()[1].height, core::kHeightStep * static_cast<std::int64_t>(steps));
  }
  const auto wedge = test::triangles_of(parts::box({0, 0, 0}, 9, 8, 30));
  const LayerHeights heights = test::adaptive_heights_of(settings, wedge, Length::from_mm(30));
  CHECK_EQ(heights.bands()[1].height, Length::from_mm(0.3));
  // As few as there can be, and the last one ends at its top.
  CHECK_EQ(heights.count(Length::from_mm(30)), 1 + 100);
  CHECK_EQ(heights.bottom(101), Length::from_mm(30));
}

TEST_CASE("a sphere's layers keep the cusp, and waste less than two steps") {
  const Settings settings = test::adaptive_settings();
  constexpr double kRadius = 20;
  constexpr int kRings = 2'000;
  std::vector<std::pair<double, double>> outline;
  for (int i = 1; i < kRings; ++i) {
    const double angle = std::numbers::pi * i / kRings;
    outline.emplace_back(kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)));
  }
  const Length top = Length::from_mm(2 * kRadius);
  const LayerHeights heights = test::adaptive_heights_of(settings, turned(outline), top);
  const double cusp = settings.cusp_height.mm();
  for (LayerIndex n = 1; n < heights.count(top); ++n) {
    const double bottom = heights.bottom(n).mm(), height = heights.height(n).mm();
    CAPTURE(bottom);
    CAPTURE(height);
    // |n_z| is the distance from the equator's height, in radii: greatest at one of the ends.
    const double most = std::max(std::abs(bottom - kRadius), std::abs(bottom + height - kRadius));
    const double ring = std::numbers::pi * kRadius / kRings + 0.0512;
    if (height > 0.07) REQUIRE_LE(height * (most - ring) / kRadius * kInradius, cusp);
    const double bound = std::min(0.3, cusp * kRadius / (most + 0.02 + ring));
    REQUIRE_GE(height, std::max(0.07, bound - 0.02) - 1e-9);
  }
}

TEST_CASE("a layer ends at every flat face that layers of these heights can end at") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Settings settings = test::adaptive_settings();
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const bool steps = i % 2 == 0;
    std::vector<Length> flats;
    std::vector<Triangle> facets;
    Length z = Length::from_mm(0.2);
    for (int k = 0; k < 9; ++k) {
      // Four layers of 0.07 to 0.3 mm reach anything from here on.
      z += Length::from_units(2'700 + static_cast<std::int64_t>(random() % 60'000));
      if (steps) z = Length::from_units(z.units() / 100 * 100);
      flats.push_back(z);
      facets.push_back(
          {{core::Vertex{0, 0, z.units()}, {20'000, 0, z.units()}, {0, 20'000, z.units()}}});
    }
    const LayerHeights heights = test::adaptive_heights_of(settings, facets, z);
    const LayerIndex count = heights.count(z);
    CHECK_LE((heights.bottom(count) - z).mm(), 0.0051);
    for (const Length flat : flats) {
      LayerIndex above = 0;
      while (heights.bottom(above) < flat - Length::from_units(50)) ++above;
      REQUIRE_LE(std::abs((heights.bottom(above) - flat).units()), steps ? 0 : 50);
    }
    for (LayerIndex n = 1; n < count; ++n) {
      REQUIRE_EQ(heights.height(n).units() % core::kHeightStep.units(), 0);
      REQUIRE_GE(heights.height(n), Length::from_mm(0.07));
      REQUIRE_LE(heights.height(n), Length::from_mm(0.3));
    }
    // As many as without the faces, and at most one more for each.
    const LayerIndex free = test::adaptive_heights_of(settings, {}, z).count(z);
    CHECK_GE(count, free - 1);
    CHECK_LE(count, free + static_cast<LayerIndex>(flats.size()) + 1);
  }
}
