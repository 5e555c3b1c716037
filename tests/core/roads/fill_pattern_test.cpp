// All patterns of the loose inside: length on the area, bounds, the same plane for any box.
#include "core/roads/fill_pattern.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/regions/polyline.h"
#include "core/roads/gyroid_pattern.h"
#include "core/roads/honeycomb_pattern.h"
#include "core/roads/line_clip.h"
#include "core/roads/loose_fill.h"
#include "core/roads/straight_pattern.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using namespace core;

namespace {

struct Named {
  std::string name;
  std::unique_ptr<FillPattern> pattern;
};

std::vector<Named> patterns() {
  std::vector<Named> all;
  using Kind = StraightPattern::Kind;
  all.push_back({"lines", std::make_unique<StraightPattern>(Kind::kLines)});
  all.push_back({"grid", std::make_unique<StraightPattern>(Kind::kGrid)});
  all.push_back({"triangles", std::make_unique<StraightPattern>(Kind::kTriangles)});
  all.push_back({"cubic", std::make_unique<StraightPattern>(Kind::kCubic)});
  all.push_back({"honeycomb", std::make_unique<HoneycombPattern>()});
  all.push_back({"gyroid", std::make_unique<GyroidPattern>()});
  return all;
}

PatternPlace place_at(const Region& region, double height_mm) {
  return {region.box(), 20'000, 1'000, 30, 0, Length::from_mm(height_mm)};
}

double length_in_mm(const Region& region, const PatternLines& lines) {
  const LineClipper clipper(region);
  std::vector<ClippedLine> pieces;
  for (const std::vector<Point>& line : lines) clipper.clip(line, pieces);
  double mm = 0;
  for (const ClippedLine& piece : pieces) mm += length_mm(piece.points, false);
  return mm;
}

}  // namespace

TEST_CASE("a layer has its length on the area, in the mean over heights; lines end outside") {
  const Region square = test::region_from_text("3:5 103:5 103:105 3:105");
  const Box box = square.box();
  for (const Named& named : patterns()) {
    CAPTURE(named.name);
    double sum_mm = 0;
    constexpr int kHeights = 24;
    for (int i = 0; i < kHeights; ++i) {
      const PatternLines lines = named.pattern->lines(place_at(square, 0.1 + 0.2 * i));
      sum_mm += length_in_mm(square, lines);
      for (const std::vector<Point>& line : lines) {
        REQUIRE_GE(line.size(), 2);
        CHECK_FALSE(box.overlaps({line.front(), line.front()}));
        CHECK_FALSE(box.overlaps({line.back(), line.back()}));
      }
    }
    // 10,000 mm² at 2 mm.
    CHECK(sum_mm / kHeights == doctest::Approx(5'000).epsilon(0.03));
  }
}

TEST_CASE("what two boxes share has the same lines") {
  const Region small = test::region_from_text("21:22 39:22 39:41 21:41");
  const Region large = test::region_from_text("-5:3 90:3 90:70 -5:70");
  for (const Named& named : patterns()) {
    CAPTURE(named.name);
    const double of_small = length_in_mm(small, named.pattern->lines(place_at(small, 1.3)));
    const double of_large = length_in_mm(small, named.pattern->lines(place_at(large, 1.3)));
    CHECK(of_small == doctest::Approx(of_large).epsilon(1e-3));
  }
}

TEST_CASE("the gyroid's lines lie on its sheet") {
  const Region square = test::region_from_text("0:0 20:0 20:20 0:20");
  const GyroidPattern gyroid;
  const double cell = 2.44 * 20'000;
  for (const double height_mm : {0.1, 0.9, 1.7, 2.5, 3.3, 4.1}) {
    CAPTURE(height_mm);
    PatternPlace place = place_at(square, height_mm);
    place.angle_degrees = 0;
    const double z = height_mm * 10'000 / cell * 2 * 3.14159265358979;
    for (const std::vector<Point>& line : gyroid.lines(place)) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const double x = line[i].x / cell * 2 * 3.14159265358979;
        const double y = line[i].y / cell * 2 * 3.14159265358979;
        CHECK(std::abs(std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) +
                       std::sin(z) * std::cos(x)) < 1e-3);
        if (i > 0) CHECK_LT(distance_units(line[i - 1], line[i]), cell / 8);
      }
    }
  }
}

TEST_CASE("loose fill with any pattern lays what was asked for, inside, in few roads") {
  Slice slice;
  slice.index = 6;
  slice.height = Length::from_mm(0.2);
  slice.bottom = Length::from_mm(1.2);
  const Region inside = test::region_from_text("0:0 60:0 60:40 0:40, 20:15 20:25 30:25 30:15");
  const Region room = test::region_from_text("-1:-1 61:-1 61:41 -1:41");
  for (int number = 0; number <= static_cast<int>(LoosePattern::kConcentric); ++number) {
    CAPTURE(number);
    Settings settings;
    settings.loose_pattern = static_cast<LoosePattern>(number);
    for (const double density : {0.1, 0.2, 0.4}) {
      CAPTURE(density);
      settings.loose_density = density;
      const auto roads = loose_roads(inside, room, slice, settings);
      CHECK(test::laid_mm2(roads, slice.height) / inside.area_mm2() ==
            doctest::Approx(density).epsilon(0.02));
      CHECK_GT(test::least_depth_mm(room, roads), 0);
      CHECK_LT(roads.size(), 80);
    }
  }
}
