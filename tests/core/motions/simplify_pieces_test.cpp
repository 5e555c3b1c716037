#include "core/motions/simplify_pieces.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
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

TEST_CASE("a corner that is cut by less than the tolerance is one point, and near the way") {
  ArcFitter straight{Length()};
  // A turn of 30° by an arc of 0.225 mm: its corner is 8 µm away from it.
  std::vector<Point> points = {{0, 0}};
  for (int i = 0; i <= 4; ++i) {
    const double angle = i * 7.5 * std::numbers::pi / 180;
    points.push_back({100'000 + static_cast<std::int32_t>(std::lround(2'250 * std::sin(angle))),
                      static_cast<std::int32_t>(std::lround(2'250 * (1 - std::cos(angle))))});
  }
  points.push_back({points.back().x + 86'603, points.back().y + 50'000});
  const std::vector<RoadPiece> exact = straight.pieces(points, false);
  for (const std::int64_t tolerance : {60, 125}) {
    CAPTURE(tolerance);
    std::vector<RoadPiece> pieces = exact;
    simplify_pieces(points.front(), pieces, Length::from_units(tolerance));
    CHECK_EQ(pieces.size(), tolerance == 125 ? 2 : 3);
    CHECK_EQ(laid_over_mm(pieces), doctest::Approx(laid_over_mm(exact)));
    CHECK_LE(off_units(points, pieces), static_cast<double>(tolerance));
    for (const RoadPiece& piece : pieces) {
      double off = 1e18;
      for (std::size_t i = 1; i < points.size(); ++i) {
        off = std::min(off, test::distance_to_segment(piece.to, {points[i - 1], points[i]}));
      }
      CHECK_LE(off, static_cast<double>(tolerance));
    }
  }
}

TEST_CASE("lines that meet farther away than any part reaches have no corner") {
  const std::vector<Point> points = {{0, 0}, {100'000, 0}, {100'010, -3'000}, {1'100'010, -2'999}};
  std::vector<RoadPiece> pieces = ArcFitter(Length()).pieces(points, false);
  simplify_pieces(points.front(), pieces, Length::from_units(60));
  REQUIRE_EQ(pieces.size(), 3);
  for (std::size_t i = 0; i < pieces.size(); ++i) CHECK_EQ(pieces[i].to, points[i + 1]);
}

TEST_CASE("a short edge between two long ones becomes the corner where these meet") {
  const std::vector<Point> points = {{0, 0}, {100'000, 0}, {100'170, 70}, {200'170, 100'070}};
  std::vector<RoadPiece> pieces = ArcFitter(Length()).pieces(points, false);
  simplify_pieces(points.front(), pieces, Length::from_units(60));
  REQUIRE_EQ(pieces.size(), 2);
  CHECK_EQ(pieces[0].to, (Point{100'100, 0}));
  CHECK_EQ(pieces[1].to, points.back());
}

TEST_CASE("what a corner stands for is laid before and behind it by how far it is from both ends") {
  const std::vector<Point> points = {{0, 0}, {1'000, 0}, {1'300, 100}, {3'300, 1'100}};
  const std::vector<RoadPiece> exact = ArcFitter(Length()).pieces(points, false);
  std::vector<RoadPiece> pieces = exact;
  simplify_pieces(points.front(), pieces, Length::from_units(35));
  REQUIRE_EQ(pieces.size(), 2);
  CHECK_EQ(pieces[0].to, (Point{1'100, 0}));
  CHECK_EQ(laid_over_mm(pieces), doctest::Approx(laid_over_mm(exact)));
  for (const RoadPiece& piece : pieces) {
    CHECK_EQ(piece.laid_over_mm / piece.length_mm, doctest::Approx(1).epsilon(0.01));
  }
}
