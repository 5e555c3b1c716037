#include "core/roads/monotonic_joins.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/line_fill.h"
#include "core/roads/row_turn.h"
#include "core/roads/straight_pattern.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

struct Rows {
  std::vector<ClippedLine> lines;
  std::vector<RowStretch> stretches;
};

Rows rows_in(const Region& region, const LineClipper& clipper, double distance, double degrees) {
  Rows rows;
  const RowTurn turn(degrees);
  for (const PatternRow& row : rows_over(region.box(), degrees, distance, 0)) {
    const std::size_t first = rows.lines.size();
    clipper.clip({row.line.from, row.line.to}, rows.lines);
    for (std::size_t i = first; i < rows.lines.size(); ++i) {
      rows.stretches.push_back({row.number, turn.to_rows(rows.lines[i].points.front())[0],
                                turn.to_rows(rows.lines[i].points.back())[0]});
    }
  }
  return rows;
}

// The rows' numbers in the order in which they are laid: they follow one another in the ways.
std::vector<std::size_t> laid_order(const Rows& rows, const JoinedLines& joined) {
  std::map<std::pair<Point, Point>, std::size_t> number;
  for (std::size_t i = 0; i < rows.lines.size(); ++i) {
    number[std::minmax(rows.lines[i].points.front(), rows.lines[i].points.back())] = i;
  }
  std::vector<std::size_t> order;
  for (const std::vector<Point>& way : joined.ways) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      const auto found = number.find(std::minmax(way[i - 1], way[i]));
      if (found != number.end()) order.push_back(found->second);
    }
  }
  return order;
}

bool touch(const RowStretch& a, const RowStretch& b) { return a.from <= b.to && b.from <= a.to; }

// Whether a laid row touches this one in the row above or below.
bool beside_laid(const Rows& rows, const std::vector<bool>& laid, std::size_t at, int step) {
  for (std::size_t i = 0; i < rows.stretches.size(); ++i) {
    if (laid[i] && rows.stretches[i].row == rows.stretches[at].row + step &&
        touch(rows.stretches[i], rows.stretches[at])) {
      return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("a convex region is one way, row by row upwards") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  const LineClipper clipper(square);
  const Rows rows = rows_in(square, clipper, 4'000, 45);
  const JoinedLines joined =
      join_monotonic(rows.lines, rows.stretches, clipper, Length::from_mm(5));
  CHECK_EQ(joined.ways.size(), 1);
  const std::vector<std::size_t> order = laid_order(rows, joined);
  CHECK_EQ(order.size(), rows.lines.size());
  CHECK(std::is_sorted(order.begin(), order.end()));
}

TEST_CASE("random regions: each row once, and none between two that are laid") {
  std::size_t rows_seen = 0, ways_seen = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 60, 30);
    if (region.empty()) continue;
    const LineClipper clipper(region);
    const Rows rows = rows_in(region, clipper, 6'000, random.between(0, 180));
    const JoinedLines joined =
        join_monotonic(rows.lines, rows.stretches, clipper, Length::from_mm(4));
    const std::vector<std::size_t> order = laid_order(rows, joined);
    REQUIRE_EQ(order.size(), rows.lines.size());
    std::vector<bool> laid(rows.lines.size(), false);
    for (const std::size_t line : order) {
      CHECK_FALSE(laid[line]);
      const bool between = beside_laid(rows, laid, line, -1) && beside_laid(rows, laid, line, 1);
      CHECK_FALSE(between);
      laid[line] = true;
    }
    for (const std::vector<Point>& way : joined.ways) {
      for (std::size_t i = 1; i < way.size(); ++i) {
        const Point middle = between(way[i - 1], way[i], 0.5);
        CHECK_GT(test::signed_distance(region, middle.x, middle.y), -3);
      }
    }
    rows_seen += order.size();
    ways_seen += joined.ways.size();
  }
  CHECK_GT(rows_seen, 400);
  CHECK_LT(ways_seen * 3, rows_seen);
}
