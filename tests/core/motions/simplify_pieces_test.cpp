#include "core/motions/simplify_pieces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "core/motions/arc_fit.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using namespace core;

namespace {

double laid_over_mm(const std::vector<RoadPiece>& pieces) {
  double sum = 0;
  for (const RoadPiece& piece : pieces) sum += piece.laid_over_mm;
  return sum;
}

// Largest distance of the points from the pieces, in units.
double off_units(const std::vector<Point>& points, const std::vector<RoadPiece>& pieces) {
  double worst = 0;
  for (const Point point : points) {
    double nearest = 1e18;
    Point from = points.front();
    for (const RoadPiece& piece : pieces) {
      if (from != piece.to) {
        nearest = std::min(nearest, test::distance_to_segment(point, {from, piece.to}));
      }
      from = piece.to;
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace

TEST_CASE("random wavering roads: points left out are near, length is kept, fewer pieces") {
  ArcFitter straight{Length()};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Point> points;
    for (int i = 0; i < 300; ++i) {
      points.push_back(
          {i * 400 + random.integer(0, 100),
           static_cast<std::int32_t>(20'000 * std::sin(i / 40.0)) + random.integer(-150, 150)});
    }
    const std::vector<RoadPiece> exact = straight.pieces(points, false);
    std::size_t before = exact.size();
    for (const std::int64_t tolerance : {0, 50, 125, 500}) {
      CAPTURE(tolerance);
      std::vector<RoadPiece> pieces = exact;
      simplify_pieces(points.front(), pieces, Length::from_units(tolerance));
      CHECK_LE(off_units(points, pieces), static_cast<double>(tolerance) + 1e-6);
      CHECK(laid_over_mm(pieces) == doctest::Approx(laid_over_mm(exact)).epsilon(1e-12));
      CHECK_EQ(pieces.back().to, points.back());
      CHECK_LE(pieces.size(), before);
      before = pieces.size();
    }
    CHECK_LT(before, exact.size() / 3);
  }
}

TEST_CASE("arcs stay, and straight runs between them are simplified") {
  std::vector<RoadPiece> pieces;
  const auto to = [&](Point point, bool arc) {
    RoadPiece piece;
    piece.to = point;
    piece.is_arc = arc;
    piece.length_mm = piece.laid_over_mm = 1;
    pieces.push_back(piece);
  };
  to({10'000, 0}, false);
  to({20'000, 50}, false);
  to({30'000, 0}, false);
  to({40'000, 0}, true);
  to({40'000, 10'000}, false);
  to({40'000, 20'000}, false);
  simplify_pieces({0, 0}, pieces, Length::from_units(60));
  REQUIRE_EQ(pieces.size(), 3);
  CHECK_EQ(pieces[0].to, (Point{30'000, 0}));
  CHECK_EQ(pieces[0].laid_over_mm, 3);
  CHECK(pieces[0].length_mm == doctest::Approx(3));
  CHECK(pieces[1].is_arc);
  CHECK_EQ(pieces[2].to, (Point{40'000, 20'000}));
  CHECK_EQ(pieces[2].laid_over_mm, 2);
}
