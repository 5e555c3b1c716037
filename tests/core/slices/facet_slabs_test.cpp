// Facets between planes, held against what slices gain, and against single points of facets.
#include "core/slices/facet_slabs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using namespace core;

namespace {

LayerHeights heights() { return {Length::from_mm(0.3), Length::from_mm(0.2)}; }

std::vector<Region> slabs_of(std::vector<Triangle> facets, const LayerHeights& layers, int count) {
  std::sort(facets.begin(), facets.end(),
            [](const Triangle& a, const Triangle& b) { return a.lowest_z() < b.lowest_z(); });
  std::size_t next = 0;
  FacetSlabs slabs(layers, [&]() -> Result<std::optional<Triangle>> {
    if (next == facets.size()) return std::optional<Triangle>();
    return std::optional<Triangle>(facets[next++]);
  });
  std::vector<Region> found;
  for (int i = 0; i < count; ++i) found.push_back(slabs.next().value());
  return found;
}

bool looks_down(const Triangle& t) {
  const auto& [a, b, c] = t.corners;
  return cross({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) < 0;
}

}  // namespace

TEST_CASE("what looks down of a part between two planes is what its slice gains") {
  for (const parts::Part& part : {parts::sphere(6), parts::arch(9), parts::tee()}) {
    std::vector<Triangle> triangles = test::triangles_of(part), down;
    for (const Triangle& triangle : triangles) {
      if (looks_down(triangle)) down.push_back(triangle);
    }
    const PlaneSweep::Options options = test::exact_options();
    const std::vector<Slice> slices = test::sweep(triangles, options).slices;
    REQUIRE_GT(slices.size(), 40);
    const std::vector<Region> slabs =
        slabs_of(down, options.heights, static_cast<int>(slices.size()));
    CHECK(slabs[0].empty());
    int gains = 0;
    for (std::size_t n = 1; n < slices.size(); ++n) {
      CAPTURE(n);
      const Region gained = subtract(slices[n].region, slices[n - 1].region);
      // What a body hides of another, and what goes back below the plane, is in the slab, too.
      const Region seen = subtract(intersect(slabs[n], slices[n].region), slices[n - 1].region);
      CHECK_LT(test::widest_difference(seen, gained), 3);
      gains += gained.area_mm2() > 0.01 ? 1 : 0;
    }
    CHECK_GT(gains, 0);
  }
}

TEST_CASE("points of random facets are in the slab of their height, and in no other") {
  constexpr int kLayers = 24;
  const LayerHeights layers = heights();
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Triangle> facets;
    for (int i = 0; i < 40; ++i) {
      Triangle facet;
      const double x = random.between(0, 20), y = random.between(0, 20), z = random.between(-1, 5);
      for (Vertex& corner : facet.corners) {
        corner = {static_cast<std::int32_t>((x + random.between(-4, 4)) * 1e4),
                  static_cast<std::int32_t>((y + random.between(-4, 4)) * 1e4),
                  static_cast<std::int64_t>((i % 5 == 0 ? z : z + random.between(-1, 1)) * 1e4)};
      }
      // Some flat, some of them right in a plane.
      if (i % 10 == 0) {
        for (Vertex& corner : facet.corners) corner.z = layers.doubled_plane(i / 10 + 3) / 2;
      }
      facets.push_back(facet);
    }
    const std::vector<Region> slabs = slabs_of(facets, layers, kLayers);
    // Each facet at many points of its own: there it is in one slab.
    for (const Triangle& facet : facets) {
      const Vertex &a = facet.corners[0], &b = facet.corners[1], &c = facet.corners[2];
      for (int i = 0; i < 30; ++i) {
        const double p = random.unit(), q = random.unit();
        const double s = std::min(p, q), t = std::max(p, q) - s, u = 1 - s - t;
        if (std::min({s, t, u}) < 0.02) continue;
        const auto mixed = [&](auto Vertex::*at) {
          return s * static_cast<double>(a.*at) + t * static_cast<double>(b.*at) +
                 u * static_cast<double>(c.*at);
        };
        const double z2 = 2 * mixed(&Vertex::z);
        const Point at{static_cast<std::int32_t>(std::lround(mixed(&Vertex::x))),
                       static_cast<std::int32_t>(std::lround(mixed(&Vertex::y)))};
        const std::int64_t flat = a.z == b.z && b.z == c.z ? 2 * a.z : INT64_MAX;
        for (int n = 1; n < kLayers; ++n) {
          const auto low = static_cast<double>(layers.doubled_plane(n - 1));
          const auto high = static_cast<double>(layers.doubled_plane(n));
          const bool sure = flat != INT64_MAX || (z2 > low + 40 && z2 < high - 40);
          const double height = flat != INT64_MAX ? static_cast<double>(flat) : z2;
          if (!sure || height < low || height >= high) continue;
          CHECK(slabs[static_cast<std::size_t>(n)].contains(at));
        }
      }
    }
    // And nothing else is in it: by area, piece by piece.
    double sum = 0, whole = 0;
    for (int n = 1; n < kLayers; ++n) sum += slabs[static_cast<std::size_t>(n)].area_mm2();
    for (const Triangle& facet : facets) {
      const std::vector<Region> alone = slabs_of({facet}, layers, kLayers);
      for (int n = 1; n < kLayers; ++n) whole += alone[static_cast<std::size_t>(n)].area_mm2();
      const Vertex &a = facet.corners[0], &b = facet.corners[1], &c = facet.corners[2];
      const double area = std::abs(static_cast<double>(cross({a.x, a.y}, {b.x, b.y}, {c.x, c.y})));
      double own = 0;
      for (const Region& slab : alone) own += slab.area_mm2();
      CHECK_LE(own, area / 2e8 + 1e-3);
      const bool inside = facet.lowest_z() * 2 >= layers.doubled_plane(0) &&
                          facet.highest_z() * 2 < layers.doubled_plane(kLayers - 1);
      if (inside) CHECK_EQ(own, doctest::Approx(area / 2e8).epsilon(1e-3));
    }
    CHECK_LE(sum, whole + 1e-6);
  }
}
