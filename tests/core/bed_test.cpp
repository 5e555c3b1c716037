#include "core/bed.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motions/park_place.h"
#include "tests/support/random_regions.h"

using core::Length;
using core::Point;

namespace {

constexpr double kRadius_mm = 100;

// A round bed around the printer's origin.
core::Settings round_bed(int corners) {
  core::Settings settings;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    settings.bed_shape.push_back(
        {static_cast<std::int32_t>(std::lround(kRadius_mm * 1e4 * std::cos(angle))),
         static_cast<std::int32_t>(std::lround(kRadius_mm * 1e4 * std::sin(angle)))});
  }
  settings.bed_x = settings.bed_y = Length::from_mm(2 * kRadius_mm);
  settings.bed_origin_x = settings.bed_origin_y = Length::from_mm(-kRadius_mm);
  return settings;
}

Point at(double x_mm, double y_mm) {
  return {static_cast<std::int32_t>(std::lround(x_mm * 1e4)),
          static_cast<std::int32_t>(std::lround(y_mm * 1e4))};
}

double from_middle_mm(Point point) {
  return std::hypot(point.x / 1e4 - kRadius_mm, point.y / 1e4 - kRadius_mm);
}

// An L: 100 by 100 mm without its back right quarter.
core::Settings corner_bed() {
  core::Settings settings;
  settings.bed_shape = {at(0, 0), at(100, 0), at(100, 50), at(50, 50), at(50, 100), at(0, 100)};
  settings.bed_x = settings.bed_y = Length::from_mm(100);
  return settings;
}

}  // namespace

TEST_CASE("a bed without an outline is the rectangle that it was") {
  core::Settings settings;
  settings.bed_x = Length::from_mm(200);
  settings.bed_y = Length::from_mm(100);
  const core::Bed bed(settings);
  CHECK(bed.holds(at(0, 0)));
  CHECK(bed.holds(at(200, 100)));
  CHECK_FALSE(bed.holds(at(200, 100), Length::from_units(1)));
  CHECK(bed.holds(core::Box{at(0, 0), at(200, 100)}));
  CHECK_FALSE(bed.holds(core::Box{at(0, 0), at(200.0001, 100)}));
  CHECK_FALSE(bed.holds(core::Box{}));
  CHECK_EQ(bed.outline().size(), 4);
}

TEST_CASE("a round bed holds what is nearer to its middle than its radius") {
  const unsigned seed = 11;
  CAPTURE(seed);
  test::Random random(seed);
  const core::Bed bed(round_bed(72));
  // The outline lies between this circle and the corners' one.
  const double inner_mm = kRadius_mm * std::cos(std::numbers::pi / 72);
  int inside = 0;
  for (int i = 0; i < 4'000; ++i) {
    const Point point = at(random.between(-10.0, 210.0), random.between(-10.0, 210.0));
    const double reach_mm = random.between(0.0, 5.0);
    const double away_mm = from_middle_mm(point);
    const bool held = bed.holds(point, Length::from_mm(reach_mm));
    CAPTURE(point.x);
    CAPTURE(point.y);
    if (away_mm + reach_mm < inner_mm - 1e-3) CHECK(held);
    if (away_mm + reach_mm > kRadius_mm + 1e-3) CHECK_FALSE(held);
    inside += held ? 1 : 0;
    // A box is held where its corners are, on a convex bed.
    const Point other = at(random.between(0.0, 200.0), random.between(0.0, 200.0));
    core::Box box;
    box.add(point);
    box.add(other);
    const bool corners = bed.holds(box.min) && bed.holds(box.max) &&
                         bed.holds(Point{box.min.x, box.max.y}) &&
                         bed.holds(Point{box.max.x, box.min.y});
    CHECK_EQ(bed.holds(box), corners);
  }
  CHECK_GT(inside, 1'000);
}

TEST_CASE("a box that spans a notch is not on the bed, whatever its corners say") {
  const core::Bed bed(corner_bed());
  CHECK(bed.holds(core::Box{at(0, 0), at(100, 50)}));
  CHECK(bed.holds(core::Box{at(0, 0), at(50, 100)}));
  CHECK_FALSE(bed.holds(core::Box{at(40, 40), at(60, 60)}));
  CHECK_FALSE(bed.holds(at(51, 51)));
  CHECK(bed.holds(at(50, 50)));
  CHECK_FALSE(bed.holds(at(49.95, 60), Length::from_mm(0.1)));
  core::Settings turned = corner_bed();
  std::reverse(turned.bed_shape.begin(), turned.bed_shape.end());
  CHECK(core::Bed(turned).holds(core::Box{at(0, 0), at(100, 50)}));
}

TEST_CASE("axes that are shorter than the bed cut it") {
  core::Settings settings = round_bed(72);
  settings.bed_x = Length::from_mm(150);
  const core::Bed bed(settings);
  CHECK(bed.holds(at(149, 100)));
  CHECK_FALSE(bed.holds(at(151, 100)));
}

TEST_CASE("parking stays on the bed, near the corner that has none") {
  const core::Settings settings = round_bed(60);
  const Point park = core::park_place(settings);
  CHECK_EQ(park.x, park.y);
  CHECK_GT(from_middle_mm(park), kRadius_mm - 5.3);
  CHECK_LT(from_middle_mm(park), kRadius_mm - 4.9);
  core::Settings asked = settings;
  asked.park_x = Length::from_mm(200);
  asked.park_y = Length::from_mm(200);
  CHECK(core::Bed(asked).holds(core::park_place(asked)));
  CHECK_GT(from_middle_mm(core::park_place(asked)), kRadius_mm - 1);
  asked.park_x = Length::from_mm(20);
  asked.park_y = Length::from_mm(100);
  CHECK_EQ(core::park_place(asked), at(20, 100));
  // A bed so small that nothing is 5 mm off its edge, and one whose middle is not on it.
  core::Settings small = corner_bed();
  small.bed_shape = {at(0, 0), at(8, 0), at(4, 7)};
  small.bed_x = Length::from_mm(8);
  small.bed_y = Length::from_mm(7);
  CHECK(core::Bed(small).holds(core::park_place(small)));
  core::Settings notched = corner_bed();
  notched.bed_shape = {at(0, 0), at(100, 0), at(100, 10), at(10, 10), at(10, 100), at(0, 100)};
  CHECK(core::Bed(notched).holds(core::park_place(notched)));
  CHECK(core::Bed(notched).holds(core::Bed(notched).place_near(at(99, 99), {})));
}
