#include "core/roads/line_clip.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

double length_within_mm(const Region& region, const std::vector<Point>& line, int parts) {
  double mm = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    for (int part = 0; part < parts; ++part) {
      const Point middle = between(line[i - 1], line[i], (part + 0.5) / parts);
      if (region.contains(middle)) mm += distance_mm(line[i - 1], line[i]) / parts;
    }
  }
  return mm;
}

// Where the place says that it is.
Point at(const Region& region, const BoundaryPlace& place) {
  const Ring& ring = region.rings()[place.ring];
  double left = place.along;
  for (std::size_t i = 0; true; i = (i + 1) % ring.size()) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double length = distance_units(a, b);
    if (left <= length) return between(a, b, left / length);
    left -= length;
  }
}

}  // namespace

TEST_CASE("a line over a square with a hole has two pieces, and knows where they end") {
  const Region region = test::region_from_text("0:0 20:0 20:20 0:20, 5:5 5:15 15:15 15:5");
  std::vector<ClippedLine> pieces;
  LineClipper(region).clip({{-10'000, 100'000}, {300'000, 100'000}}, pieces);
  REQUIRE_EQ(pieces.size(), 2);
  CHECK_EQ(pieces[0].points, (std::vector<Point>{{0, 100'000}, {50'000, 100'000}}));
  CHECK_EQ(pieces[1].points, (std::vector<Point>{{150'000, 100'000}, {200'000, 100'000}}));
  CHECK_EQ(pieces[0].from.ring, pieces[1].to.ring);
  CHECK_EQ(pieces[0].to.ring, pieces[1].from.ring);
  CHECK_NE(pieces[0].from.ring, pieces[0].to.ring);
}

TEST_CASE("a line along an edge and over corners has whole pieces") {
  const Region region = test::region_from_text("0:0 20:0 20:20 0:20");
  const LineClipper clipper(region);
  for (const std::int32_t y : {0, 200'000}) {
    std::vector<ClippedLine> pieces;
    clipper.clip({{-10'000, y}, {300'000, y}}, pieces);
    CHECK_LE(pieces.size(), 1);
  }
  std::vector<ClippedLine> diagonal;
  clipper.clip({{-50'000, -50'000}, {50'000, 50'000}, {250'000, 250'000}}, diagonal);
  REQUIRE_EQ(diagonal.size(), 1);
  CHECK_EQ(diagonal[0].points, (std::vector<Point>{{0, 0}, {50'000, 50'000}, {200'000, 200'000}}));
}

TEST_CASE("random lines and regions: what is inside is what sampling finds inside") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 60, 20);
    if (region.empty()) continue;
    const Box box = region.box();
    std::vector<Point> line = {{box.min.x - 20'000, random.integer(box.min.y, box.max.y)}};
    for (int i = 0; i < 8; ++i) {
      line.push_back({random.integer(box.min.x, box.max.x), random.integer(box.min.y, box.max.y)});
    }
    line.push_back({box.max.x + 20'000, random.integer(box.min.y, box.max.y)});
    std::vector<ClippedLine> pieces;
    const LineClipper clipper(region);
    clipper.clip(line, pieces);
    double mm = 0;
    for (const ClippedLine& piece : pieces) {
      REQUIRE_GE(piece.points.size(), 2);
      mm += length_mm(piece.points, false);
      CHECK_LE(distance_units(piece.points.front(), at(region, piece.from)), 3);
      CHECK_LE(distance_units(piece.points.back(), at(region, piece.to)), 3);
      for (std::size_t i = 1; i < piece.points.size(); ++i) {
        const Point middle = between(piece.points[i - 1], piece.points[i], 0.5);
        CHECK_GT(test::signed_distance(region, middle.x, middle.y), -2);
      }
    }
    CHECK(mm == doctest::Approx(length_within_mm(region, line, 2'000)).epsilon(0.01));
  }
}

TEST_CASE("the way along a ring: forwards and backwards it is the whole ring") {
  const Region region = test::region_from_text("0:0 20:0 20:20 0:20");
  const LineClipper clipper(region);
  const BoundaryPlace a{0, 50'000}, b{0, 450'000};
  std::vector<Point> forwards, backwards, round;
  clipper.append_way(a, b, true, forwards);
  clipper.append_way(a, b, false, backwards);
  CHECK_EQ(forwards.size() + backwards.size(), 4);
  CHECK_EQ(forwards.size(), 2);
  std::reverse(backwards.begin(), backwards.end());
  clipper.append_way(b, a, true, round);
  CHECK_EQ(round, backwards);
  std::vector<Point> same_edge;
  clipper.append_way({0, 10'000}, {0, 20'000}, true, same_edge);
  CHECK(same_edge.empty());
  clipper.append_way({0, 20'000}, {0, 10'000}, true, same_edge);
  CHECK_EQ(same_edge.size(), 4);
}

TEST_CASE("the first crossing of a short way") {
  const Region region = test::region_from_text("0:0 20:0 20:20 0:20");
  const LineClipper clipper(region);
  CHECK(clipper.first_crossing({190'000, 50'000}, {230'000, 50'000}) == doctest::Approx(0.25));
  CHECK_GT(clipper.first_crossing({10'000, 50'000}, {30'000, 50'000}), 1);
}
