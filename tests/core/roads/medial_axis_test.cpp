#include "core/roads/medial_axis.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/booleans/boolean.h"
#include "core/units.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Point;
using core::Region;
using core::ThickPolyline;
using test::Random;
using test::region_from_text;

namespace {

double units(Length length) { return static_cast<double>(length.units()); }

std::vector<ThickPolyline> axis(const Region& region, double min_mm, double max_mm) {
  return core::medial_axis(region, Length::from_mm(min_mm), Length::from_mm(max_mm));
}

double length_mm(const ThickPolyline& line) {
  double sum = 0;
  const std::size_t count = line.points.size();
  for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
    const Point a = line.points[i], b = line.points[(i + 1) % count];
    sum += std::hypot(double(b.x) - a.x, double(b.y) - a.y) / core::kUnitsPerMm;
  }
  return sum;
}

// What every line of every region has to keep.
void check_lines(const Region& region, const std::vector<ThickPolyline>& lines, double min_mm,
                 double max_mm) {
  double worst = 0;
  for (const ThickPolyline& line : lines) {
    REQUIRE_EQ(line.points.size(), line.widths.size());
    REQUIRE_GE(line.points.size(), line.closed ? 3u : 2u);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Point p = line.points[i];
      CHECK_NE(p, line.points[(i + 1) % line.points.size()]);
      CHECK_GE(line.widths[i], Length::from_mm(min_mm) - Length::from_units(1));
      CHECK_LE(line.widths[i], Length::from_mm(max_mm) + Length::from_units(1));
      const double distance = test::signed_distance(region, p.x, p.y);
      worst = std::max(worst, std::abs(distance - units(line.widths[i]) / 2));
    }
  }
  CHECK_LE(worst, 2);
}

// A road from a to b, its width changing linearly, with round ends.
bool road_covers(Point a, Length width_a, Point b, Length width_b, double x, double y) {
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
  const double along = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  const double radius = (units(width_a) + t * (units(width_b) - units(width_a))) / 2;
  return std::hypot(x - a.x - t * dx, y - a.y - t * dy) <= radius;
}

struct Cover {
  double inside = 0;   // share of the region that is covered
  double outside = 0;  // area covered outside of it, as a share of the region's
};

Cover cover(const Region& region, const std::vector<ThickPolyline>& lines, double cell_units) {
  core::Box box = region.box();
  double inside = 0, covered_inside = 0, covered_outside = 0;
  // Odd offsets, so that no point of the raster lies on an edge.
  for (double x = box.min.x - 1932.7; x < box.max.x + 2000.0; x += cell_units) {
    for (double y = box.min.y - 1951.3; y < box.max.y + 2000.0; y += cell_units) {
      const bool is_inside = test::winding_number(region.rings(), x, y) == 1;
      bool covered = false;
      for (const ThickPolyline& line : lines) {
        const std::size_t count = line.points.size();
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count && !covered; ++i) {
          const std::size_t j = (i + 1) % count;
          covered =
              road_covers(line.points[i], line.widths[i], line.points[j], line.widths[j], x, y);
        }
      }
      inside += is_inside ? 1 : 0;
      covered_inside += is_inside && covered ? 1 : 0;
      covered_outside += !is_inside && covered ? 1 : 0;
    }
  }
  return {covered_inside / inside, covered_outside / inside};
}

}  // namespace

TEST_CASE("a strip has one line along its middle, up to where the round ends touch") {
  const Region region = region_from_text("0:0 10:0 10:0.3 0:0.3");
  const std::vector<ThickPolyline> lines = axis(region, 0.1, 0.6);
  REQUIRE_EQ(lines.size(), 1u);
  ThickPolyline line = lines[0];
  CHECK_FALSE(line.closed);
  REQUIRE_EQ(line.points.size(), 2u);
  if (line.points[1] < line.points[0]) std::swap(line.points[0], line.points[1]);
  CHECK_EQ(line.points[0], Point{1'500, 1'500});
  CHECK_EQ(line.points[1], Point{98'500, 1'500});
  CHECK_EQ(line.widths[0], Length::from_mm(0.3));
  CHECK_EQ(line.widths[1], Length::from_mm(0.3));
}

TEST_CASE("the limits of width are included, and keep the rest out") {
  const Region region = region_from_text("0:0 10:0 10:0.3 0:0.3");
  CHECK_EQ(axis(region, 0.3, 0.6).size(), 1u);
  CHECK_EQ(axis(region, 0.1, 0.3).size(), 1u);
  CHECK(axis(region, 0.301, 0.6).empty());
  CHECK(axis(region, 0.1, 0.299).empty());
  CHECK(axis(Region(), 0.1, 0.3).empty());
}

TEST_CASE("a ring-shaped gap has one closed line") {
  Random random(1);
  for (const int points : {4, 7, 64, 333}) {
    CAPTURE(points);
    core::Ring outer, inner;
    for (int i = 0; i < points; ++i) {
      const double angle = 2 * 3.14159265358979 * i / points;
      outer.push_back({static_cast<std::int32_t>(std::lround(51'500 * std::cos(angle))),
                       static_cast<std::int32_t>(std::lround(51'500 * std::sin(angle)))});
      inner.push_back({static_cast<std::int32_t>(std::lround(48'500 * std::cos(angle))),
                       static_cast<std::int32_t>(std::lround(48'500 * std::sin(angle)))});
    }
    std::reverse(inner.begin(), inner.end());
    const Region region = Region::from_clean_rings({outer, inner});
    const std::vector<ThickPolyline> lines = axis(region, 0.1, 0.6);
    REQUIRE_EQ(lines.size(), 1u);
    CHECK(lines[0].closed);
    check_lines(region, lines, 0.1, 0.6);
    if (points == 333) {
      CHECK_EQ(length_mm(lines[0]), doctest::Approx(2 * 3.14159265 * 5).epsilon(0.001));
      for (const Length width : lines[0].widths) CHECK_LE(std::abs(units(width) - 3000), 5);
    }
  }
}

TEST_CASE("a wedge's line has widths that grow linearly, and ends where it is too narrow") {
  const Region region = region_from_text("0:0 20:-0.4 20:0.4");
  const std::vector<ThickPolyline> lines = axis(region, 0.1, 1.0);
  REQUIRE_EQ(lines.size(), 1u);
  check_lines(region, lines, 0.1, 1.0);
  const ThickPolyline& line = lines[0];
  const double sine = 0.4 / std::hypot(20, 0.4);
  Length narrowest = line.widths[0];
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    CHECK_LE(std::abs(units(line.widths[i]) - 2 * sine * line.points[i].x), 2);
    narrowest = std::min(narrowest, line.widths[i]);
  }
  CHECK_LE(std::abs(units(narrowest) - 1000), 1);
}

TEST_CASE("roads along the lines fill strips, and stay inside") {
  const std::string shapes[] = {
      "0:0 10:0 10:0.3 0.3:0.3 0.3:8 0:8",                 // L
      "0:0 10:0 10:0.3 5.3:0.3 5.3:6 5:6 5:0.3 0:0.3",     // T
      "0:0 20:0 20:0.4 12:0.2 8:0.2 0:0.4",                // bow tie
      "0:0 6:0 6:6 0:6, 0.3:0.3 0.3:5.7 5.7:5.7 5.7:0.3",  // frame
      "0:0 8:4 16:0 16:0.3 8:4.3 0:0.3",                   // roof
  };
  for (const std::string& shape : shapes) {
    CAPTURE(shape);
    const Region region = region_from_text(shape);
    const std::vector<ThickPolyline> lines = axis(region, 0.05, 0.9);
    check_lines(region, lines, 0.05, 0.9);
    const Cover covered = cover(region, lines, 200);
    CHECK_GE(covered.inside, 0.99);
    CHECK_LE(covered.outside, 0.002);
  }
}

TEST_CASE("a T has three lines that meet") {
  const Region region = region_from_text("0:0 10:0 10:0.3 5.3:0.3 5.3:6 5:6 5:0.3 0:0.3");
  const std::vector<ThickPolyline> lines = axis(region, 0.1, 0.6);
  REQUIRE_EQ(lines.size(), 3u);
  std::vector<Point> ends;
  for (const ThickPolyline& line : lines) {
    ends.push_back(line.points.front());
    ends.push_back(line.points.back());
  }
  int meeting = 0;
  for (const Point p : ends) meeting += std::count(ends.begin(), ends.end(), p) == 3 ? 1 : 0;
  CHECK_EQ(meeting, 3);
}

TEST_CASE("spurs into wide corners go, sharp corners are followed") {
  // The square's four spurs would leave nothing: two of them stay and make one line.
  const std::vector<ThickPolyline> square =
      axis(region_from_text("0:0 0.4:0 0.4:0.4 0:0.4"), 0.3, 1);
  REQUIRE_EQ(square.size(), 1u);
  // A strip that ends in a point of 90°, and one that ends in a needle.
  const std::vector<ThickPolyline> blunt =
      axis(region_from_text("0:0 5:0 5.2:0.2 5:0.4 0:0.4"), 0.05, 1);
  REQUIRE_EQ(blunt.size(), 1u);
  CHECK_LT(length_mm(blunt[0]), 4.95);
  const std::vector<ThickPolyline> sharp =
      axis(region_from_text("0:0 5:0 8:0.2 5:0.4 0:0.4"), 0.05, 1);
  REQUIRE_EQ(sharp.size(), 1u);
  CHECK_GT(length_mm(sharp[0]), 6.5);
  const std::vector<ThickPolyline> pointed =
      axis(region_from_text("0:0 5:0 5.746:0.2 5:0.4 0:0.4"), 0.05, 1);  // 30°
  REQUIRE_EQ(pointed.size(), 1u);
  CHECK_GT(length_mm(pointed[0]), 5.3);
}

TEST_CASE("one long edge that faces thousands of small ones is no more work than they are") {
  core::Ring rack{{0, 0}, {9'000'000, 0}};
  for (std::int32_t x = 9'000'000 - 900; x >= 0; x -= 900) {
    rack.insert(rack.end(), {{x + 900, 4'000}, {x + 500, 4'000}, {x + 500, 3'000}, {x, 3'000}});
  }
  const std::vector<ThickPolyline> lines = axis(Region::from_clean_rings({rack}), 0.05, 0.9);
  REQUIRE_EQ(lines.size(), 1u);
  CHECK_EQ(length_mm(lines[0]), doctest::Approx(900).epsilon(0.01));
}

TEST_CASE("random regions: every point's width is what was measured") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 150, 6);
    const std::vector<ThickPolyline> lines = axis(region, 0.1, 0.8);
    check_lines(region, lines, 0.1, 0.8);
  }
}

TEST_CASE("a gap between two outlines is filled") {
  for (std::uint64_t seed = 20; seed <= 23; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const core::Ring outer = test::random_blob(random, 200, 0, 0, 3, 0.002);
    core::Ring inner;
    for (const Point p : outer) {
      inner.push_back({static_cast<std::int32_t>(p.x * 0.9), static_cast<std::int32_t>(p.y * 0.9)});
    }
    std::reverse(inner.begin(), inner.end());
    const Region region = core::clean({outer, inner}, core::FillRule::kPositive);
    const std::vector<ThickPolyline> lines = axis(region, 0.02, 0.9);
    check_lines(region, lines, 0.02, 0.9);
    const Cover covered = cover(region, lines, 1000);
    CHECK_GE(covered.inside, 0.98);
    CHECK_LE(covered.outside, 0.005);
  }
}
