#include "core/roads/brim.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/offsets/slice_offsets.h"
#include "core/roads/skirt.h"

using core::BrimPlace;
using core::Length;
using core::Region;
using core::Road;
using core::RoadKind;
using core::Settings;

namespace {

constexpr Length kHeight = Length::from_units(2'000);

// A square of 20 mm with a square hole of 10 mm.
Region frame() {
  return Region::from_clean_rings(
      {{{0, 0}, {200'000, 0}, {200'000, 200'000}, {0, 200'000}},
       {{50'000, 50'000}, {50'000, 150'000}, {150'000, 150'000}, {150'000, 50'000}}});
}

// How far a road's leftmost point is from x = `from`, without half its width.
double left_gap_mm(const Road& road, std::int32_t from) {
  std::int32_t least = road.points.front().x;
  for (const core::Point p : road.points) least = std::min(least, p.x);
  return Length::from_units(from - least).mm() - road.width.mm() / 2;
}

}  // namespace

TEST_CASE("without a width there is no brim") {
  CHECK(brim_roads(frame(), kHeight, Settings()).empty());
  CHECK_EQ(brim_reach(Settings()), Length());
}

TEST_CASE("a brim is as wide and as far away as asked, the farthest loop first") {
  Settings settings;
  settings.brim_width = Length::from_mm(4);
  settings.brim_gap = Length::from_mm(0.1);
  const std::vector<Road> roads = brim_roads(frame(), kHeight, settings);
  const double spacing = perimeter_spacing(settings, kHeight).mm();
  REQUIRE_EQ(roads.size(), static_cast<std::size_t>(4 / spacing));
  for (std::size_t i = 0; i < roads.size(); ++i) {
    const auto loop = static_cast<double>(roads.size() - 1 - i);
    CHECK_EQ(roads[i].kind, RoadKind::kBrim);
    CHECK(roads[i].closed);
    CHECK_EQ(left_gap_mm(roads[i], 0), doctest::Approx(0.1 + loop * spacing).epsilon(1e-3));
  }
  CHECK_LE(left_gap_mm(roads.front(), 0) + roads.front().width.mm(),
           brim_reach(settings).mm() + 0.05);
}

TEST_CASE("holes have a brim where asked") {
  Settings settings;
  settings.brim_width = Length::from_mm(2);
  const std::size_t outer = brim_roads(frame(), kHeight, settings).size();
  settings.brim_place = BrimPlace::kInner;
  const std::size_t inner = brim_roads(frame(), kHeight, settings).size();
  CHECK_EQ(brim_reach(settings), Length());
  settings.brim_place = BrimPlace::kBoth;
  CHECK_GT(inner, 0);
  CHECK_EQ(brim_roads(frame(), kHeight, settings).size(), outer + inner);
  // The hole is 10 mm wide: no loop where there is no room.
  settings.brim_place = BrimPlace::kInner;
  settings.brim_width = Length::from_mm(50);
  CHECK_LE(brim_roads(frame(), kHeight, settings).size(),
           static_cast<std::size_t>(5 / perimeter_spacing(settings, kHeight).mm()) + 1);
}

TEST_CASE("a skirt lies around the brim, and is as long as asked") {
  Settings settings;
  settings.brim_width = Length::from_mm(3);
  const std::vector<Road> one = skirt_roads(frame(), kHeight, settings);
  REQUIRE_EQ(one.size(), 1);
  CHECK_EQ(left_gap_mm(one[0], 0),
           doctest::Approx((brim_reach(settings) + settings.skirt_distance).mm()).epsilon(1e-3));
  settings.skirt_length_min = Length::from_mm(500);
  const std::vector<Road> more = skirt_roads(frame(), kHeight, settings);
  double laid = 0;
  for (const Road& road : more) laid += length_mm(road);
  CHECK_GE(laid, 500);
  CHECK_LT(laid - length_mm(more.front()), 500);
  CHECK_EQ(more.back().points, one[0].points);
  settings.skirt_loops = 0;
  CHECK(skirt_roads(frame(), kHeight, settings).empty());
}
