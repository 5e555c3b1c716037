#include "core/roads/narrow_diagram.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/regions/contact_check.h"
#include "core/roads/cell_borders.h"
#include "core/trigonometry.h"
#include "tests/support/grid_regions.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Point;
using core::Region;
using core::Ring;
using core::VoronoiDiagram;
using core::VoronoiEdge;
using core::VoronoiVertex;
using test::Random;

namespace {

// Length of the primary edges inside the region whose ends are both lower than the limit.
double length_below(const VoronoiDiagram& diagram, double height_max) {
  double sum = 0;
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    const std::uint32_t to = diagram.to(i);
    if (!edge.primary || edge.twin < i) continue;
    if (edge.from == VoronoiEdge::kInfinity || to == VoronoiEdge::kInfinity) continue;
    const VoronoiVertex &a = diagram.vertices[edge.from], &b = diagram.vertices[to];
    if (std::min(a.height, b.height) < -0.5 || std::max(a.height, b.height) <= 0.5) continue;
    if (std::max(a.height, b.height) < height_max) sum += std::hypot(a.x - b.x, a.y - b.y);
  }
  return sum;
}

// What has to hold of any answer: heights as measured, sites as near as the vertices are high, and
// as much of it as Boost's diagram has.
void check_diagram(const Region& region, const VoronoiDiagram& narrow, double clearance_max) {
  double worst = 0;
  for (const VoronoiEdge& edge : narrow.edges) {
    const VoronoiVertex& from = narrow.vertices[edge.from];
    const double measured = test::signed_distance(region, from.x, from.y);
    worst = std::max(worst, std::abs(measured - from.height));
    const double away = core::distance_to(narrow.sites[edge.site], from.x, from.y);
    worst = std::max(worst, std::abs(away - from.height));
  }
  CHECK_LE(worst, 10);  // units
  const auto whole = core::make_voronoi_diagram(region.rings(), 0);
  REQUIRE(whole.has_value());
  const double theirs = length_below(*whole, clearance_max * 0.99);
  const double ours = length_below(narrow, clearance_max * 0.99);
  CHECK_LE(std::abs(theirs - ours), 1e-3 * theirs + 100);
}

}  // namespace

TEST_CASE("a strip's diagram is its middle and the ways into its corners") {
  const Region strip = test::region_from_text("0:0 10:0 10:0.3 0:0.3");
  const auto diagram = core::make_narrow_diagram(strip.rings(), 4'000);
  REQUIRE(diagram.has_value());
  CHECK_EQ(diagram->edges.size(), 2 * 5u);
  CHECK_EQ(diagram->vertices.size(), 6u);
}

TEST_CASE("where the region is wider, edges end at that clearance") {
  const Region square = test::region_from_text("0:0 10:0 10:10 0:10");
  const auto diagram = core::make_narrow_diagram(square.rings(), 5'000);
  REQUIRE(diagram.has_value());
  CHECK_EQ(diagram->edges.size(), 2 * 4u);
  for (const VoronoiVertex& vertex : diagram->vertices) {
    CHECK((vertex.height == 0 || vertex.height == doctest::Approx(5'000)));
  }
}

TEST_CASE("contours that touch are left to the whole diagram") {
  const Region touching = test::region_from_text("0:0 2:0 1:1, 1:1 2:2 0:2");
  CHECK_FALSE(core::make_narrow_diagram(touching.rings(), 5'000).has_value());
}

TEST_CASE("very many sites near one another are left to the whole diagram") {
  // A ring, the width of which is as long as some hundred edges.
  const auto ring_of = [](int corners) {
    Ring outer, inner;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const auto place = [&](double turn, double radius) {
        return Point{static_cast<std::int32_t>(std::lround(radius * core::cosine(turn))),
                     static_cast<std::int32_t>(std::lround(radius * core::sine(turn)))};
      };
      const double wave = 60 * core::cosine(7 * angle);
      outer.push_back(place(angle, 200'000 + wave));
      inner.push_back(place(-angle, 187'000 + wave));
    }
    return std::vector<Ring>{outer, inner};
  };
  CHECK(core::make_narrow_diagram(ring_of(600), 12'000).has_value());
  const std::vector<Ring> crowded = ring_of(12'000);
  REQUIRE(core::surely_clean(crowded));
  CHECK_FALSE(core::find_cell_borders(crowded, 12'000).has_value());
  CHECK_FALSE(core::make_narrow_diagram(crowded, 12'000).has_value());
}

TEST_CASE("random regions: the same diagram as Boost's, with and without coincidences") {
  constexpr std::uint64_t kSeed = 20261126;
  CAPTURE(kSeed);
  Random random(kSeed);
  int asked = 0, answered = 0;
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    const Region region = i % 2 == 0 ? test::random_region(random, 20 + i / 4, 6)
                                     : test::random_grid_region(random, 1'000);
    if (region.empty() || !core::surely_clean(region.rings())) continue;
    const double clearance_max = random.between(300, 6'000);
    ++asked;
    const auto diagram = core::make_narrow_diagram(region.rings(), clearance_max);
    if (!diagram) continue;
    ++answered;
    check_diagram(region, *diagram, clearance_max);
  }
  MESSAGE(answered << " of " << asked << " answered");
  CHECK_GE(answered, asked * 95 / 100);
}

TEST_CASE("both sides of the borders see the same") {
  constexpr std::uint64_t kSeed = 20261129;
  CAPTURE(kSeed);
  Random random(kSeed);
  const auto length = [](const core::CellBorders& found) {
    double sum = 0;
    for (const core::CellBorder& border : found.borders) {
      CHECK_LT(border.site, border.other);
      sum += std::hypot(border.to.x - border.from.x, border.to.y - border.from.y);
    }
    return sum;
  };
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const Region region = test::random_region(random, 20 + i, 6);
    if (region.empty() || !core::surely_clean(region.rings())) continue;
    const double clearance_max = random.between(300, 6'000);
    const auto lower = core::find_cell_borders(region.rings(), clearance_max);
    const auto higher =
        core::find_cell_borders(region.rings(), clearance_max, core::BorderSide::kHigher);
    REQUIRE(lower.has_value());
    REQUIRE(higher.has_value());
    CHECK_LE(std::abs(length(*lower) - length(*higher)), 1e-3 * length(*lower) + 100);
  }
}
