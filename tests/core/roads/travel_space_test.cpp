// Ways within an island, against a raster of it: what its cells connect, a way connects.
#include "core/roads/travel_space.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "core/regions/polyline.h"
#include "core/regions/segment_grid.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using namespace core;

namespace {

constexpr Length kWidth = Length::from_units(4'500);
constexpr std::int32_t kCell = 1'000;

Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * kUnitsPerMm))};
}

// Pieces of what lies at some depth, by cells of 0.1 mm that share an edge.
class Raster {
 public:
  Raster(const Region& region, const SegmentGrid& contours, Length depth) : box_(region.box()) {
    columns_ = (box_.max.x - box_.min.x) / kCell + 1;
    const int rows = (box_.max.y - box_.min.y) / kCell + 1;
    piece_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows));
    std::iota(piece_.begin(), piece_.end(), 0);
    inside_.resize(piece_.size());
    for (int i = 0; i < columns_ * rows; ++i) {
      const Point middle{box_.min.x + i % columns_ * kCell + kCell / 2,
                         box_.min.y + i / columns_ * kCell + kCell / 2};
      inside_[static_cast<std::size_t>(i)] =
          !contours.any_within(middle, depth) && region.contains(middle);
      if (i % columns_ > 0) join(i, i - 1);
      if (i >= columns_) join(i, i - columns_);
    }
  }

  // Negative: not at that depth.
  [[nodiscard]] int piece_at(Point point) {
    const int i = (point.y - box_.min.y) / kCell * columns_ + (point.x - box_.min.x) / kCell;
    return inside_[static_cast<std::size_t>(i)] ? root(i) : -1;
  }

 private:
  int root(int i) {
    int& next = piece_[static_cast<std::size_t>(i)];
    return next == i ? i : next = root(next);
  }
  void join(int a, int b) {
    if (!inside_[static_cast<std::size_t>(a)] || !inside_[static_cast<std::size_t>(b)]) return;
    piece_[static_cast<std::size_t>(root(a))] = root(b);
  }

  Box box_;
  int columns_ = 0;
  std::vector<int> piece_;
  std::vector<bool> inside_;
};

// Whether every point of the way, sampled, lies in the region, this far from its contours.
bool stays_within(const std::vector<Point>& way, const Region& region, const SegmentGrid& contours,
                  Length depth) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const int steps = static_cast<int>(distance_mm(way[i - 1], way[i]) / 0.05) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Point at = between(way[i - 1], way[i], static_cast<double>(k) / steps);
      if (contours.any_within(at, depth) || !region.contains(at)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("a way goes around a hole on its shorter side, and no farther than it has to") {
  const Region plate = test::region_from_text("0:0 40:0 40:30 0:30, 10:5 10:20 30:20 30:5");
  const TravelSpace space(plate, kWidth, Length());
  const std::vector<Point> way = space.way(at_mm(5, 12), at_mm(35, 12));
  // Beside the hole's lower corners, one road off.
  const double least_mm = 2 * std::hypot(5.0, 7.0) + 20;
  CHECK(length_mm(way, false) > least_mm);
  CHECK(length_mm(way, false) < least_mm + 3);
  CHECK(stays_within(way, plate, SegmentGrid(Length::from_mm(1), plate), Length::from_mm(0.17)));
  // Straight where nothing is in the way.
  CHECK_EQ(space.way(at_mm(5, 25), at_mm(35, 25)).size(), 2);
}

TEST_CASE("a way that is too long is straight, and one between islands or from outside") {
  const Region two =
      test::region_from_text("0:0 40:0 40:30 0:30, 10:5 10:20 30:20 30:5, 50:0 60:0 60:10 50:10");
  const Point from = at_mm(5, 12), to = at_mm(35, 12);
  CHECK_GT(TravelSpace(two, kWidth, Length::from_mm(9)).way(from, to).size(), 2);
  const std::vector<Point> straight = {from, to};
  CHECK_EQ(TravelSpace(two, kWidth, Length::from_mm(6)).way(from, to), straight);
  const TravelSpace space(two, kWidth, Length());
  CHECK_EQ(space.way(from, at_mm(55, 5)).size(), 2);
  CHECK_EQ(space.way(at_mm(-5, 40), to).size(), 2);
  CHECK_EQ(TravelSpace(Region(), kWidth, Length()).way(from, to), straight);
}

TEST_CASE("in a thin wall a way follows the wall") {
  // A frame, its wall 0.8 mm wide, open at the top.
  const Region frame =
      test::region_from_text("0:0 20:0 20:20 19.2:20 19.2:0.8 0.8:0.8 0.8:20 0:20");
  const TravelSpace space(frame, kWidth, Length());
  const std::vector<Point> way = space.way(at_mm(0.4, 18), at_mm(19.6, 18));
  // Between the shortest, along the inner corners, and the wall's middle.
  CHECK(length_mm(way, false) > 2 * std::hypot(17.2, 0.4) + 18.4);
  CHECK(length_mm(way, false) < 2 * 17.6 + 19.2);
  CHECK(stays_within(way, frame, SegmentGrid(Length::from_mm(1), frame), Length::from_units(1)));
}

TEST_CASE("random regions: what is connected at some depth is reached within the island") {
  constexpr std::uint64_t kSeed = 20'261'128;
  test::Random random(kSeed);
  int around = 0, narrow = 0;
  for (int round = 0; round < 24; ++round) {
    CAPTURE(kSeed);
    CAPTURE(round);
    const Region region = test::random_region(random, 60 + round * 10, 40);
    const SegmentGrid contours(Length::from_mm(1), region);
    // Deeper than the lines that are followed by what a way may cut off, and a cell.
    Raster wide(region, contours, Length::from_mm(0.45 + 0.1));
    Raster thin(region, contours, Length::from_mm(0.1125 + 0.1));
    const bool bounded = round % 4 == 3;
    const Length limit = bounded ? Length::from_mm(6) : Length();
    const TravelSpace space(region, kWidth, limit);
    const Box box = region.box();
    std::vector<Point> points;
    while (points.size() < 40) {
      const Point at{random.integer(box.min.x, box.max.x), random.integer(box.min.y, box.max.y)};
      if (thin.piece_at(at) >= 0) points.push_back(at);
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point from = points[i - 1], to = points[i];
      const std::vector<Point> way = space.way(from, to);
      REQUIRE_EQ(way.front(), from);
      REQUIRE_EQ(way.back(), to);
      const double detour_mm = length_mm(way, false) - distance_mm(from, to);
      if (bounded) CHECK_LE(detour_mm, 6);
      if (way.size() > 2) CHECK(stays_within(way, region, contours, Length::from_units(1)));
      if (bounded || thin.piece_at(from) != thin.piece_at(to)) continue;
      CAPTURE(from.x);
      CAPTURE(from.y);
      CAPTURE(to.x);
      CAPTURE(to.y);
      CHECK(stays_within(way, region, contours, Length::from_units(1)));
      around += way.size() > 2 ? 1 : 0;
      if (wide.piece_at(from) < 0 || wide.piece_at(from) != wide.piece_at(to)) continue;
      // No outer perimeter is crossed.
      CHECK(stays_within(way, region, contours, Length::from_mm(0.4 * 0.45 - 0.012)));
      narrow += way.size() > 2 ? 1 : 0;
    }
  }
  MESSAGE("ways around: " << around << ", of them in wide places: " << narrow);
  CHECK_GT(around, 60);
  CHECK_GT(narrow, 20);
}
