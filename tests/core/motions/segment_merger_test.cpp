// Short pieces merged, and roads laid slower, for a line that is slow.
#include "core/motions/segment_merger.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/road_path.h"

using namespace core;
using test::Path;
using test::Random;

namespace {

std::vector<RoadPiece> pieces_of(const std::vector<Point>& points) {
  std::vector<RoadPiece> pieces;
  for (std::size_t i = 1; i < points.size(); ++i) {
    RoadPiece piece;
    piece.to = points[i];
    piece.length_mm = piece.laid_over_mm = distance_mm(points[i - 1], points[i]);
    if (piece.length_mm > 0) pieces.push_back(piece);
  }
  return pieces;
}

Path path_of(Point from, const std::vector<RoadPiece>& pieces) {
  Path path = {{static_cast<double>(from.x), static_cast<double>(from.y)}};
  for (const RoadPiece& piece : pieces) {
    path.push_back({static_cast<double>(piece.to.x), static_cast<double>(piece.to.y)});
  }
  return path;
}

double laid_over_mm(const std::vector<RoadPiece>& pieces) {
  double sum = 0;
  for (const RoadPiece& piece : pieces) sum += piece.laid_over_mm;
  return sum;
}

}  // namespace

TEST_CASE("short pieces in a line become one, long ones and arcs stay") {
  std::vector<Point> points;
  for (int i = 0; i <= 40; ++i) points.push_back({i * 500, i % 2 * 20});
  points.push_back({60'000, 0});
  std::vector<RoadPiece> pieces = pieces_of(points);
  RoadPiece arc;
  arc.is_arc = true;
  arc.to = {60'000, 20'000};
  arc.length_mm = arc.laid_over_mm = 3.14;
  pieces.push_back(arc);
  const double before_mm = laid_over_mm(pieces);
  merge_short_pieces(points.front(), pieces, 0.2, 0.01);
  CHECK(pieces.size() == 12);  // ten of 0.2 mm each, the long one, the arc
  CHECK(pieces[10].to == Point{60'000, 0});
  CHECK(pieces[11].is_arc);
  CHECK(laid_over_mm(pieces) == doctest::Approx(before_mm));
}

TEST_CASE("no point that is left out is farther off than the tolerance") {
  std::size_t saved = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<Point> points = {{0, 0}};
    double direction = 0;
    for (int i = random.integer(1, 200); i > 0; --i) {
      direction += random.between(-0.5, 0.5);
      const double step = random.between(0, 600);
      points.push_back(
          {points.back().x + static_cast<std::int32_t>(std::lround(step * std::cos(direction))),
           points.back().y + static_cast<std::int32_t>(std::lround(step * std::sin(direction)))});
    }
    std::vector<RoadPiece> pieces = pieces_of(points);
    const Path before = path_of(points.front(), pieces);
    const double before_mm = laid_over_mm(pieces);
    const std::size_t count = pieces.size();
    merge_short_pieces(points.front(), pieces, random.between(0.02, 0.5), 0.01);
    saved += count - pieces.size();
    const Path after = path_of(points.front(), pieces);
    REQUIRE(test::farthest_off(before, after, 20) <= 100.001);
    REQUIRE(test::farthest_off(after, before, 20) <= 100.001);
    CHECK(after.back() == before.back());
    CHECK(laid_over_mm(pieces) == doctest::Approx(before_mm));
  }
  CHECK(saved > 3'000);
}

TEST_CASE("a road is laid as slow as its busiest stretch needs, and no slower") {
  std::vector<Point> points = {{0, 0}};
  for (int i = 0; i < 40; ++i) points.push_back({points.back().x + 20'000, i % 2 * 20'000});
  for (int i = 0; i < 40; ++i) points.push_back({points.back().x + 1'000, i % 2 * 1'000});
  const std::vector<RoadPiece> pieces = pieces_of(points);
  // Sixteen short ones in a row, 0.141 mm each in 2 ms each, at most.
  CHECK(sendable_speed(pieces, 100, 0.002) == doctest::Approx(std::sqrt(2) * 0.1 / 0.002));
  CHECK(sendable_speed(pieces, 60, 0.002) == 60);
  // Fewer than a planner holds: they wait there.
  const std::vector<RoadPiece> few(pieces.end() - 10, pieces.end());
  CHECK(sendable_speed(few, 100, 0.002) == 100);
}
