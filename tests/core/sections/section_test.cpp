#include "core/sections/section.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using core::Interval;
using core::Intervals;
using core::Length;
using core::Point;
using core::Region;
using core::Road;
using core::SectionLine;
using test::Random;

namespace {

bool is_clean(const Intervals& intervals) {
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    if (intervals[i].from >= intervals[i].to) return false;
    if (i > 0 && intervals[i - 1].to >= intervals[i].from) return false;
  }
  return true;
}

bool covers(const Intervals& intervals, std::int64_t at) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [at](const Interval& i) { return i.from <= at && at < i.to; });
}

bool near_an_end(const Intervals& intervals, std::int64_t at, std::int64_t units) {
  return std::any_of(intervals.begin(), intervals.end(), [&](const Interval& i) {
    return std::abs(i.from - at) <= units || std::abs(i.to - at) <= units;
  });
}

SectionLine line_at(SectionLine::Across across, std::int64_t at) {
  return {across, Length::from_units(at)};
}

Intervals random_intervals(Random& random) {
  Intervals some;
  for (int i = random.integer(0, 6); i > 0; --i) {
    const int from = random.integer(0, 60);
    some.push_back({from, from + random.integer(0, 12)});
  }
  return core::joined(some);
}

double distance(const Road& road, double x, double y) {
  double nearest = 1e18;
  const std::size_t count = road.points.size();
  for (std::size_t i = 0; i + (road.closed ? 0 : 1) < count; ++i) {
    const Point a = road.points[i], b = road.points[(i + 1) % count];
    const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    const double share =
        length2 == 0 ? 0 : std::clamp(((x - a.x) * dx + (y - a.y) * dy) / length2, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(x - a.x - share * dx, y - a.y - share * dy));
  }
  return nearest;
}

}  // namespace

TEST_CASE("a square with a hole, cut both ways, at its corners and outside") {
  const Region region = test::region_from_text("0:0 10:0 10:10 0:10, 3:3 3:6 8:6 8:3");
  const auto across = [&](double y_mm) {
    return core::section_of(region, {SectionLine::Across::kY, Length::from_mm(y_mm)});
  };
  const Intervals whole{{0, 100'000}}, holed{{0, 30'000}, {80'000, 100'000}};
  CHECK_EQ(across(1), whole);
  CHECK_EQ(across(4), holed);
  // The line runs above the corners that lie at its height.
  CHECK_EQ(across(0), whole);
  CHECK_EQ(across(3), holed);
  CHECK_EQ(across(6), whole);
  CHECK_EQ(across(10), Intervals{});
  CHECK_EQ(across(-0.0001), Intervals{});
  const Intervals lengthwise{{0, 30'000}, {60'000, 100'000}};
  CHECK_EQ(core::section_of(region, {SectionLine::Across::kX, Length::from_mm(5)}), lengthwise);
  CHECK_EQ(core::section_of(Region(), {SectionLine::Across::kX, Length()}), Intervals{});
}

TEST_CASE("a point of the line is in the section where it is in the region") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 60, 20);
    const core::Box box = region.box();
    for (int cut = 0; cut < 20; ++cut) {
      const bool across_y = cut % 2 == 0;
      const int at =
          across_y ? random.integer(box.min.y, box.max.y) : random.integer(box.min.x, box.max.x);
      const Intervals section = core::section_of(
          region, line_at(across_y ? SectionLine::Across::kY : SectionLine::Across::kX, at));
      REQUIRE(is_clean(section));
      for (int i = 0; i < 50; ++i) {
        const int along =
            across_y ? random.integer(box.min.x, box.max.x) : random.integer(box.min.y, box.max.y);
        // The line is half a unit off the grid: what lies between both neighbours' answers is
        // not asked.
        const Point below = across_y ? Point{along, at} : Point{at, along};
        const Point above = across_y ? Point{along, at + 1} : Point{at + 1, along};
        const bool inside = region.contains(below);
        if (inside != region.contains(above) || near_an_end(section, along, 2)) continue;
        CAPTURE(along);
        CHECK_EQ(covers(section, along), inside);
      }
    }
  }
}

TEST_CASE("the sections of many lines add up to the area") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 40, 20);
    const core::Box box = region.box();
    const int lines = 2'000;
    const double step = (static_cast<double>(box.max.y) - box.min.y) / lines;
    double sum = 0;
    for (int i = 0; i < lines; ++i) {
      const auto at = static_cast<std::int64_t>(box.min.y + (i + 0.5) * step);
      const Intervals section = core::section_of(region, line_at(SectionLine::Across::kY, at));
      sum += core::total_length(section).mm() * step / core::kUnitsPerMm;
    }
    // Each contour is met at worst a step late.
    CHECK(std::abs(sum - region.area_mm2()) <= region.perimeter_mm() * step / core::kUnitsPerMm);
  }
}

TEST_CASE("operations on intervals, position by position") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Intervals a = random_intervals(random), b = random_intervals(random);
    const Intervals both = core::intersect(a, b), rest = core::subtract(a, b);
    REQUIRE(is_clean(a));
    // Touching pieces can only come of touching operands, which there are none.
    REQUIRE(is_clean(both));
    REQUIRE(is_clean(rest));
    for (int at = -1; at < 80; ++at) {
      CHECK_EQ(covers(both, at), covers(a, at) && covers(b, at));
      CHECK_EQ(covers(rest, at), covers(a, at) && !covers(b, at));
    }
    CHECK_EQ(core::total_length(both) + core::total_length(rest), core::total_length(a));
  }
}

TEST_CASE("a road's section is where its bead covers the line") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    Road road;
    road.width = Length::from_units(random.integer(2'000, 12'000));
    road.closed = random.integer(0, 1) == 1;
    for (int i = random.integer(3, 7); i > 0; --i) {
      road.points.push_back({random.integer(0, 50'000), random.integer(0, 50'000)});
    }
    // Along and across the line, and a point twice: the odd ones.
    if (seed % 3 == 0) road.points.push_back({road.points.back().x + 9'000, road.points.back().y});
    if (seed % 3 == 1) road.points.push_back({road.points.back().x, road.points.back().y + 9'000});
    if (seed % 5 == 0) road.points.push_back(road.points.back());
    const double radius = static_cast<double>(road.width.units()) / 2;
    for (int cut = 0; cut < 10; ++cut) {
      const bool across_y = cut % 2 == 0;
      const int at = random.integer(-8'000, 58'000);
      const Intervals section = core::section_of(
          road, line_at(across_y ? SectionLine::Across::kY : SectionLine::Across::kX, at));
      REQUIRE(is_clean(section));
      for (int i = 0; i < 100; ++i) {
        const int along = random.integer(-8'000, 68'000);
        if (near_an_end(section, along, 2)) continue;
        const double off =
            across_y ? distance(road, along, at + 0.5) : distance(road, at + 0.5, along);
        if (std::abs(off - radius) < 0.01) continue;
        CAPTURE(along);
        CHECK_EQ(covers(section, along), off < radius);
      }
    }
  }
}
