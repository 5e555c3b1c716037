#include "core/roads/row_rests.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/roads/line_fill.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

// The rests as a boolean finds them: the region without a rectangle for each row.
Region by_boolean(const Region& region, const std::vector<RowStretch>& stretches,
                  const RowStrips& grid) {
  std::vector<Ring> covered;
  for (const RowStretch& stretch : stretches) {
    const double bottom = static_cast<double>(stretch.row) * grid.distance;
    const double from = stretch.from - grid.reach, to = stretch.to + grid.reach;
    covered.push_back({grid.turn.to_plane(from, bottom), grid.turn.to_plane(to, bottom),
                       grid.turn.to_plane(to, bottom + grid.distance),
                       grid.turn.to_plane(from, bottom + grid.distance)});
  }
  return subtract(region, clean(covered, FillRule::kNonZero));
}

}  // namespace

TEST_CASE("random regions: the rests are what a boolean with every row's rectangle leaves") {
  double rests_mm2 = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 60, 30);
    if (region.empty()) continue;
    const double distance_mm = random.between(0.4, 1.5), angle = random.between(0, 180);
    const LineFill fill(angle);
    FilledRows rows =
        fill.fill({region, 0, RoadKind::kSolid, Length::from_mm(0.45), Length::from_mm(distance_mm),
                   Length::from_mm(0.2), Length::from_units(25)});
    for (RowStretch& stretch : rows.stretches) stretch.from_covered = stretch.to_covered = false;
    const RowStrips grid{RowTurn(angle), distance_mm * kUnitsPerMm, 1'500};
    const Region rests = row_rests(region, rows.stretches, grid, 0);
    const Region expected = by_boolean(region, rows.stretches, grid);
    CHECK(rests.area_mm2() == doctest::Approx(expected.area_mm2()).epsilon(2e-3));
    CHECK_LE(test::widest_difference(rests, expected), 12);
    rests_mm2 += rests.area_mm2();
  }
  CHECK_GT(rests_mm2, 50);
}

TEST_CASE("a window is cut where it holds enough, and not beyond a covered end") {
  // Rows of 10 mm in a strip of 14 mm: 2 mm are left at either end.
  const Region region = test::region_from_text("-2:0 12:0 12:1 -2:1");
  const RowStrips grid{RowTurn(0), 10'000, 0};
  std::vector<RowStretch> rows = {{0, 0, 100'000}};
  CHECK(row_rests(region, rows, grid, 0.5).area_mm2() == doctest::Approx(4).epsilon(1e-3));
  CHECK(row_rests(region, rows, grid, 1.99).area_mm2() == doctest::Approx(4).epsilon(1e-3));
  CHECK(row_rests(region, rows, grid, 2.01).empty());
  rows[0].to_covered = true;
  CHECK(row_rests(region, rows, grid, 0.5).area_mm2() == doctest::Approx(2).epsilon(1e-3));
  // A strip without any row is one window.
  CHECK(row_rests(region, {}, grid, 0.5).area_mm2() == doctest::Approx(14).epsilon(1e-3));
  CHECK(row_rests({}, rows, grid, 0.5).empty());
}
