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

// What a raft should cover, as a raster: what lies within `mm` of the slice, a literal growth of
// it, and the holes in that which are small.
class Raster {
 public:
  Raster(const Region& slice, double mm, double step_mm)
      : step_(static_cast<std::int32_t>(step_mm * kUnitsPerMm)), box_(slice.box()) {
    const auto reach = static_cast<std::int32_t>(std::ceil((mm + 3 * step_mm) * kUnitsPerMm));
    // Off the slice's edges by half a step, so that as many points lie within as the area says.
    const std::int32_t half = (reach / step_) * step_ + step_ / 2;
    box_.min = {box_.min.x - half, box_.min.y - half};
    columns_ = static_cast<std::size_t>((box_.max.x + reach - box_.min.x) / step_) + 1;
    rows_ = static_cast<std::size_t>((box_.max.y + reach - box_.min.y) / step_) + 1;
    for (std::size_t i = 0; i < columns_ * rows_; ++i) {
      const Point p = point(i);
      covered_.push_back(test::signed_distance(slice, p.x, p.y) >= -mm * kUnitsPerMm);
    }
    const auto most = static_cast<std::size_t>(kRaftHoleMin_mm2 / (step_mm * step_mm));
    std::vector<bool> seen = covered_;
    filled_.resize(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i]) continue;
      const std::vector<std::size_t> open = open_from(i, seen);
      if (open.front() == 0 || open.size() >= most) continue;  // outside, or a large hole
      for (const std::size_t at : open) covered_[at] = filled_[at] = true;
    }
  }

  [[nodiscard]] std::vector<Point> points() const {
    std::vector<Point> points;
    for (std::size_t i = 0; i < covered_.size(); ++i) {
      if (covered_[i]) points.push_back(point(i));
    }
    return points;
  }

  // Whether one of the points about the place lies in a small hole.
  [[nodiscard]] bool in_small_hole(double x, double y) const {
    const auto column = static_cast<std::size_t>(std::max(0.0, (x - box_.min.x) / step_));
    const auto row = static_cast<std::size_t>(std::max(0.0, (y - box_.min.y) / step_));
    for (std::size_t r = row; r < std::min(row + 2, rows_); ++r) {
      for (std::size_t c = column; c < std::min(column + 2, columns_); ++c) {
        if (filled_[r * columns_ + c]) return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] Point point(std::size_t i) const {
    return {box_.min.x + static_cast<std::int32_t>(i % columns_) * step_,
            box_.min.y + static_cast<std::int32_t>(i / columns_) * step_};
  }

  // Open points that hang together with this one; marks them as seen.
  [[nodiscard]] std::vector<std::size_t> open_from(std::size_t first,
                                                   std::vector<bool>& seen) const {
    std::vector<std::size_t> found = {first};
    seen[first] = true;
    const auto look = [&](std::size_t at) {
      if (seen[at]) return;
      seen[at] = true;
      found.push_back(at);
    };
    for (std::size_t done = 0; done < found.size(); ++done) {
      const std::size_t at = found[done];
      if (at % columns_ > 0) look(at - 1);
      if (at % columns_ + 1 < columns_) look(at + 1);
      if (at >= columns_) look(at - columns_);
      if (at / columns_ + 1 < rows_) look(at + columns_);
    }
    return found;
  }

  std::int32_t step_;
  Box box_;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<bool> covered_;
  std::vector<bool> filled_;  // of them, in small holes
};

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
      // A hole that stays one, one that is too small for that, one that the growth closes, an
      // island near by.
      test::region_from_text("50:50 84:50 84:66 50:66, 54:53 54:63 64:63 64:53, "
                             "68:54 68:62 75:62 75:54, "
                             "79:56 79:58 81:58 81:56, 87:50 92:50 92:60 87:60"),
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
    const Raster fine(slice, grown, 0.05);
    const double raster_mm2 = 0.05 * 0.05 * static_cast<double>(fine.points().size());
    const std::vector<Point> raster = Raster(slice, grown, 0.4).points();
    REQUIRE_GT(raster.size(), 50);
    for (LayerIndex index = 0; index < settings.raft_layers; ++index) {
      CAPTURE(index);
      const RaftLayer laid = raft.layer(index);
      CHECK_EQ(laid.layer.slice.index, index);
      CHECK(laid.layer.slice.region.area_mm2() == doctest::Approx(raster_mm2).epsilon(0.003));
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
            if (fine.in_small_hole(x, y)) continue;
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
