#include "core/slices/height_limits.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/limits.h"

using core::HeightLimits;
using core::Length;
using core::Triangle;
using core::Vertex;

namespace {

const Length kCusp = Length::from_mm(0.05);
constexpr core::HeightBounds kBounds{Length::from_units(700), Length::from_units(3'000)};

HeightLimits limits_of(const std::vector<Triangle>& facets) {
  HeightLimits limits(kCusp, kBounds);
  for (const Triangle& facet : facets) limits.add(facet);
  return limits;
}

// By the words of the law, from the facet's plane.
double allowed_units(const Triangle& t) {
  const auto& [a, b, c] = t.corners;
  using Real = long double;
  const Real ux = b.x - a.x, uy = b.y - a.y, uz = static_cast<Real>(b.z - a.z);
  const Real vx = c.x - a.x, vy = c.y - a.y, vz = static_cast<Real>(c.z - a.z);
  const Real nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
  const Real up = std::abs(nz) / std::sqrt(nx * nx + ny * ny + nz * nz);
  return up == 0 ? 1e9 : static_cast<double>(static_cast<Real>(kCusp.units()) / up);
}

std::vector<Triangle> random_facets(std::mt19937& random, int count, std::int64_t high) {
  std::vector<Triangle> facets;
  const auto corner = [&](std::int64_t low) {
    return Vertex{static_cast<std::int32_t>(random() % 20'000),
                  static_cast<std::int32_t>(random() % 20'000),
                  low + static_cast<std::int64_t>(random() % 30'000)};
  };
  for (int i = 0; i < count; ++i) {
    const std::int64_t low = static_cast<std::int64_t>(random()) % high - high / 2;
    facets.push_back({{corner(low), corner(low), corner(low)}});
  }
  return facets;
}

bool same(const HeightLimits& a, const HeightLimits& b) {
  if (a.first() != b.first() || a.last() != b.last() || a.bin_width() != b.bin_width()) {
    return false;
  }
  for (std::int64_t bin = a.first(); bin <= a.last(); ++bin) {
    if (a.at_bin(bin) != b.at_bin(bin)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a bin has the least height that a facet in it allows, in any order of facets") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const std::int64_t high : {std::int64_t{1'000'000}, std::int64_t{3'000'000'000}}) {
    std::vector<Triangle> facets = random_facets(random, 300, high);
    const HeightLimits limits = limits_of(facets);
    REQUIRE_LE(limits.last() - limits.first() + 1, std::int64_t{core::kHeightBinsMax});
    CHECK_EQ(limits.bin_width() > 512, high > 8'388'608);
    for (std::int64_t bin = limits.first(); bin <= limits.last(); ++bin) {
      const std::int64_t low = bin * limits.bin_width(), top = low + limits.bin_width();
      double least = 3'000;
      for (const Triangle& facet : facets) {
        if (facet.lowest_z() >= top || facet.highest_z() <= low) continue;
        least = std::min(least, allowed_units(facet));
      }
      REQUIRE(std::abs(static_cast<double>(limits.at_bin(bin).units()) -
                       std::max(std::floor(least), 700.0)) <= 1);
    }
    std::shuffle(facets.begin(), facets.end(), random);
    CHECK(same(limits, limits_of(facets)));
  }
}

TEST_CASE("upright facets and flat ones limit nothing") {
  const HeightLimits limits = limits_of({{{Vertex{0, 0, 0}, {9'000, 0, 0}, {0, 0, 50'000}}},
                                         {{Vertex{0, 0, 700}, {9'000, 0, 700}, {0, 900, 700}}},
                                         {{Vertex{0, 0, 700}, {9'000, 0, 705}, {0, 900, 700}}}});
  CHECK_LT(limits.last(), limits.first());
  // What ends where a bin begins is not in it.
  const HeightLimits ends = limits_of({{{Vertex{0, 0, 512}, {9'000, 0, 1'024}, {0, 900, 512}}}});
  CHECK_EQ(ends.first(), 1);
  CHECK_EQ(ends.last(), 1);
  // As flat as can be, but not flat: the lowest layers.
  const HeightLimits sloped = limits_of({{{Vertex{0, 0, 700}, {9'000, 0, 800}, {0, 9'000, 700}}}});
  CHECK_EQ(sloped.first(), 1);
  CHECK_EQ(sloped.last(), 1);
  CHECK_EQ(sloped.at_bin(1), Length::from_units(700));
}

TEST_CASE("wider bins have the lesser limit of two") {
  std::mt19937 random(5);
  const HeightLimits limits = limits_of(random_facets(random, 100, 1'000'000));
  HeightLimits wider = limits;
  wider.widen();
  CHECK_EQ(wider.bin_width(), 2 * limits.bin_width());
  for (std::int64_t bin = wider.first(); bin <= wider.last(); ++bin) {
    Length least = kBounds.highest;
    for (std::int64_t half = 2 * bin; half <= 2 * bin + 1; ++half) {
      if (half < limits.first() || half > limits.last()) continue;
      least = std::min(least, limits.at_bin(half));
    }
    REQUIRE_EQ(wider.at_bin(bin), least);
  }
}

TEST_CASE("bounds are whole steps within the settings") {
  core::Settings settings;
  CHECK_FALSE(core::adaptive_limits(settings).has_value());
  settings.adaptive_layer_height = true;
  settings.layer_height_min = Length::from_mm(0.071);
  CHECK_EQ(core::adaptive_limits(settings)->bounds().lowest, Length::from_mm(0.08));
  CHECK_EQ(core::adaptive_bounds(settings).highest, Length::from_mm(0.3));
  settings.nozzle_diameter = Length::from_mm(0.25);
  CHECK_EQ(core::adaptive_bounds(settings).highest, Length::from_mm(0.18));
  settings.layer_height_max = Length::from_mm(0.219);
  CHECK_EQ(core::adaptive_bounds(settings).highest, Length::from_mm(0.21));
}
