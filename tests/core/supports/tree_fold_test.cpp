// Tree supports, all layers held: every piece stands on something, keeps off the part, and holds
// what it is there for.
#include "core/supports/tree_fold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/point_location.h"
#include "core/regions/polyline.h"
#include "core/supports/tree_reach.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/tree_stacks.h"

using namespace core;

namespace {

constexpr std::uint64_t kSeeds = 4;
constexpr int kLayers = 70;

// Corners of a branch's polygon, radii in whole steps, and tolerances of what is laid, in units.
constexpr double kLaidUnits = 1'200;

std::vector<Point> samples(const Region& region) {
  std::vector<Point> points;
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      points.push_back(ring[i]);
      points.push_back(between(ring[i], ring[(i + 1) % ring.size()], 0.5));
    }
  }
  return points;
}

// How far a point is outside a region, in units; 0 inside.
double outside(const Region& region, Point point) {
  if (region.empty()) return 1e9;
  return std::max(0.0, -test::signed_distance(region, point.x, point.y));
}

// The end of a spike without an area, as booleans leave them.
bool is_spike(const Region& region, Point point) {
  for (int i = 0; i < 8; ++i) {
    const double angle = i * M_PI / 4;
    const double x = point.x + 200 * std::cos(angle), y = point.y + 200 * std::sin(angle);
    if (test::signed_distance(region, x, y) > 40) return false;
  }
  return true;
}

double step_of(const Settings& settings) {
  return static_cast<double>(branch_step(settings.layer_height, settings).units());
}

}  // namespace

TEST_CASE("every piece of a branch keeps off the part, and stands on the piece below it") {
  for (const SupportPlace place : {SupportPlace::kBed, SupportPlace::kEverywhere}) {
    const Settings settings = test::tree_settings(place);
    const double off = static_cast<double>(settings.support_xy_distance.units());
    std::size_t seen = 0, on_part = 0;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      CAPTURE(seed);
      const std::vector<Region> slices = test::ledges(seed, kLayers);
      const test::TreeStack trees = test::trees_for(slices, settings);
      for (std::size_t n = 0; n < slices.size(); ++n) {
        CAPTURE(n);
        const SupportLayer& layer = trees.layers[n];
        if (!layer.branches || layer.branches->empty()) continue;
        CHECK(intersect(*layer.region, slices[n]).area_mm2() < 1e-3);
        CHECK(subtract(*layer.branches, *layer.region).area_mm2() < 1e-3);
        if (n + 1 < slices.size()) {
          CHECK(intersect(*layer.branches, slices[n + 1]).area_mm2() < 1e-3);
        }
        for (const Point point : samples(*layer.branches)) {
          if (++seen % 4 != n % 4) continue;
          CHECK_GT(outside(slices[n], point), off - 2);
          if (n == 0) continue;
          if (outside(*trees.layers[n - 1].region, point) <= 2 * step_of(settings) + kLaidUnits) {
            continue;
          }
          if (is_spike(*layer.branches, point)) continue;
          // On the part, or beside it, where a branch comes down.
          CHECK_EQ(place, SupportPlace::kEverywhere);
          const double under =
              std::min(outside(slices[n - 1], point), n > 1 ? outside(slices[n - 2], point) : 1e9);
          CHECK_LT(under, off + 2 * step_of(settings) + kLaidUnits);
          ++on_part;
        }
      }
    }
    CHECK_GT(seen, 10'000);
    CHECK_EQ(on_part > 0, place == SupportPlace::kEverywhere);
  }
}

TEST_CASE("every node goes on below, a step away at most, or lies in one that does") {
  for (const SupportPlace place : {SupportPlace::kBed, SupportPlace::kEverywhere}) {
    const Settings settings = test::tree_settings(place);
    std::size_t seen = 0, merged = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      CAPTURE(seed);
      const std::vector<Region> slices = test::ledges(seed, kLayers);
      const test::TreeStack trees = test::trees_for(slices, settings);
      const std::vector<SharedRegion> avoided = test::avoided_in(slices, settings);
      for (std::size_t n = 1; n < slices.size(); ++n) {
        CAPTURE(n);
        for (const TreeNode& node : trees.nodes[n]) {
          if (!node.to_bed) continue;
          ++seen;
          CHECK_LE(test::signed_distance(*avoided[n], node.at.x, node.at.y), 1);
          double least = 1e9;
          for (const TreeNode& below : trees.nodes[n - 1]) {
            if (!below.to_bed) continue;
            const double room = std::max(0.0, below.radius - node.radius);
            least = std::min(least, distance_units(node.at, below.at) - room);
          }
          CHECK_LE(least, step_of(settings) + 1);
          // Its core is laid, but for a tip that stands in the gap under what hangs.
          if (n + 1 < slices.size() && slices[n + 1].contains(node.at)) continue;
          CHECK(trees.layers[n].region->contains(node.at));
        }
        merged += trees.nodes[n].size() > trees.nodes[n - 1].size() ? 1 : 0;
      }
    }
    CHECK_GT(seen, 1'000);
    CHECK_GT(merged, 20);
  }
}

TEST_CASE("what the roof has nothing of its own under has tips under it") {
  const Settings settings = test::tree_settings(SupportPlace::kEverywhere);
  // A cell's diagonal, and a tip's way off the part.
  const double reach = (4.2 + 1.3) * kUnitsPerMm;
  std::size_t seen = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    CAPTURE(seed);
    const std::vector<Region> slices = test::ledges(seed, kLayers);
    const test::TreeStack trees = test::trees_for(slices, settings);
    const auto roof = [&](std::size_t n) {
      const SupportLayer& layer = trees.layers[n];
      return layer.branches ? subtract(*layer.region, *layer.branches) : *layer.region;
    };
    for (std::size_t n = 0; n + 1 < slices.size(); ++n) {
      CAPTURE(n);
      const Region above = roof(n + 1);
      if (above.empty()) continue;
      const Region here = roof(n);
      const Region part = n > 1 ? unite(slices[n - 1], slices[n - 2]) : Region();
      for (const Point point : samples(above)) {
        if (outside(here, point) <= step_of(settings) + kLaidUnits) continue;
        if (outside(part, point) <= 0.8 * kUnitsPerMm) continue;  // it lies on the part
        ++seen;
        double least = 1e9;
        for (const TreeNode& node : trees.nodes[n]) {
          least = std::min(least, distance_units(point, node.at));
        }
        CHECK_LE(least, reach);
      }
    }
  }
  CHECK_GT(seen, 1'000);
}

TEST_CASE("what hangs where no branch comes down to the bed has no roof, with supports = bed") {
  // A plate, a wall on it, and a ceiling over both sides of the plate's edge.
  const Region plate = test::rectangle_region(20, 20, 40, 40);
  const Region wall = test::rectangle_region(20, 20, 5, 40);
  const Region ceiling = test::rectangle_region(20, 20, 60, 40);
  std::vector<Region> slices(5, plate);
  slices.insert(slices.end(), 40, wall);
  slices.insert(slices.end(), 5, ceiling);
  const auto roof_of = [&](SupportPlace place) {
    const test::TreeStack trees = test::trees_for(slices, test::tree_settings(place));
    return *trees.layers[43].region;
  };
  const Region bed = roof_of(SupportPlace::kBed), all = roof_of(SupportPlace::kEverywhere);
  const Point far{30 * 10'000, 40 * 10'000}, near{70 * 10'000, 40 * 10'000};
  CHECK(all.contains(far));
  CHECK(all.contains(near));
  CHECK_FALSE(bed.contains(far));
  CHECK(bed.contains(near));
  // 8 mm of height for branches of 40° reach 6.7 mm over the plate.
  double least_x = 70;
  while (bed.contains({static_cast<std::int32_t>(least_x * 10'000), near.y})) least_x -= 0.1;
  CHECK_GT(least_x, 60 - 38 * 0.2 * std::tan(40 * M_PI / 180) - 1.5);
  CHECK_LT(least_x, 60 - 38 * 0.2 * std::tan(40 * M_PI / 180) + 1.5);
}

TEST_CASE("branches stay over the bed") {
  Settings settings = test::tree_settings(SupportPlace::kEverywhere);
  settings.bed_x = settings.bed_y = Length::from_mm(62);
  // A ceiling at the bed's edge, whose branches would go outwards around a block.
  std::vector<Region> slices(30, test::rectangle_region(1, 1, 50, 60));
  slices.insert(slices.end(), 20, test::rectangle_region(1, 1, 10, 60));
  slices.insert(slices.end(), 4, test::rectangle_region(1, 1, 60, 60));
  const test::TreeStack trees = test::trees_for(slices, settings);
  bool any = false;
  for (const SupportLayer& layer : trees.layers) {
    if (!layer.branches || layer.branches->empty()) continue;
    any = true;
    const Box box = layer.branches->box();
    CHECK_GE(box.min.x, 0);
    CHECK_GE(box.min.y, 0);
    CHECK_LE(box.max.x, settings.bed_x.units());
    CHECK_LE(box.max.y, settings.bed_y.units());
  }
  CHECK(any);
}
