#include "core/roads/raft.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/offsets/slice_offsets.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/road_checks.h"

using namespace core;

namespace {

Settings on_raft(int layers) {
  Settings settings;
  settings.raft_layers = layers;
  settings.raft_expansion = Length::from_mm(2);
  settings.first_layer_height = Length::from_mm(0.3);
  settings.first_layer_width = Length::from_mm(0.6);
  return settings;
}

std::vector<Road> of_raft(const RaftLayer& layer) {
  std::vector<Road> roads;
  for (const Road& road : layer.roads) {
    if (road.kind == RoadKind::kRaft) roads.push_back(road);
  }
  return roads;
}

// Points of a raster, in units, that lie within `mm` of the slice: a literal growth of it.
std::vector<Point> raster_within(const Region& slice, double mm, double step_mm) {
  std::vector<Point> points;
  const Box box = slice.box();
  const auto reach = static_cast<std::int32_t>(std::ceil((mm + step_mm) * kUnitsPerMm));
  const auto step = static_cast<std::int32_t>(step_mm * kUnitsPerMm);
  for (std::int32_t y = box.min.y - reach; y <= box.max.y + reach; y += step) {
    for (std::int32_t x = box.min.x - reach; x <= box.max.x + reach; x += step) {
      if (test::signed_distance(slice, x, y) >= -mm * kUnitsPerMm) points.push_back({x, y});
    }
  }
  return points;
}

double distance_mm_to(const std::vector<Road>& roads, Point at) {
  double least = 1e9;
  for (const Road& road : roads) {
    const std::size_t count = road.points.size();
    for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
      const Segment piece{road.points[i], road.points[(i + 1) % count]};
      if (piece.from == piece.to) continue;
      least = std::min(least, test::distance_to_segment(at, piece));
    }
  }
  return least / kUnitsPerMm;
}

std::vector<Region> slices() {
  std::vector<Region> all = {
      test::region_from_text("50:50 70:50 70:64 50:64"),
      // A hole that stays one, a hole that the growth closes, an island near by.
      test::region_from_text("50:50 74:50 74:66 50:66, 54:54 54:62 62:62 62:54, "
                             "66:56 66:58 68:58 68:56, 77:50 82:50 82:60 77:60"),
      test::region_from_text("50:50 75:50 75:50.4 50:50.4"),  // narrower than a road
      test::region_from_text("50:50 52:50 52:52 50:52")};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    test::Random random(seed);
    all.push_back(test::random_region(random, 40, 25));
  }
  return all;
}

}  // namespace

TEST_CASE("half of the layers are dense, the first is as the setting says") {
  Settings settings = on_raft(1);
  settings.raft_first_layer_density = 0.7;
  const auto densities = [&](int layers) {
    settings.raft_layers = layers;
    std::string text;
    for (int i = 0; i < layers; ++i) {
      const double density = raft_density(settings, i);
      text += density == 1 ? 'd' : density == 0.7 ? 'f' : 's';
    }
    return text;
  };
  CHECK_EQ(densities(1), "f");
  CHECK_EQ(densities(2), "fd");
  CHECK_EQ(densities(3), "fdd");
  CHECK_EQ(densities(4), "fsdd");
  CHECK_EQ(densities(5), "fsddd");
  CHECK_EQ(densities(8), "fsssdddd");
}

TEST_CASE("the raft covers the first slice, grown, and no bead of it lies beyond") {
  const std::vector<Region> all = slices();
  for (std::size_t number = 0; number < all.size(); ++number) {
    CAPTURE(number);
    const Region& slice = all[number];
    Settings settings = on_raft(4);
    settings.raft_first_layer_density = 0.75;
    const double grown = settings.raft_expansion.mm();
    const Raft raft(slice, settings);
    const std::vector<Point> raster = raster_within(slice, grown, 0.4);
    REQUIRE_GT(raster.size(), 50);
    const double raster_mm2 =
        0.05 * 0.05 * static_cast<double>(raster_within(slice, grown, 0.05).size());
    for (LayerIndex index = 0; index < settings.raft_layers; ++index) {
      CAPTURE(index);
      const RaftLayer laid = raft.layer(index);
      CHECK_EQ(laid.layer.slice.index, index);
      const std::vector<Road> roads = of_raft(laid);
      REQUIRE_FALSE(roads.empty());
      // Nothing lies beyond.
      double beyond = 0;
      for (const Road& road : roads) {
        for (std::size_t i = 0; i < road.points.size(); ++i) {
          // Of points around the bead.
          for (int turn = 0; turn < 16; ++turn) {
            const double r = static_cast<double>(width_at(road, i).units()) / 2;
            const double x = road.points[i].x + r * std::cos(turn * 0.3927);
            const double y = road.points[i].y + r * std::sin(turn * 0.3927);
            beyond = std::max(beyond, -test::signed_distance(slice, x, y) / kUnitsPerMm - grown);
          }
        }
      }
      // Sparse rows may be wider than their setting by 15 % (loose_fill.cpp).
      const double density = raft_density(settings, index);
      CHECK_LE(beyond, density == 1 ? 0.012 : 0.035);
      // What is asked is laid.
      const double share = test::laid_mm2(roads, laid.layer.slice.height) / raster_mm2;
      CHECK(share == doctest::Approx(density).epsilon(0.02));
      // It is everywhere: no point is farther from a road than the rows allow.
      const Settings own = index == 0 ? first_layer_settings(settings) : settings;
      const double half_mm = own.road_width.mm() / 2;
      const double reach = density == 1 ? half_mm * 1.02 : 2 * half_mm / density;
      const auto near = std::count_if(raster.begin(), raster.end(),
                                      [&](Point at) { return distance_mm_to(roads, at) <= reach; });
      CHECK_GE(static_cast<double>(near), 0.985 * static_cast<double>(raster.size()));
    }
  }
}

TEST_CASE("rows run across those under them, and the part's first across the last") {
  for (const int layers : {2, 3, 4, 5}) {
    CAPTURE(layers);
    Settings settings = on_raft(layers);
    settings.fill_angle_degrees = 30;
    const Raft raft(test::region_from_text("50:50 80:50 80:70 50:70"), settings);
    for (LayerIndex index = 0; index < layers; ++index) {
      CAPTURE(index);
      // The part's layer 0 has rows at 30°, and so has every second layer under it.
      const bool turned = (layers - index) % 2 != 0;
      const double angle = (turned ? 120 : 30) * 3.14159265358979 / 180;
      double along_mm = 0, across_mm = 0;
      for (const Road& road : of_raft(raft.layer(index))) {
        for (std::size_t i = 1; i < road.points.size(); ++i) {
          const double dx = (road.points[i].x - road.points[i - 1].x) / kUnitsPerMm;
          const double dy = (road.points[i].y - road.points[i - 1].y) / kUnitsPerMm;
          if (std::hypot(dx, dy) < 3) continue;
          along_mm += std::abs(dx * std::cos(angle) + dy * std::sin(angle));
          across_mm += std::abs(dy * std::cos(angle) - dx * std::sin(angle));
        }
      }
      CHECK_GT(along_mm, 8 * across_mm);
    }
  }
}

TEST_CASE("skirt and brim lie around the raft, on the bed only") {
  Settings settings = on_raft(2);
  settings.skirt_loops = 2;
  settings.brim_width = Length::from_mm(2);
  const Region slice = test::region_from_text("50:50 70:50 70:64 50:64");
  const Raft raft(slice, settings);
  const RaftLayer first = raft.layer(0), second = raft.layer(1);
  double nearest_brim = 1e9, nearest_skirt = 1e9;
  for (const Road& road : first.roads) {
    if (road.kind == RoadKind::kRaft) continue;
    for (const Point point : road.points) {
      const double away = -test::signed_distance(slice, point.x, point.y) / kUnitsPerMm;
      double& nearest = road.kind == RoadKind::kSkirt ? nearest_skirt : nearest_brim;
      nearest = std::min(nearest, away);
    }
  }
  CHECK(nearest_brim == doctest::Approx(2 + 0.3).epsilon(0.01));
  CHECK(nearest_skirt == doctest::Approx(2 + 2 + 3 + 0.3).epsilon(0.01));
  CHECK_EQ(first.roads.front().kind, RoadKind::kSkirt);
  CHECK(std::all_of(second.roads.begin(), second.roads.end(),
                    [](const Road& road) { return road.kind == RoadKind::kRaft; }));
}

TEST_CASE("a dense first layer is dense") {
  Settings settings = on_raft(1);
  settings.raft_first_layer_density = 1;
  const Region slice = test::region_from_text("50:50 70:50 70:64 50:64");
  const RaftLayer laid = Raft(slice, settings).layer(0);
  test::Random random(5);
  CHECK_GE(test::covered_share(laid.layer.slice.region, of_raft(laid), 4'000, random), 0.995);
  CHECK(laid.layer.loose.empty());
}
