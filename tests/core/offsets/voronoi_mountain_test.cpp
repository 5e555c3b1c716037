#include "core/offsets/voronoi_mountain.h"

#include <doctest/doctest.h>

#include <cmath>
#include <polyclipping/clipper.hpp>
#include <string>

#include "core/booleans/boolean.h"
#include "core/offsets/capsule_offset.h"
#include "core/units.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::OffsetContours;
using core::Region;
using core::Ring;
using core::VoronoiMountain;
using test::Random;
using test::region_from_text;

namespace {

const Length kTolerance = Length::from_mm(0.0025);
// Both ends of a chord are rounded, and the crossing point behind them.
constexpr double kRounding = 2;

double units(Length length) { return static_cast<double>(length.units()); }

// A third opinion: every point's distance, measured edge by edge.
void check_by_distance(const Region& region, Length depth, const Region& result, Random& random,
                       int samples) {
  const core::Box box = region.box();
  const double margin = std::abs(units(depth)) + 1000, slack = units(kTolerance) + kRounding;
  int wrong = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = random.between(box.min.x - margin, box.max.x + margin);
    const double y = random.between(box.min.y - margin, box.max.y + margin);
    const double height = test::signed_distance(region, x, y) - units(depth);
    if (std::abs(height) < slack) continue;
    if (test::winding_number(result.rings(), x, y) != (height > 0 ? 1 : 0)) ++wrong;
  }
  CHECK_EQ(wrong, 0);
}

// Every corner of the result must lie on the offset.
void check_corners(const Region& region, Length depth, const Region& result) {
  double worst = 0;
  for (const Ring& ring : result.rings()) {
    for (const core::Point p : ring) {
      worst = std::max(worst, std::abs(test::signed_distance(region, p.x, p.y) - units(depth)));
    }
  }
  CHECK_LE(worst, units(kTolerance) + kRounding);
}

Region clipper_offset(const Region& region, Length depth) {
  // Clipper rounds to its integers, so it gets finer ones.
  constexpr int kScale = 16;
  ClipperLib::ClipperOffset offset(2, 0.5 * kScale);
  for (const Ring& ring : region.rings()) {
    ClipperLib::Path path;
    for (const core::Point p : ring) {
      path.push_back({std::int64_t{p.x} * kScale, std::int64_t{p.y} * kScale});
    }
    offset.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  }
  ClipperLib::Paths paths;
  offset.Execute(paths, -units(depth) * kScale);
  std::vector<Ring> rings;
  for (const ClipperLib::Path& path : paths) {
    Ring ring;
    for (const ClipperLib::IntPoint& p : path) {
      ring.push_back({static_cast<std::int32_t>(std::lround(double(p.X) / kScale)),
                      static_cast<std::int32_t>(std::lround(double(p.Y) / kScale))});
    }
    rings.push_back(std::move(ring));
  }
  return core::clean(rings, core::FillRule::kPositive);
}

Region make_offset(const VoronoiMountain& mountain, Length depth) {
  return core::flatten(mountain.offset(depth), kTolerance);
}

}  // namespace

TEST_CASE("a square's offsets, in and out") {
  const Region square = region_from_text("0:0 10:0 10:10 0:10");
  const VoronoiMountain mountain(square);
  const Region inner = make_offset(mountain, Length::from_mm(1));
  CHECK_EQ(inner.area_mm2(), doctest::Approx(64));
  CHECK_EQ(inner.point_count(), 4u);
  CHECK_EQ(make_offset(mountain, Length()), square);
  CHECK(mountain.offset(Length::from_mm(5)).empty());
  CHECK(mountain.offset(Length::from_mm(500)).empty());
  const OffsetContours outer = mountain.offset(Length::from_mm(-1));
  REQUIRE_EQ(outer.size(), 1u);
  CHECK_EQ(outer[0].size(), 8u);
  int arcs = 0;
  for (const core::OffsetPiece& piece : outer[0]) {
    if (piece.kind == core::OffsetPiece::Kind::kLine) continue;
    CHECK(piece.kind == core::OffsetPiece::Kind::kArcCounterClockwise);
    ++arcs;
  }
  CHECK_EQ(arcs, 4);
  CHECK_EQ(core::flatten(outer, kTolerance).area_mm2(),
           doctest::Approx(100 + 40 + 3.14159265).epsilon(0.0005));
  CHECK(VoronoiMountain(Region()).offset(Length::from_mm(1)).empty());
  CHECK(VoronoiMountain(Region()).offset(Length::from_mm(-1)).empty());
}

TEST_CASE("a reflex corner gives a clockwise arc about itself") {
  const VoronoiMountain mountain(region_from_text("0:0 10:0 10:10 5:10 5:5 0:5"));
  const OffsetContours inner = mountain.offset(Length::from_mm(1));
  REQUIRE_EQ(inner.size(), 1u);
  int arcs = 0;
  for (const core::OffsetPiece& piece : inner[0]) {
    if (piece.kind == core::OffsetPiece::Kind::kLine) continue;
    CHECK(piece.kind == core::OffsetPiece::Kind::kArcClockwise);
    CHECK_EQ(piece.centre, core::Point{50'000, 50'000});
    ++arcs;
  }
  CHECK_EQ(arcs, 1);
}

TEST_CASE("a ridge that dips below the offset is cut twice, and parts the contours") {
  // Two spikes, tip to tip, and a spike towards a wall: gaps of 0.4 mm between two rooms.
  for (const std::string shape : {"0:0 4.9:0 5:4.8 5.1:0 10:0 10:10 5.1:10 5:5.2 4.9:10 0:10",
                                  "0:0 4.9:0 5:9.6 5.1:0 10:0 10:10 0:10"}) {
    CAPTURE(shape);
    const VoronoiMountain mountain(region_from_text(shape));
    CHECK_EQ(mountain.offset(Length::from_mm(0.19)).size(), 1u);
    CHECK_EQ(mountain.offset(Length::from_mm(0.45)).size(), 2u);
  }
}

TEST_CASE("touching contours, needles and slots") {
  const std::string shapes[] = {
      "0:0 4:0 4:4 0:4, 4:4 8:4 8:8 4:8",                       // corner to corner
      "0:0 4:0 4:4 0:4, 2:4 3:6 1:6",                           // corner to edge
      "0:0 10:0 10:10 0:10, 5:0 0:5 5:10 10:5",                 // a hole that touches
      "0:0 10:0 10:10 0:10, 3:3 3:5 5:5 5:3, 5:5 5:7 7:7 7:5",  // holes that touch
      "0:0 20:0 20:0.001",                                      // a needle
      "0:0 20:0 20:5 10.0001:5 10.00005:0.5 10:5 0:5",          // a slot
      // Two spikes, tip to tip: the ridge between the tips is cut twice.
      "0:0 4.9:0 5:4.8 5.1:0 10:0 10:10 5.1:10 5:5.2 4.9:10 0:10",
      // A spike towards a wall: so is a parabola.
      "0:0 4.9:0 5:9.6 5.1:0 10:0 10:10 0:10",
      "0:0 10:0 10:2 0:2",                   // an axis at one height
      "0:0 5:0 10:0 10:10 5:10 0:10 0:5",    // straight corners
      "0:0 6:0 6:3 0:3, 7:0 13:0 13:3 7:3",  // two islands
      "0:0 30:0 30:30 0:30, 10:10 10:20 20:20 20:10, 12:12 18:12 18:18 12:18",
  };
  Random random(1);
  for (const std::string& shape : shapes) {
    CAPTURE(shape);
    const Region region = region_from_text(shape);
    const VoronoiMountain mountain(region);
    for (const double depth_mm : {0.0003, 0.05, 0.45, 1.0, 1.7, 3.0, -0.0003, -0.2, -1.0, -4.0}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const Region result = make_offset(mountain, depth);
      CHECK(test::is_clean(result));
      check_by_distance(region, depth, result, random, 600);
      check_corners(region, depth, result);
      CHECK_LE(test::widest_difference(result, clipper_offset(region, depth)),
               units(kTolerance) + kRounding);
    }
    CHECK_EQ(mountain.fallbacks(), 0);
    CHECK_EQ(mountain.retries(), 0);
  }
}

TEST_CASE("random regions agree with measured distances and with Clipper") {
  int retries = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, seed % 8 == 0 ? 500 : 120, 20);
    const VoronoiMountain mountain(region);
    double last_area = 1e9;
    for (const double depth_mm : {-3.0, -0.5, -0.1, 0.0, 0.05, 0.2, 0.45, 0.9, 1.8, 3.6}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const Region result = make_offset(mountain, depth);
      CHECK(test::is_clean(result));
      CHECK_LE(result.area_mm2(), last_area);
      last_area = result.area_mm2();
      if (depth_mm == 0.0) {
        CHECK_EQ(result, region);
        continue;
      }
      check_by_distance(region, depth, result, random, 100);
      check_corners(region, depth, result);
      CHECK_LE(test::widest_difference(result, clipper_offset(region, depth)),
               units(kTolerance) + kRounding);
    }
    retries += mountain.retries();
    CHECK_EQ(mountain.fallbacks(), 0);
  }
  MESSAGE("diagrams turned: " << retries);
}

TEST_CASE("small regions, where everything is rounding") {
  int retries = 0, fallbacks = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = core::clean({test::random_ring(random, random.integer(4, 12), 0.01)},
                                      core::FillRule::kNonZero);
    const VoronoiMountain mountain(region);
    for (const int depth_units : {1, 3, 10, -1, -5, -40}) {
      CAPTURE(depth_units);
      const Length depth = Length::from_units(depth_units);
      const Region result = make_offset(mountain, depth);
      CHECK(test::is_clean(result));
      check_by_distance(region, depth, result, random, 40);
    }
    retries += mountain.retries();
    fallbacks += mountain.fallbacks();
  }
  MESSAGE("diagrams turned: " << retries << ", capsules: " << fallbacks);
}

TEST_CASE("shapes full of coincidences: boxes on a lattice, needles, circles about few centres") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Ring> rings;
    for (int i = 0; i < 7; ++i) {
      const int x = random.integer(0, 8), y = random.integer(0, 8);
      if (seed % 3 == 0) {
        const int width = random.integer(1, 4), height = random.integer(1, 4);
        rings.push_back(test::rectangle(x, y, x + width, y + height));
      } else if (seed % 3 == 1) {
        const double angle = random.between(0, 6.28);
        const core::Point tip{static_cast<std::int32_t>(std::lround(90'000 * std::cos(angle))),
                              static_cast<std::int32_t>(std::lround(90'000 * std::sin(angle)))};
        rings.push_back({{x * 100, y * 100}, tip, {tip.x + x - 4, tip.y + y - 4}});
      } else {
        const int corners = random.integer(3, 48), radius = random.integer(1, 3);
        rings.push_back(test::random_blob(random, corners, x / 4, y / 4, radius, 0));
      }
    }
    const Region region = core::clean(rings, core::FillRule::kNonZero);
    const VoronoiMountain mountain(region);
    for (const double depth_mm : {0.0002, 0.03, 0.5, -0.0002, -0.5, -3.0}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const Region result = make_offset(mountain, depth);
      CHECK(test::is_clean(result));
      check_by_distance(region, depth, result, random, 100);
      check_corners(region, depth, result);
    }
    // Straight runs through corners and corners that touch are no reason to turn.
    if (seed % 3 == 0) CHECK_EQ(mountain.retries(), 0);
    CHECK_EQ(mountain.fallbacks(), 0);
  }
}

TEST_CASE("two erosions make one") {
  for (std::uint64_t seed = 40; seed <= 50; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 200, 20);
    const Length a = Length::from_mm(random.between(0.05, 0.5));
    const Length b = Length::from_mm(random.between(0.05, 0.5));
    const Region once = core::offset(region, a + b, kTolerance);
    const Region twice = core::offset(core::offset(region, a, kTolerance), b, kTolerance);
    CHECK_LE(test::widest_difference(once, twice), 2 * units(kTolerance) + 2 * kRounding);
  }
}

TEST_CASE("a contour of 20,000 edges") {
  Random random(3);
  const Region region =
      Region::from_clean_rings({test::random_blob(random, 20'000, 0, 0, 60, 0.002)});
  REQUIRE_EQ(region.point_count(), 20'000u);
  const VoronoiMountain mountain(region);
  for (const double depth_mm : {0.2, 1.35, -0.8}) {
    CAPTURE(depth_mm);
    const Length depth = Length::from_mm(depth_mm);
    const Region result = make_offset(mountain, depth);
    check_by_distance(region, depth, result, random, 300);
  }
  CHECK_EQ(mountain.fallbacks(), 0);
}

TEST_CASE("known failures of Boost's diagram are noticed and survived") {
  // boostorg/polygon#43.
  const Region region = core::clean({{{0, 10'000'000},
                                      {700'000, 1},
                                      {700'000, 9'000'000},
                                      {9'100'000, 9'000'000},
                                      {9'100'000, 0},
                                      {10'000'000, 10'000'000}}},
                                    core::FillRule::kNonZero);
  REQUIRE_EQ(region.point_count(), 6u);
  Random random(1);
  const VoronoiMountain mountain(region);
  MESSAGE("diagrams turned: " << mountain.retries());
  for (const double depth_mm : {0.5, 10.0, 30.0, -0.5, -10.0, -100.0}) {
    CAPTURE(depth_mm);
    const Length depth = Length::from_mm(depth_mm);
    const Region result = make_offset(mountain, depth);
    check_by_distance(region, depth, result, random, 2000);
    check_corners(region, depth, result);
  }
}

TEST_CASE("the slow way gives the same offsets") {
  for (std::uint64_t seed = 60; seed <= 64; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 60, 20);
    for (const double depth_mm : {0.3, -0.3}) {
      const Length depth = Length::from_mm(depth_mm);
      const Region slow = core::capsule_offset(region, depth);
      CHECK(test::is_clean(slow));
      CHECK_LE(test::widest_difference(slow, core::offset(region, depth, kTolerance)),
               units(kTolerance) + kRounding);
    }
  }
}
