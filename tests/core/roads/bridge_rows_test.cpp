#include "core/roads/bridge_rows.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/roads/bridge_direction.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr double kMm = kUnitsPerMm;

// Two posts with `span` mm between them, a deck of 10 mm that reaches 1 mm onto each.
BridgeArea deck(double span) {
  const Region room = test::rectangle_region(0, 0, span + 8, 10);
  const Region held =
      unite(test::rectangle_region(0, 0, 4, 10), test::rectangle_region(span + 4, 0, 4, 10));
  return {test::rectangle_region(3, 0, span + 2, 10), room, held, {}, Length::from_mm(0.45)};
}

}  // namespace

TEST_CASE("rows share the breadth evenly, and are cut where the region's edge is") {
  const Region region = test::rectangle_region(1, 2, 7, 3);
  const RowGrid grid = even_rows_over(region, {1, 0}, 0.4 * kMm);
  REQUIRE_EQ(grid.count, 8);
  CHECK_EQ(grid.distance, doctest::Approx(3 * kMm / 8));
  CHECK_EQ(grid.across(0), doctest::Approx(2 * kMm + grid.distance / 2));
  const RowCuts cuts(grid, region);
  for (std::size_t i = 0; i < grid.count; ++i) {
    const std::span<const RowSpan> row = cuts[i];
    REQUIRE_EQ(row.size(), 1);
    CHECK_EQ(row.front().from, doctest::Approx(1 * kMm));
    CHECK_EQ(row.front().to, doctest::Approx(8 * kMm));
  }
  CHECK_EQ(even_rows_over({}, {1, 0}, 1).count, 0);
}

TEST_CASE("spans of random regions are where a second computation finds the inside") {
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 200, 20);
    const double angle = random.between(0, std::numbers::pi);
    const RowGrid grid = even_rows_over(region, {std::cos(angle), std::sin(angle)}, 0.5 * kMm);
    const RowCuts rows(grid, region);
    for (int i = 0; i < 2'000; ++i) {
      const auto row =
          static_cast<std::size_t>(random.integer(0, static_cast<int>(grid.count) - 1));
      const double along = random.between(-30, 30) * kMm;
      const Vector p = grid.direction * along + left_of(grid.direction) * grid.across(row);
      if (std::abs(test::distance_to_boundary(region.rings(), p.x, p.y)) < 2) continue;
      bool in_span = false;
      for (const RowSpan& span : rows[row]) in_span |= span.from < along && along < span.to;
      CHECK_EQ(in_span, test::winding_number(region.rings(), p.x, p.y) == 1);
    }
  }
}

TEST_CASE("rows across a gap are held an anchor deep at both ends, and joined over what holds") {
  const BridgeArea area = deck(10);
  const BridgeRows rows = bridge_rows(area, {1, 0}, Length::from_mm(0.4));
  CHECK_EQ(rows.rows.size(), 25);
  CHECK(rows.cut.empty());
  CHECK_EQ(rows.longest_mm, doctest::Approx(10));
  CHECK_EQ(rows.longest_at.x, 9 * 10'000);
  CHECK_EQ(rows.laid_spans_mm, doctest::Approx(250));
  for (const BridgeRow& row : rows.rows) {
    CHECK_LE(row.way.from, (4 - 0.45) * kMm);
    CHECK_GE(row.way.to, (14 + 0.45) * kMm);
  }
  CHECK_EQ(joined(rows, area).size(), 1);
}

TEST_CASE("an end that the area cuts short is carried on as far as the room goes") {
  BridgeArea area = deck(10);
  area.region = test::rectangle_region(4, 0, 10, 10);  // ends where what holds begins
  const BridgeRows rows = bridge_rows(area, {1, 0}, Length::from_mm(0.4));
  REQUIRE_EQ(rows.rows.size(), 25);
  CHECK_EQ(rows.rows.front().way.from, doctest::Approx((4 - 0.45) * kMm));
  CHECK_EQ(rows.rows.front().way.to, doctest::Approx((14 + 0.45) * kMm));
  area.room = test::rectangle_region(3.8, 0, 10.4, 10);
  const BridgeRows short_rows = bridge_rows(area, {1, 0}, Length::from_mm(0.4));
  CHECK_EQ(short_rows.rows.front().way.from, doctest::Approx(3.8 * kMm));
}

TEST_CASE("what is held on one side only is cut off") {
  BridgeArea area = deck(10);
  area.held = test::rectangle_region(0, 0, 4, 10);
  const BridgeRows rows = bridge_rows(area, {1, 0}, Length::from_mm(0.4));
  CHECK(rows.rows.empty());
  CHECK_EQ(rows.cut_spans_mm, doctest::Approx(25 * 11));
  CHECK(covered_by(rows, area).empty());
  // A rib thinner than the anchor is no side.
  area.held = unite(area.held, test::rectangle_region(14, 0, 0.3, 10));
  CHECK(bridge_rows(area, {1, 0}, Length::from_mm(0.4)).rows.empty());
  // A hole in the bridge is one: its perimeter comes after the rows.
  area.held = test::rectangle_region(0, 0, 4, 10);
  area.holes = test::rectangle_region(14, 0, 4, 10);
  CHECK_EQ(bridge_rows(area, {1, 0}, Length::from_mm(0.4)).rows.size(), 25);
}

TEST_CASE("the direction is that of the shortest spans held on both sides") {
  const DirectionTrials trials{6, 8};
  for (const double span : {2.0, 10.0, 40.0}) {
    const Vector along = best_direction(deck(span), Length::from_mm(0.4), trials);
    CHECK_EQ(std::abs(along.x), doctest::Approx(1));
  }
  // A shelf between two long walls, 6 mm apart and 30 mm long: across it.
  const Region held =
      unite(test::rectangle_region(0, -2, 30, 2), test::rectangle_region(0, 6, 30, 2));
  const BridgeArea shelf{test::rectangle_region(0, -1, 30, 8),
                         test::rectangle_region(0, -2, 30, 10),
                         held,
                         {},
                         Length::from_mm(0.45)};
  CHECK_EQ(std::abs(best_direction(shelf, Length::from_mm(0.4), trials).y), doctest::Approx(1));
}
