// Arcs against the polylines that they stand for, by brute force.
#include "core/motions/arc_fit.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/road_path.h"

using namespace core;
using test::Path;
using test::PathPoint;
using test::Random;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 100;  // units
const Length kTenMicrons = Length::from_units(100);

Point unit_point(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}

PathPoint path_point(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

// Points on a circle in units, from one angle to another.
std::vector<Point> on_circle(double radius, double from, double to, int segments,
                             Point centre = {3'000, -4'000}) {
  std::vector<Point> points;
  for (int i = 0; i <= segments; ++i) {
    const double angle = from + (to - from) * i / segments;
    points.push_back(
        unit_point(centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)));
  }
  return points;
}

std::size_t arcs_in(const std::vector<RoadPiece>& pieces) {
  return static_cast<std::size_t>(std::count_if(
      pieces.begin(), pieces.end(), [](const RoadPiece& piece) { return piece.is_arc; }));
}

// Everything that arc_fit.h promises about the pieces of one way.
void check_pieces(const std::vector<Point>& points, bool closed) {
  ArcFitter fitter(kTenMicrons);
  const std::vector<RoadPiece> pieces = fitter.pieces(points, closed);
  Path way, polyline;
  for (const Point point : points) polyline.push_back(path_point(point));
  if (closed) polyline.push_back(polyline.front());
  way.push_back(polyline.front());
  double laid_over_mm = 0;
  std::size_t begin = 0;  // of the piece, among the polyline's points
  for (const RoadPiece& piece : pieces) {
    const std::size_t from = way.size() - 1;
    const std::size_t first = begin;
    while (begin + 1 < polyline.size() && polyline[++begin] != path_point(piece.to)) {
    }
    REQUIRE(polyline[begin] == path_point(piece.to));
    laid_over_mm += piece.laid_over_mm;
    if (!piece.is_arc) {
      way.push_back(path_point(piece.to));
      CHECK(piece.length_mm == piece.laid_over_mm);
      continue;
    }
    // A sampled arc's own chords are off it by step² / 8 r.
    const double step = piece.length_mm * kUnitsPerMm / 400;
    const double radius = distance_mm(piece.centre, piece.to) * kUnitsPerMm;
    const double sampled = step * step / (8 * radius);
    test::add_arc(way[from], path_point(piece.to), path_point(piece.centre), piece.clockwise, step,
                  way);
    const Path arc(way.begin() + static_cast<std::ptrdiff_t>(from), way.end());
    const Path run(polyline.begin() + static_cast<std::ptrdiff_t>(first),
                   polyline.begin() + static_cast<std::ptrdiff_t>(begin) + 1);
    REQUIRE(test::farthest_off(arc, run, step) <= kTolerance + sampled);
    REQUIRE(test::farthest_off(run, arc, step) <= kTolerance + sampled);
    const double radius_mm = radius / kUnitsPerMm;
    CHECK(radius_mm >= kArcRadiusMin_mm * 0.999);
    CHECK(radius_mm <= kArcRadiusMax_mm * 1.001);
    CHECK(piece.length_mm >= kArcLengthMin_mm);
    CHECK(piece.length_mm <= radius_mm * kArcSweepMax_degrees / 180 * kPi * 1.001);
    double length = 0;
    for (std::size_t i = 1; i < arc.size(); ++i) {
      length += std::hypot(arc[i][0] - arc[i - 1][0], arc[i][1] - arc[i - 1][1]);
    }
    CHECK(piece.length_mm == doctest::Approx(length / kUnitsPerMm).epsilon(0.01));
  }
  CHECK(way.back() == polyline.back());
  CHECK(laid_over_mm == doctest::Approx(length_mm(points, closed)));

  // The other way round, the same pieces.
  std::vector<Point> reversed(points.rbegin(), points.rend());
  if (closed) std::rotate(reversed.begin(), reversed.end() - 1, reversed.end());
  const std::vector<RoadPiece> back = fitter.pieces(reversed, closed);
  REQUIRE(back.size() == pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const RoadPiece& there = pieces[pieces.size() - 1 - i];
    REQUIRE(back[i].is_arc == there.is_arc);
    if (back[i].is_arc) REQUIRE(back[i].centre == there.centre);
    if (back[i].is_arc) REQUIRE(back[i].clockwise != there.clockwise);
  }
}

// Straight stretches, arcs and noise in turn: what roads are made of, and worse.
std::vector<Point> random_way(Random& random) {
  std::vector<Point> points;
  double x = random.between(-1e5, 1e5), y = random.between(-1e5, 1e5);
  double direction = random.between(0, 2 * kPi);
  const double noise = random.integer(0, 2) == 0 ? random.between(0, 150) : 0;
  points.push_back(unit_point(x, y));
  for (int stretch = random.integer(1, 6); stretch > 0; --stretch) {
    const int kind = random.integer(0, 2);
    const int segments = random.integer(1, 40);
    const double step = random.between(5, 8'000);
    const double turn = kind == 0 ? 0 : random.between(-0.3, 0.3);
    for (int i = 0; i < segments; ++i) {
      x += step * std::cos(direction) + random.between(-noise, noise);
      y += step * std::sin(direction) + random.between(-noise, noise);
      points.push_back(unit_point(x, y));
      direction += kind == 2 ? random.between(-1, 1) * turn * 3 : turn;
    }
    direction += random.between(-2, 2);
  }
  return points;
}

}  // namespace

TEST_CASE("a circle is two arcs, whatever its size and wherever its seam") {
  for (const double radius : {1'500.0, 20'000.0, 500'000.0}) {
    for (const double seam : {0.0, 0.7, 3.0, 5.5}) {
      CAPTURE(radius);
      CAPTURE(seam);
      // Chords off the circle by 2.5 µm.
      const int segments = static_cast<int>(std::ceil(kPi / std::acos(1 - 25 / radius)));
      std::vector<Point> ring = on_circle(radius, seam, seam + 2 * kPi, segments);
      ring.pop_back();
      ArcFitter fitter(kTenMicrons);
      const std::vector<RoadPiece>& pieces = fitter.pieces(ring, true);
      CHECK(arcs_in(pieces) == 2);
      CHECK(pieces.size() == 2);
      for (const RoadPiece& piece : pieces) {
        CHECK_FALSE(piece.clockwise);
        CHECK(distance_mm(piece.centre, {3'000, -4'000}) < 0.005);
      }
      check_pieces(ring, true);
    }
  }
}

TEST_CASE("what has corners has no arcs: squares, zigzags, polygons that are coarse") {
  ArcFitter fitter(kTenMicrons);
  const auto none = [&fitter](const std::vector<Point>& points, bool closed) {
    const std::vector<RoadPiece>& pieces = fitter.pieces(points, closed);
    CHECK(arcs_in(pieces) == 0);
    CHECK(pieces.size() == points.size() - (closed ? 0 : 1));
  };
  none({{0, 0}, {100'000, 0}, {100'000, 100'000}, {0, 100'000}}, true);
  none({{0, 0}, {300, 0}, {300, 300}, {0, 300}}, true);
  std::vector<Point> zigzag, shallow;
  for (int i = 0; i < 100; ++i) {
    zigzag.push_back({i * 5'000, i % 2 * 50'000});
    shallow.push_back({i * 5'000, i % 2 * 90});
  }
  none(zigzag, false);
  none(shallow, false);
  // 64 corners at 20 mm: the facets are 24 µm off the circle, and meant.
  std::vector<Point> polygon = on_circle(200'000, 0, 2 * kPi, 64);
  polygon.pop_back();
  none(polygon, true);
  none({{0, 0}, {10, 0}}, false);
}

TEST_CASE("a rounded corner is an arc between two straight lines") {
  std::vector<Point> points = {{-300'000, 20'000}};
  for (const Point p : on_circle(20'000, kPi / 2, 0, 12, {0, 0})) points.push_back(p);
  points.push_back({20'000, -300'000});
  ArcFitter fitter(kTenMicrons);
  const std::vector<RoadPiece> pieces = fitter.pieces(points, false);
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[1].is_arc);
  CHECK(pieces[1].clockwise);
  CHECK(pieces[1].length_mm == doctest::Approx(kPi).epsilon(1e-4));
  CHECK(pieces[0].to == Point{0, 20'000});
  CHECK(pieces[1].to == Point{20'000, 0});
}

TEST_CASE("no tolerance, no arcs") {
  ArcFitter fitter{Length()};
  CHECK(arcs_in(fitter.pieces(on_circle(50'000, 0, 3, 200), false)) == 0);
}

TEST_CASE("points that are repeated are left out") {
  std::vector<Point> points = on_circle(50'000, 0, 2, 60);
  points.insert(points.begin() + 20, points[20]);
  points.push_back(points.back());
  ArcFitter fitter(kTenMicrons);
  const std::vector<RoadPiece>& pieces = fitter.pieces(points, false);
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0].is_arc);
  CHECK(fitter.pieces({{5, 5}, {5, 5}}, false).empty());
}

TEST_CASE("ways of every kind stay within the tolerance, and are the same both ways round") {
  std::size_t arcs = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const std::vector<Point> points = random_way(random);
    const bool closed = points.size() > 3 && random.integer(0, 1) == 0;
    check_pieces(points, closed);
    ArcFitter fitter(kTenMicrons);
    arcs += arcs_in(fitter.pieces(points, closed));
  }
  CHECK(arcs > 400);
}
