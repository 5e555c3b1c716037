#include "core/walls/ball_wall.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "core/offsets/slice_offsets.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/offsets/wall_depths.h"
#include "core/settings.h"
#include "core/slices/height_plan.h"
#include "core/walls/wall_splitter.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tools/parts/part_maker.h"

using core::Length;
using core::Region;
using core::Settings;
using core::Slice;
using core::SplitLayer;
using core::WallShape;
using core::WallSplitter;

namespace {

// Points on the grid are off by one unit at most, flattened arcs by the arc tolerance (25).
constexpr double kToleranceUnits = 28;

Settings settings_for(double wall_mm, WallShape shape = WallShape::kBall) {
  Settings settings;
  settings.wall_thickness = Length::from_mm(wall_mm);
  settings.wall_shape = shape;
  settings.perimeters = 0;
  return settings;
}

// A part as its section at every height, cut into layers of the given heights.
using Section = std::function<Region(double z_mm)>;

std::vector<Slice> cut(const Section& section, const std::vector<double>& heights_mm) {
  std::vector<Slice> slices;
  Length bottom;
  for (const double height : heights_mm) {
    Slice slice;
    slice.index = static_cast<core::LayerIndex>(slices.size());
    slice.bottom = bottom;
    slice.height = Length::from_mm(height);
    slice.region = section(bottom.mm() + height / 2);
    bottom = slice.top();
    slices.push_back(std::move(slice));
  }
  return slices;
}

std::vector<double> even_heights(std::size_t layers) { return std::vector<double>(layers, 0.2); }

std::vector<SplitLayer> split(const std::vector<Slice>& slices, const Settings& settings,
                              int* operations = nullptr) {
  WallSplitter splitter(settings);
  core::OffsetCutter cutter(settings);
  std::vector<SplitLayer> layers;
  const auto take = [&](std::optional<SplitLayer> layer) {
    if (!layer.has_value()) return false;
    REQUIRE_EQ(layer->slice.index, static_cast<core::LayerIndex>(layers.size()));
    layers.push_back(*std::move(layer));
    return true;
  };
  for (const Slice& slice : slices) {
    take(splitter.push({slice, cutter.cut(slice)}));
    while (take(splitter.next())) {
    }
  }
  while (take(splitter.finish())) {
  }
  REQUIRE_EQ(layers.size(), slices.size());
  CHECK_LE(splitter.usage().operations_worst, core::kBallOperationsMax);
  if (operations != nullptr) *operations += static_cast<int>(splitter.usage().operations);
  return layers;
}

core::Ring circle(double radius_mm, double x_mm, double y_mm, int points = 96) {
  core::Ring ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    const Length x = Length::from_mm(x_mm + radius_mm * std::cos(angle));
    const Length y = Length::from_mm(y_mm + radius_mm * std::sin(angle));
    ring.push_back({static_cast<std::int32_t>(x.units()), static_cast<std::int32_t>(y.units())});
  }
  return ring;
}

Region disc(double radius_mm, double x_mm = 0, double y_mm = 0) {
  if (radius_mm < 0.01) return {};
  return Region::from_clean_rings({circle(radius_mm, x_mm, y_mm)});
}

// A block 6 mm deep whose top falls off to the right at this angle, from 2 to at most 12 mm wide.
Section sloped_plate(double degrees) {
  return [degrees](double z_mm) {
    const double fall = std::tan(degrees * std::numbers::pi / 180);
    const double right = std::min(12.0, 2 + (4.0 - z_mm) / fall);
    return Region::from_clean_rings({test::rectangle(0, 0, right, 6)});
  };
}

// How high the layers of a dome are planned, by its facets' slopes.
std::vector<double> adaptive_heights(double radius_mm) {
  Settings settings;
  settings.adaptive_layer_height = true;
  core::HeightLimits limits = *core::adaptive_limits(settings);
  for (const core::Triangle& facet : test::triangles_of(parts::dome(radius_mm))) limits.add(facet);
  const Length top = Length::from_mm(radius_mm);
  const core::LayerHeights heights = core::adaptive_heights(settings, limits, 0, top);
  std::vector<double> all;
  for (core::LayerIndex n = 0; n < heights.count(top); ++n) all.push_back(heights.height(n).mm());
  return all;
}

struct Part {
  std::string name;
  Section section;
  std::vector<double> heights_mm;
};

std::vector<Part> parts() {
  std::vector<Part> all;
  for (const double degrees : {1.0, 5.0, 15.0, 45.0, 89.0}) {
    all.push_back(
        {"plate sloped by " + std::to_string(degrees), sloped_plate(degrees), even_heights(20)});
  }
  all.push_back({"dome", [](double z) { return disc(std::sqrt(std::max(0.0, 16 - z * z))); },
                 even_heights(20)});
  all.push_back({"two touching spheres",
                 [](double z) {
                   const double radius = std::sqrt(std::max(0.0, 4 - (z - 2) * (z - 2)));
                   return core::unite(disc(radius, -2), disc(radius, 2));
                 },
                 even_heights(20)});
  all.push_back({"tube thinner than its walls",
                 [](double z) { return core::subtract(disc(3 + 0.1 * z), disc(2.2)); },
                 even_heights(15)});
  all.push_back({"screw",
                 [](double z) {
                   const double turned = z * std::numbers::pi / 2;
                   return core::unite(disc(2.5),
                                      disc(2, 2 * std::cos(turned), 2 * std::sin(turned)));
                 },
                 even_heights(25)});
  all.push_back({"one layer", [](double) { return disc(3); }, even_heights(1)});
  all.push_back({"cone in layers of unlike heights",
                 [](double z) { return disc(std::abs(5 - 1.3 * z)); },
                 {0.3, 0.1, 0.1, 0.25, 0.25, 0.05, 0.3, 0.3, 0.2, 0.1, 0.1, 0.1, 0.3, 0.3, 0.2}});
  return all;
}

// By brute force: how far a point of layer n's mid-plane is from what is not part, in units. A slab
// is left through its side, or through its near face at a place where the part does not go on.
double distance_to_outside(const std::vector<Slice>& slices, std::size_t n, double x, double y) {
  const Slice& from = slices[n];
  const double middle =
      static_cast<double>(from.bottom.units()) + static_cast<double>(from.height.units()) / 2;
  double nearest = std::min(middle, static_cast<double>(slices.back().top().units()) - middle);
  for (std::size_t j = 0; j < slices.size(); ++j) {
    double z = 0;
    if (j > n) z = static_cast<double>(slices[j].bottom.units()) - middle;
    if (j < n) z = middle - static_cast<double>(slices[j].top().units());
    const double inside =
        slices[j].region.empty() ? 0 : std::max(0.0, test::signed_distance(slices[j].region, x, y));
    nearest = std::min(nearest, std::hypot(inside, z));
  }
  return nearest;
}

TEST_CASE("every loose point is the wall's thickness away from the outside, no solid one farther") {
  constexpr double kWallMm = 0.6;
  const double wall = kWallMm * core::kUnitsPerMm;
  std::vector<Part> all = parts();
  all.push_back({"dome in adaptive layers",
                 [](double z) { return disc(std::sqrt(std::max(0.0, 9 - z * z))); },
                 adaptive_heights(3)});
  for (const Part& part : all) {
    CAPTURE(part.name);
    const std::vector<Slice> slices = cut(part.section, part.heights_mm);
    const std::vector<SplitLayer> layers = split(slices, settings_for(kWallMm));
    int loose_points = 0, solid_points = 0;
    for (std::size_t n = 0; n < slices.size(); ++n) {
      const core::Box box = slices[n].region.box();
      for (double x = box.min.x + 511; x < box.max.x; x += 2'357) {
        for (double y = box.min.y + 773; y < box.max.y; y += 2'741) {
          const core::Point at{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
          if (!slices[n].region.contains(at)) continue;
          const double distance = distance_to_outside(slices, n, at.x, at.y);
          if (std::abs(distance - wall) < kToleranceUnits) continue;
          CAPTURE(n);
          CAPTURE(at.x);
          CAPTURE(at.y);
          REQUIRE_EQ(layers[n].loose.contains(at), distance > wall);
          ++(distance > wall ? loose_points : solid_points);
        }
      }
    }
    CHECK_GT(solid_points, 20);
    const bool has_inside = part.name != "one layer" && part.name != "tube thinner than its walls";
    CHECK_EQ(loose_points > 0, has_inside);
  }
}

TEST_CASE("loose is the intersection of all offsets of the window, each at its depth") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Slice> slices;
    for (int n = 0; n < 9; ++n) {
      Slice slice;
      slice.index = n;
      slice.height = Length::from_mm(0.2);
      slice.bottom = slice.height * n;
      slice.region = test::random_region(random, 40, 12);
      slices.push_back(std::move(slice));
    }
    const Settings settings = settings_for(0.5);
    const std::vector<Length> depths = core::wall_depths(settings, Length::from_mm(0.2));
    REQUIRE_EQ(depths.size(), 3);
    const std::vector<SplitLayer> layers = split(slices, settings);
    core::OffsetCutter cutter(settings);
    std::vector<std::shared_ptr<const core::SliceOffsets>> offsets;
    for (const Slice& slice : slices) offsets.push_back(cutter.cut(slice));
    for (std::size_t n = 2; n < 7; ++n) {
      CAPTURE(n);
      Region expected = offsets[n]->wall_inners[0].region;
      for (const std::size_t away : {1u, 2u}) {
        expected = core::intersect(expected, offsets[n - away]->wall_inners[away].region);
        expected = core::intersect(expected, offsets[n + away]->wall_inners[away].region);
      }
      CHECK_LE(test::widest_difference(layers[n].loose, expected), 2);
      CHECK(test::is_clean(layers[n].loose));
      CHECK_LE(test::widest_difference(core::subtract(slices[n].region, expected), layers[n].solid),
               2);
    }
  }
}

TEST_CASE("slices that hardly move add nothing: the wall is that of all offsets all the same") {
  // Slices that drift, widen, narrow, and stand still; now and then one that is quite another.
  int operations = 0, all_operations = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Settings settings = settings_for(0.5);
    const Length height = Length::from_mm(0.08);
    const std::vector<Length> depths = core::wall_depths(settings, height);
    const Region start = test::random_region(random, 40, 12);
    std::vector<Slice> slices;
    for (int n = 0; n < 22; ++n) {
      Slice slice;
      slice.index = n;
      slice.height = height;
      slice.bottom = height * n;
      const int kind = random.integer(0, 5);
      const Region& last = n > 0 ? slices.back().region : start;
      slice.region = kind == 0   ? core::offset(last, Length::from_units(random.integer(-300, 300)),
                                                Length::from_units(25))
                     : kind == 1 ? core::intersect(last, test::random_region(random, 40, 12))
                                 : last;
      if (slice.region.empty()) slice.region = start;
      slices.push_back(std::move(slice));
    }
    const std::vector<SplitLayer> layers = split(slices, settings, &operations);
    for (std::size_t n = depths.size() - 1; n + depths.size() <= slices.size(); ++n) {
      CAPTURE(n);
      const Length tolerance = settings.arc_tolerance;
      Region expected = core::offset(slices[n].region, depths[0], tolerance);
      for (std::size_t away = 1; away < depths.size(); ++away) {
        for (const std::size_t other : {n - away, n + away}) {
          expected = core::intersect(expected,
                                     core::offset(slices[other].region, depths[away], tolerance));
          ++all_operations;
        }
      }
      CHECK_LE(test::widest_difference(layers[n].loose, expected), kToleranceUnits);
    }
  }
  MESSAGE(operations << " operations, " << all_operations << " with all slices");
  CHECK_LT(operations, all_operations / 2);
}

TEST_CASE("a ball's wall lies within the cylinder's, and grows with the thickness") {
  for (const Part& part : parts()) {
    if (part.name.find("unlike") != std::string::npos) continue;  // a cylinder counts layers
    CAPTURE(part.name);
    const std::vector<Slice> slices = cut(part.section, part.heights_mm);
    const auto ball = split(slices, settings_for(0.6));
    const auto cylinder = split(slices, settings_for(0.6, WallShape::kCylinder));
    const auto thicker = split(slices, settings_for(0.8));
    for (std::size_t n = 0; n < slices.size(); ++n) {
      CAPTURE(n);
      const auto beyond = [](const Region& inner, const Region& outer) {
        return test::widest_difference(core::subtract(inner, outer), Region());
      };
      CHECK_LE(beyond(cylinder[n].loose, ball[n].loose), kToleranceUnits);
      CHECK_LE(beyond(thicker[n].loose, ball[n].loose), kToleranceUnits);
    }
  }
}

TEST_CASE("turned by 90° and moved, the walls are turned and moved with the part") {
  const auto moved = [](const Region& region) {
    std::vector<core::Ring> rings = region.rings();
    for (core::Ring& ring : rings) {
      for (core::Point& point : ring) point = {-point.y + 1'234'567, point.x - 765'432};
    }
    return Region::from_clean_rings(std::move(rings));
  };
  for (const Part& part : parts()) {
    CAPTURE(part.name);
    std::vector<Slice> slices = cut(part.section, part.heights_mm), turned = slices;
    for (Slice& slice : turned) slice.region = moved(slice.region);
    for (const WallShape shape : {WallShape::kBall, WallShape::kCylinder}) {
      const auto upright = split(slices, settings_for(0.6, shape)),
                 away = split(turned, settings_for(0.6, shape));
      for (std::size_t n = 0; n < slices.size(); ++n) {
        CAPTURE(n);
        CHECK_LE(test::widest_difference(moved(upright[n].loose), away[n].loose), 2);
        CHECK_LE(test::widest_difference(moved(upright[n].solid), away[n].solid), 2);
      }
    }
  }
}

TEST_CASE("upside down, the same layers come in reverse") {
  // Without a bed of its own the part must stand clear of it: turn the slices, keep the heights.
  const std::vector<Part> all = parts();
  for (const Part& part : {all[2], all[5], all[6], all[8]}) {
    CAPTURE(part.name);
    std::vector<Slice> slices = cut(part.section, part.heights_mm), turned = slices;
    for (std::size_t n = 0; n < slices.size(); ++n) {
      turned[n].region = slices[slices.size() - 1 - n].region;
    }
    const auto upright = split(slices, settings_for(0.6)),
               reverse = split(turned, settings_for(0.6));
    for (std::size_t n = 0; n < slices.size(); ++n) {
      CAPTURE(n);
      CHECK_LE(test::widest_difference(upright[n].loose, reverse[slices.size() - 1 - n].loose), 2);
    }
  }
}

TEST_CASE("a prismatic part costs one mountain and no region operation between its caps") {
  const Settings settings = settings_for(0.6);
  WallSplitter splitter(settings);
  core::OffsetCutter cutter(settings);
  const std::vector<Slice> slices = cut([](double) { return disc(4); }, even_heights(40));
  std::int64_t loose = 0;
  const auto count = [&](const std::optional<SplitLayer>& layer) {
    if (layer.has_value() && !layer->loose.empty()) ++loose;
    return layer.has_value();
  };
  for (const Slice& slice : slices) count(splitter.push({slice, cutter.cut(slice)}));
  while (count(splitter.finish())) {
  }
  CHECK_EQ(cutter.reused(), 39);  // all but the first
  CHECK_EQ(loose, 34);
  CHECK_EQ(splitter.usage().operations, 0);
  CHECK_EQ(splitter.usage().layers_reused, 33);
  CHECK_LE(splitter.usage().layers_held_peak, 7);
}

TEST_CASE("depths: the thickness itself, then what Pythagoras leaves") {
  const Settings settings = settings_for(0.5);
  const std::vector<Length> depths = core::wall_depths(settings, Length::from_mm(0.2));
  REQUIRE_EQ(depths.size(), 3);
  CHECK_EQ(depths[0], Length::from_mm(0.5));
  CHECK_EQ(depths[1], Length::from_mm(std::sqrt(0.25 - 0.01)));
  CHECK_EQ(depths[2], Length::from_mm(0.4));  // 0.3² + 0.4² = 0.5²
  CHECK_EQ(core::wall_depths(settings_for(0.5, WallShape::kCylinder), Length::from_mm(0.2)).size(),
           1);
}

}  // namespace
