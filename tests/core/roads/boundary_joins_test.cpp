#include "core/roads/boundary_joins.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/straight_pattern.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr Length kAny = Length::from_units(10'000'000);

std::vector<ClippedLine> rows_in(const Region& region, const LineClipper& clipper, double distance,
                                 double degrees) {
  std::vector<ClippedLine> lines;
  const StraightPattern pattern(StraightPattern::Kind::kLines);
  for (const auto& line : pattern.lines({region.box(), distance, 0, degrees, 0, {}})) {
    clipper.clip(line, lines);
  }
  return lines;
}

double total_mm(const std::vector<ClippedLine>& lines) {
  double mm = 0;
  for (const ClippedLine& line : lines) mm += length_mm(line.points, false);
  return mm;
}

double total_mm(const std::vector<std::vector<Point>>& lines) {
  double mm = 0;
  for (const auto& line : lines) mm += length_mm(line, false);
  return mm;
}

}  // namespace

TEST_CASE("rows in a convex region are one way, with joins along half of the contour") {
  const Region square = test::region_from_text("0:0 40:0 40:40 0:40");
  for (const double degrees : {30.0, 45.0, 70.0}) {
    CAPTURE(degrees);
    const LineClipper clipper(square);
    const auto lines = rows_in(square, clipper, 20'000, degrees);
    const auto ways = join_along_boundary(lines, clipper, kAny).ways;
    CHECK_EQ(ways.size(), 1);
    CHECK(total_mm(ways) - total_mm(lines) == doctest::Approx(80).epsilon(0.08));
  }
}

TEST_CASE("no join is longer than the longest, and with 0 there is none") {
  const Region square = test::region_from_text("0:0 40:0 40:40 0:40");
  const LineClipper clipper(square);
  const auto lines = rows_in(square, clipper, 20'000, 0);
  CHECK_EQ(join_along_boundary(lines, clipper, Length()).ways.size(), lines.size());
  CHECK_EQ(join_along_boundary(lines, clipper, Length::from_mm(1.99)).ways.size(), lines.size());
  CHECK_EQ(join_along_boundary(lines, clipper, Length::from_mm(2.01)).ways.size(), 1);
}

TEST_CASE("random regions: every row once, joins along the contour, no stretch of it twice") {
  std::size_t rows = 0, ways_in_all = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 60, 40);
    if (region.empty()) continue;
    const LineClipper clipper(region);
    const auto lines = rows_in(region, clipper, 15'000, random.between(0, 90));
    const auto ways = join_along_boundary(lines, clipper, kAny).ways;
    rows += lines.size();
    ways_in_all += ways.size();
    // Each row's two points follow one another somewhere.
    std::multiset<std::pair<Point, Point>> steps;
    for (const auto& way : ways) {
      for (std::size_t i = 1; i < way.size(); ++i) {
        steps.insert(std::minmax(way[i - 1], way[i]));
        for (const double t : {0.25, 0.5, 0.75}) {
          const Point p = between(way[i - 1], way[i], t);
          CHECK_GT(test::signed_distance(region, p.x, p.y), -3);
        }
      }
    }
    for (const ClippedLine& line : lines) {
      CHECK_EQ(steps.count(std::minmax(line.points.front(), line.points.back())), 1);
    }
    CHECK_LE(total_mm(ways) - total_mm(lines), region.perimeter_mm());
    const auto again = join_along_boundary(lines, clipper, kAny).ways;
    CHECK_EQ(again, ways);
  }
  CHECK_GT(rows, 200);
  CHECK_LT(ways_in_all * 3, rows);
}
