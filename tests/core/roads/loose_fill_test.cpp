#include "core/roads/loose_fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/offsets/voronoi_mountain.h"
#include "core/regions/polyline.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using namespace core;

namespace {

Slice slice_at(LayerIndex index, const Settings& settings) {
  Slice slice;
  slice.index = index;
  slice.height = settings.layer_height;
  slice.bottom = settings.layer_height * index;
  return slice;
}

}  // namespace

TEST_CASE("what is laid is the share asked for, joins and drawn-on ends counted") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Settings settings;
    settings.loose_density = random.between(0.1, 0.6);
    const Region room = test::random_region(random, 50, 60);
    const Region inside = offset(room, Length::from_mm(1), settings.arc_tolerance);
    const auto roads = loose_roads(inside, room, slice_at(0, settings), settings);
    const double share = test::laid_mm2(roads, settings.layer_height) / inside.area_mm2();
    CAPTURE(settings.loose_density);
    CHECK(share == doctest::Approx(settings.loose_density).epsilon(0.02));
    CHECK_GT(test::least_depth_mm(room, roads), -1e-3);
  }
}

TEST_CASE("free ends reach into the wall, joins stay half a road's distance inside") {
  Settings settings;
  settings.infill_anchor_max = Length();
  const Region inside = test::region_from_text("10:10 50:10 50:50 10:50");
  const Region room = test::region_from_text("1:1 59:1 59:59 1:59");
  const auto apart = loose_roads(inside, room, slice_at(0, settings), settings);
  REQUIRE_GT(apart.size(), 20);
  for (const Road& road : apart) {
    REQUIRE_EQ(road.points.size(), 2);
    for (const Point end : road.points) {
      const double depth = test::signed_distance(inside, end.x, end.y) / kUnitsPerMm;
      CHECK(depth == doctest::Approx(-0.3 / std::sqrt(2.0)).epsilon(0.02));
    }
  }
  settings.infill_anchor_max = Length::from_mm(50);
  const auto joined = loose_roads(inside, room, slice_at(0, settings), settings);
  REQUIRE_EQ(joined.size(), 1);
  const std::vector<Point>& points = joined.front().points;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    CHECK(test::signed_distance(inside, points[i].x, points[i].y) ==
          doctest::Approx(2'035).epsilon(0.01));
  }
}

TEST_CASE("nothing asked for, and no room") {
  Settings settings;
  const Region inside = test::region_from_text("10:10 50:10 50:50 10:50");
  const Region hair = test::region_from_text("10:10 50:10 50:10.3 10:10.3");
  CHECK(loose_roads({}, inside, slice_at(0, settings), settings).empty());
  CHECK(loose_roads(hair, hair, slice_at(0, settings), settings).empty());
  settings.loose_density = 0;
  CHECK(loose_roads(inside, inside, slice_at(0, settings), settings).empty());
}

TEST_CASE("rows lie over one another in layers of unlike height, and lay the share asked for") {
  Settings settings;
  settings.adaptive_layer_height = true;
  settings.infill_anchor_max = Length();
  const Region inside = test::region_from_text("10:10 50:10 50:50 10:50");
  const Region room = test::region_from_text("9:9 51:9 51:51 9:51");
  std::vector<std::int64_t> first;
  for (const double height : {0.2, 0.07, 0.13, 0.3}) {
    CAPTURE(height);
    Slice slice = slice_at(4, settings);
    slice.height = Length::from_mm(height);
    const auto roads = loose_roads(inside, room, slice, settings);
    // Rows run at 45°: each is where x and y differ by so much.
    std::vector<std::int64_t> rows;
    for (const Road& road : roads) {
      const Point end = road.points.front();
      rows.push_back((std::int64_t{end.x} - end.y + 50) / 100);
    }
    std::sort(rows.begin(), rows.end());
    if (first.empty()) first = rows;
    REQUIRE_GT(rows.size(), 20);
    CHECK(rows == first);
    const double share = test::laid_mm2(roads, slice.height) / inside.area_mm2();
    CHECK(share == doctest::Approx(settings.loose_density).epsilon(0.02));
  }
}
