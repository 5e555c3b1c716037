#include "core/offsets/polygon_offset.h"

#include <doctest/doctest.h>

#include <cmath>
#include <polyclipping/clipper.hpp>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/units.h"
#include "tests/support/grid_regions.h"
#include "tests/support/offset_checks.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::OffsetContours;
using core::OffsetPiece;
using core::Point;
using core::PolygonOffsetter;
using core::Region;
using core::Ring;
using test::Random;
using test::region_from_text;

namespace {

using test::kArcTolerance;

// An end is rounded to the grid, and the depth was nudged: sqrt(1/2) and a little.
constexpr double kEnd = 0.75;
constexpr double kRounding = test::kOffsetRoundingUnits;

double units(Length length) { return static_cast<double>(length.units()); }

void check(const Region& region, Length depth, const OffsetContours& contours, Random& random,
           int samples) {
  CHECK_LE(test::worst_depth_error(region, depth, contours), kEnd);
  const Region result = core::flatten(contours, kArcTolerance);
  CHECK_EQ(test::misjudged_points(region, depth, result, random, samples), 0);
}

Region clipper_offset(const Region& region, Length depth) {
  ClipperLib::ClipperOffset offset(2, units(kArcTolerance));
  for (const Ring& ring : region.rings()) {
    ClipperLib::Path path;
    for (const Point p : ring) path.push_back({p.x, p.y});
    offset.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
  }
  ClipperLib::Paths paths;
  offset.Execute(paths, -units(depth));
  std::vector<Ring> rings;
  for (const ClipperLib::Path& path : paths) {
    Ring ring;
    for (const ClipperLib::IntPoint& p : path) {
      ring.push_back({static_cast<std::int32_t>(p.X), static_cast<std::int32_t>(p.Y)});
    }
    rings.push_back(std::move(ring));
  }
  return core::clean(rings, core::FillRule::kPositive);
}

}  // namespace

TEST_CASE("a square's offsets, in and out, in one go") {
  const Region square = region_from_text("0:0 10:0 10:10 0:10");
  PolygonOffsetter offsetter;
  const Length depths[] = {Length::from_mm(1), Length(), Length::from_mm(-1), Length::from_mm(5),
                           Length::from_mm(500)};
  OffsetContours out[5];
  offsetter.offset(square, depths, out);
  CHECK_EQ(core::flatten(out[0], kArcTolerance), region_from_text("1:1 9:1 9:9 1:9"));
  CHECK_EQ(core::flatten(out[1], kArcTolerance), square);
  CHECK(out[3].empty());
  CHECK(out[4].empty());
  REQUIRE_EQ(out[2].size(), 1u);
  REQUIRE_EQ(out[2][0].size(), 8u);
  int arcs = 0;
  for (const OffsetPiece& piece : out[2][0]) {
    if (piece.kind == OffsetPiece::Kind::kLine) continue;
    CHECK(piece.kind == OffsetPiece::Kind::kArcCounterClockwise);
    CHECK_EQ(std::hypot(piece.from.x - piece.centre.x, piece.from.y - piece.centre.y), 10'000);
    ++arcs;
  }
  CHECK_EQ(arcs, 4);
  CHECK(offsetter.offset(Region(), Length::from_mm(1)).empty());
  CHECK(offsetter.offset(Region(), Length::from_mm(-1)).empty());
}

TEST_CASE("a reflex corner gives a clockwise arc about itself") {
  const OffsetContours inner = PolygonOffsetter().offset(
      region_from_text("0:0 10:0 10:10 5:10 5:5 0:5"), Length::from_mm(1));
  REQUIRE_EQ(inner.size(), 1u);
  REQUIRE_EQ(inner[0].size(), 7u);
  int arcs = 0;
  for (const OffsetPiece& piece : inner[0]) {
    if (piece.kind == OffsetPiece::Kind::kLine) continue;
    CHECK(piece.kind == OffsetPiece::Kind::kArcClockwise);
    CHECK_EQ(piece.centre, Point{50'000, 50'000});
    CHECK_EQ(piece.from, Point{60'000, 50'000});
    ++arcs;
  }
  CHECK_EQ(arcs, 1);
}

TEST_CASE("touching contours, needles and slots") {
  const std::string shapes[] = {
      "0:0 4:0 4:4 0:4, 4:4 8:4 8:8 4:8",                       // corner to corner
      "0:0 4:0 4:4 0:4, 2:4 3:6 1:6",                           // corner to edge
      "0:0 10:0 10:10 0:10, 5:0 0:5 5:10 10:5",                 // a hole that touches
      "0:0 10:0 10:10 0:10, 3:3 3:5 5:5 5:3, 5:5 5:7 7:7 7:5",  // holes that touch
      "0:0 10:0 10:10 5:10 5:5 4:10 0:10, 5:5 5.5:1 4.5:1",     // reflex wedges at one point
      "0:0 20:0 20:0.001",                                      // a needle
      "0:0 20:0 20:5 10.0001:5 10.00005:0.5 10:5 0:5",          // a slot
      "0:0 10:0 10:2 0:2",                                      // an axis at one height
      "0:0 5:0 10:0 10:10 5:10 0:10 0:5",                       // straight corners
      "0:0 6:0 6:3 0:3, 7:0 13:0 13:3 7:3",                     // two islands
      "0:0 0.0001:0 10:0 10:10 9.9999:10 0:10 0:0.0001",        // edges of one unit
      "0:0 30:0 30:30 0:30, 10:10 10:20 20:20 20:10, 12:12 18:12 18:18 12:18",
  };
  Random random(1);
  PolygonOffsetter offsetter;
  for (const std::string& shape : shapes) {
    CAPTURE(shape);
    const Region region = region_from_text(shape);
    for (const double depth_mm : {0.0003, 0.05, 0.45, 1.0, 1.7, 3.0, -0.0003, -0.2, -1.0, -4.0}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      check(region, depth, offsetter.offset(region, depth), random, 300);
    }
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
}

TEST_CASE("small regions full of coincidences") {
  PolygonOffsetter offsetter;
  int contours = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int scales[] = {1000, 997, 40, 7};
    const int scale = scales[random.integer(0, 3)];
    const Region region = test::random_grid_region(random, scale);
    const Length depth = test::random_grid_depth(random, scale);
    CAPTURE(depth.units());
    const OffsetContours offset = offsetter.offset(region, depth);
    contours += static_cast<int>(offset.size());
    check(region, depth, offset, random, 60);
  }
  CHECK_GT(contours, 2000);
  CHECK_EQ(offsetter.fallbacks(), 0);
  MESSAGE("critical depths: " << offsetter.retries());
}

TEST_CASE("the same as the whole diagram") {
  PolygonOffsetter offsetter;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const bool coarse = random.integer(0, 1) == 0;
    const Region region =
        coarse ? test::random_grid_region(random, 10'000) : test::random_region(random, 100, 20);
    const core::VoronoiMountain mountain(region);
    Length depths[4];
    OffsetContours out[4];
    for (Length& depth : depths) {
      depth =
          coarse ? test::random_grid_depth(random, 10'000) : Length::from_mm(random.between(-2, 3));
    }
    offsetter.offset(region, depths, out);
    for (std::size_t i = 0; i < 4; ++i) {
      CAPTURE(depths[i].mm());
      const Region ours = core::flatten(out[i], kArcTolerance);
      const Region reference = core::flatten(mountain.offset(depths[i]), kArcTolerance);
      CHECK(test::is_clean(ours));
      CHECK_LE(test::widest_difference(ours, reference), units(kArcTolerance) + kRounding);
    }
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
}

TEST_CASE("random regions agree with measured distances and with Clipper") {
  PolygonOffsetter offsetter;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, random.integer(20, 400), 20);
    for (const double depth_mm : {0.01, 0.225, 1.35, 4.0, -0.1, -1.35}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const OffsetContours contours = offsetter.offset(region, depth);
      check(region, depth, contours, random, 60);
      CHECK_LE(test::widest_difference(core::flatten(contours, kArcTolerance),
                                       clipper_offset(region, depth)),
               2 * units(kArcTolerance) + kRounding);
    }
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
}

TEST_CASE("small regions, where everything is rounding") {
  PolygonOffsetter offsetter;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = core::clean({test::random_ring(random, random.integer(4, 12), 0.01)},
                                      core::FillRule::kNonZero);
    for (const int depth_units : {1, 3, 10, -1, -5, -40}) {
      CAPTURE(depth_units);
      const Length depth = Length::from_units(depth_units);
      const OffsetContours contours = offsetter.offset(region, depth);
      check(region, depth, contours, random, 40);
      CHECK(test::is_clean(core::flatten(contours, kArcTolerance)));
    }
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
}

TEST_CASE("contours of 20,000 edges") {
  Random random(3);
  PolygonOffsetter offsetter;
  for (const double roughness : {0.002, 0.05}) {
    CAPTURE(roughness);
    const Region region =
        Region::from_clean_rings({test::random_blob(random, 20'000, 0, 0, 60, roughness)});
    REQUIRE_EQ(region.point_count(), 20'000u);
    for (const double depth_mm : {0.2, 1.35, -0.8}) {
      CAPTURE(depth_mm);
      const Length depth = Length::from_mm(depth_mm);
      const Region result = core::flatten(offsetter.offset(region, depth), kArcTolerance);
      CHECK_EQ(test::misjudged_points(region, depth, result, random, 200), 0);
    }
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
}

TEST_CASE("where Boost's diagram fails, and contours of metres") {
  // boostorg/polygon#43.
  const Region region = core::clean({{{0, 10'000'000},
                                      {700'000, 1},
                                      {700'000, 9'000'000},
                                      {9'100'000, 9'000'000},
                                      {9'100'000, 0},
                                      {10'000'000, 10'000'000}}},
                                    core::FillRule::kNonZero);
  REQUIRE_EQ(region.point_count(), 6u);
  std::vector<Ring> large = region.rings();
  for (Ring& ring : large) {
    for (Point& p : ring) p = {p.x * 50 - 260'000'000, p.y * 50 - 240'000'000};
  }
  Random random(1);
  PolygonOffsetter offsetter;
  for (const double depth_mm : {0.5, 10.0, 30.0, -0.5, -10.0, -100.0}) {
    CAPTURE(depth_mm);
    const Length depth = Length::from_mm(depth_mm);
    check(region, depth, offsetter.offset(region, depth), random, 2000);
    const Region fifty = Region::from_clean_rings(large);
    check(fifty, depth * 50, offsetter.offset(fifty, depth * 50), random, 2000);
  }
  CHECK_EQ(offsetter.fallbacks(), 0);
}

TEST_CASE("memory used before changes nothing") {
  PolygonOffsetter used;
  OffsetContours out[2];
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, random.integer(20, 200), 20);
    const Length depths[] = {Length::from_mm(random.between(0.1, 1)), Length::from_mm(-0.3)};
    used.offset(region, depths, out);
    for (std::size_t i = 0; i < 2; ++i) {
      const OffsetContours fresh = PolygonOffsetter().offset(region, depths[i]);
      REQUIRE_EQ(fresh.size(), out[i].size());
      for (std::size_t k = 0; k < fresh.size(); ++k) {
        REQUIRE_EQ(fresh[k].size(), out[i][k].size());
        for (std::size_t m = 0; m < fresh[k].size(); ++m) {
          CHECK_EQ(fresh[k][m].from, out[i][k][m].from);
        }
      }
    }
  }
}
