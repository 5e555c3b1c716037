// Roads within an area equal those of all of the inside filled so, but near the border; pieces
// cover the inside once; borders leave no gap.
#include "core/roads/inside_fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/regions/polyline.h"
#include "core/roads/loose_fill.h"

using core::ChangedAreas;
using core::Length;
using core::LoosePattern;
using core::Point;
using core::Region;
using core::Road;
using core::Settings;
using core::Slice;

namespace {

Region square(double x0, double y0, double x1, double y1) {
  const auto at = [](double x, double y) {
    return Point{static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
                 static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
  };
  return core::clean({{at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}}, core::FillRule::kPositive);
}

Slice slice_with(ChangedAreas areas, core::LayerIndex index = 4) {
  Slice slice;
  slice.index = index;
  slice.height = Length::from_mm(0.2);
  slice.bottom = slice.height * index;
  slice.areas = std::make_shared<const ChangedAreas>(std::move(areas));
  return slice;
}

// Length of the roads within a box, in mm, by stepping along them.
double length_within(const std::vector<Road>& roads, double x0, double y0, double x1, double y1) {
  constexpr double kStep = 0.01;
  double sum = 0;
  for (const Road& road : roads) {
    const std::size_t n = road.points.size();
    for (std::size_t i = 0; i + (road.closed ? 0 : 1) < n; ++i) {
      const Point a = road.points[i], b = road.points[(i + 1) % n];
      const double length = core::distance_units(a, b) / core::kUnitsPerMm;
      const int steps = std::max(1, static_cast<int>(length / kStep));
      for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        const double x = (a.x + t * (b.x - a.x)) / core::kUnitsPerMm;
        const double y = (a.y + t * (b.y - a.y)) / core::kUnitsPerMm;
        if (x > x0 && x < x1 && y > y0 && y < y1) sum += length / steps;
      }
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("an area of half a box is filled as the box would be, but for its border") {
  const Region inside = square(0, 0, 60, 40);
  for (const LoosePattern pattern : {LoosePattern::kLines, LoosePattern::kGrid,
                                     LoosePattern::kHoneycomb, LoosePattern::kGyroid}) {
    CAPTURE(static_cast<int>(pattern));
    // Joins are part of what is asked for, and rows are farther apart for them: none here.
    Settings settings;
    settings.infill_anchor_max = Length();
    Settings other = settings;
    other.loose_density = 0.5;
    other.loose_pattern = pattern;
    const Slice slice = slice_with({{{0.5, pattern}, square(30, -5, 70, 45)}});
    const std::vector<Road> roads = core::inside_fill(inside, inside, slice, settings);
    const std::vector<Road> whole = core::loose_roads(inside, inside, slice, other);
    const std::vector<Road> plain = core::loose_roads(inside, inside, slice, settings);
    // Away from joins along the edges.
    CHECK(length_within(roads, 33, 3, 57, 37) ==
          doctest::Approx(length_within(whole, 33, 3, 57, 37)).epsilon(0.06));
    CHECK(length_within(roads, 3, 3, 27, 37) ==
          doctest::Approx(length_within(plain, 3, 3, 27, 37)).epsilon(0.06));
    // No road of one side reaches half a road beyond the border.
    for (const Road& road : roads) {
      const auto [low, high] =
          std::minmax_element(road.points.begin(), road.points.end(),
                              [](const Point& a, const Point& b) { return a.x < b.x; });
      const bool left = low->x < 29.5 * core::kUnitsPerMm;
      const bool right = high->x > 30.5 * core::kUnitsPerMm;
      CHECK_FALSE((left && right));
    }
  }
}

TEST_CASE("with joins, each side gets the volume that it asks for") {
  const Region inside = square(0, 0, 60, 40);
  const Settings settings;
  const Slice slice = slice_with({{{0.5, {}}, square(30, -5, 70, 45)}});
  double left = 0, right = 0;
  for (const Road& road : core::inside_fill(inside, inside, slice, settings)) {
    double length = core::length_mm(road.points, road.closed);
    length *= core::bead_area_mm2(road.width, slice.height);
    (road.points.front().x < 30 * core::kUnitsPerMm ? left : right) += length;
  }
  CHECK(left == doctest::Approx(0.2 * 1'200 * 0.2).epsilon(0.06));
  CHECK(right == doctest::Approx(0.5 * 1'200 * 0.2).epsilon(0.06));
}

TEST_CASE("random boxes: pieces are the inside together, once, and lay what is asked for") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Region inside = square(0, 0, between(8, 60), between(8, 60));
    ChangedAreas areas;
    for (std::size_t i = 0, count = 1 + random() % 3; i < count; ++i) {
      const double x = between(-10, 50), y = between(-10, 50);
      areas.push_back({{between(0.05, 1), std::nullopt},
                       square(x, y, x + between(0.1, 40), y + between(0.1, 40))});
    }
    const Settings settings;
    const Slice slice = slice_with(areas);
    const std::vector<core::InsidePiece> pieces = core::inside_pieces(inside, slice, settings);
    double sum = 0;
    Region all;
    for (const core::InsidePiece& piece : pieces) {
      sum += piece.region.area_mm2();
      all = core::unite(all, piece.region);
    }
    CHECK(sum == doctest::Approx(inside.area_mm2()).epsilon(1e-4));
    CHECK(all.area_mm2() == doctest::Approx(inside.area_mm2()).epsilon(1e-4));
    // The last area holds wherever it is wider than a road.
    const Region last = core::intersect(inside, areas.back().region);
    if (!pieces.empty() && last.area_mm2() > 0) {
      for (const core::InsidePiece& piece : pieces) {
        if (piece.settings.loose_density == *areas.back().change.density) continue;
        const core::Box box = core::intersect(piece.region, last).box();
        if (box.empty()) continue;
        const double road = settings.road_width.mm() * 1.01;
        const double wide =
            std::min(box.max.x - box.min.x, box.max.y - box.min.y) / core::kUnitsPerMm;
        CHECK(wide < road);
      }
    }
    const std::vector<Road> roads = core::inside_fill(inside, inside, slice, settings);
    CHECK_FALSE(roads.empty());
    for (const Road& road : roads) {
      for (const Point p : road.points) {
        CHECK(inside.box().min.x <= p.x);
        CHECK(p.x <= inside.box().max.x);
      }
    }
  }
}

TEST_CASE("an area that covers all, and one that covers nothing") {
  const Region inside = square(0, 0, 30, 20);
  Settings settings, dense;
  dense.loose_density = 0.7;
  const auto same = [](const std::vector<Road>& a, const std::vector<Road>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Road& r, const Road& s) {
      return r.points == s.points && r.width == s.width;
    });
  };
  const Slice all = slice_with({{{0.7, {}}, square(-9, -9, 99, 99)}});
  CHECK(same(core::inside_fill(inside, inside, all, settings),
             core::loose_roads(inside, inside, all, dense)));
  const Slice none = slice_with({{{0.7, {}}, square(50, 50, 99, 99)}});
  CHECK(same(core::inside_fill(inside, inside, none, settings),
             core::loose_roads(inside, inside, none, settings)));
  core::AreaChange slow;
  slow.value(core::LaidValue::kLooseSpeed) = 20;
  for (const core::AreaChange& change : {core::AreaChange{settings.loose_density, {}}, slow}) {
    const Slice alike = slice_with({{change, square(10, 5, 20, 15)}});
    CHECK(same(core::inside_fill(inside, inside, alike, settings),
               core::loose_roads(inside, inside, alike, settings)));
  }
  // A later area that leaves the density as it is does not end the one below it.
  core::AreaChange gyroid;
  gyroid.pattern = LoosePattern::kGyroid;
  dense.loose_pattern = LoosePattern::kGyroid;
  const Slice both =
      slice_with({{{0.7, {}}, square(-9, -9, 99, 99)}, {gyroid, square(-9, -9, 99, 99)}});
  CHECK(same(core::inside_fill(inside, inside, both, settings),
             core::loose_roads(inside, inside, both, dense)));
  const Slice empty = slice_with({{{0.0, {}}, square(-9, -9, 99, 99)}});
  CHECK(core::inside_fill(inside, inside, empty, settings).empty());
}
