#include "core/offsets/voronoi_diagram.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "core/limits.h"
#include "core/offsets/voronoi_check.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Region;
using core::Ring;
using core::VoronoiDiagram;

namespace {

// boostorg/polygon#43: Boost's diagram of it lacks what it should have.
const std::vector<Ring> kBroken{{{0, 10'000'000},
                                 {700'000, 1},
                                 {700'000, 9'000'000},
                                 {9'100'000, 9'000'000},
                                 {9'100'000, 0},
                                 {10'000'000, 10'000'000}}};

}  // namespace

TEST_CASE("every vertex is as high as it is far from the contours") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 100, 20);
    for (int turn = 0; turn <= core::kDiagramTurnsMax; ++turn) {
      CAPTURE(turn);
      const auto diagram = core::make_voronoi_diagram(region.rings(), turn);
      REQUIRE(diagram);
      CHECK_EQ(diagram->turns, turn);
      int wrong = 0;
      for (const core::VoronoiVertex& vertex : diagram->vertices) {
        if (std::abs(vertex.x) > 1e7 || std::abs(vertex.y) > 1e7) continue;
        const double distance = test::signed_distance(region, vertex.x, vertex.y);
        const double error = std::abs(distance) < 1 ? std::abs(distance) - std::abs(vertex.height)
                                                    : distance - vertex.height;
        if (std::abs(error) > 0.1) ++wrong;
      }
      CHECK_EQ(wrong, 0);
    }
  }
}

TEST_CASE("Boost's known failure is noticed, and gone when turned") {
  const auto diagram = core::make_voronoi_diagram(kBroken, 0);
  REQUIRE(diagram);
  CHECK_GE(diagram->turns, 1);
}

TEST_CASE("a diagram that was tampered with does not pass") {
  const Region region = test::region_from_text("0:0 10:0 10:10 5:10 5:5 0:6, 1:1 1:3 3:2");
  const VoronoiDiagram good = core::make_voronoi_diagram(region.rings(), 0).value();
  VoronoiDiagram again = good;
  CHECK(core::measure_and_check(region.rings(), again));

  const auto passes = [&](const std::function<void(VoronoiDiagram&)>& tamper) {
    VoronoiDiagram bad = good;
    tamper(bad);
    return core::measure_and_check(region.rings(), bad);
  };
  for (std::uint32_t i = 0; i < good.edges.size(); ++i) {
    CAPTURE(i);
    CHECK_FALSE(
        passes([i](VoronoiDiagram& d) { d.edges[i].next = d.edges[d.edges[i].next].next; }));
    CHECK_FALSE(passes([i](VoronoiDiagram& d) { d.edges[i].twin = i; }));
    CHECK_FALSE(passes([i](VoronoiDiagram& d) {
      d.edges[i].site = (d.edges[i].site + 1) % static_cast<std::uint32_t>(d.sites.size());
    }));
  }
  for (std::size_t i = 0; i < good.vertices.size(); ++i) {
    CAPTURE(i);
    CHECK_FALSE(
        passes([i](VoronoiDiagram& d) { d.vertices[i].x += 50 + std::abs(d.vertices[i].x); }));
    CHECK_FALSE(passes([i](VoronoiDiagram& d) { d.vertices[i].y = NAN; }));
  }
  CHECK_FALSE(passes([](VoronoiDiagram& d) { d.sites.back() = d.sites.front(); }));
  // A ring that the diagram knows nothing of.
  VoronoiDiagram bad = good;
  std::vector<Ring> more = region.rings();
  more.push_back(test::rectangle(7, 7, 8, 8));
  CHECK_FALSE(core::measure_and_check(more, bad));
}
