#include "core/sections/wall_regions.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "core/sections/wall_gauge.h"
#include "core/walls/wall_splitter.h"
#include "core/walls/wall_style.h"
#include "tests/support/layer_stacks.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::BuildStyle;
using core::Intervals;
using core::LayerWindow;
using core::Length;
using core::Region;
using core::SectionLine;
using core::Settings;
using core::SplitLayer;
using core::WallRegions;
using core::WallShape;
using test::LayerStack;

namespace {

// Three regions come of several operations each, every one rounded to the grid.
constexpr double kToleranceUnits = 4;

Settings settings_for(WallShape shape) {
  Settings settings;
  settings.wall_shape = shape;
  settings.perimeters = 1;
  return settings;
}

core::Slice slice_of(const LayerStack& stack, std::size_t n, double height_mm = 0.2) {
  core::Slice slice;
  slice.index = static_cast<core::LayerIndex>(n);
  slice.height = Length::from_mm(height_mm);
  slice.bottom = slice.height * slice.index;
  slice.region = stack.slices[n];
  return slice;
}

// Splits the stack, lets `edit` change each layer, and visits all as they become known.
void visit(const LayerStack& stack, const Settings& settings,
           const std::function<SplitLayer(SplitLayer)>& edit,
           const std::function<void(const LayerWindow&)>& look) {
  core::OffsetCutter cutter(settings);
  core::WallSplitter splitter(settings);
  LayerWindow window(settings);
  core::LayerIndex seen = 0;
  const auto look_at_all = [&] {
    while (window.next()) {
      REQUIRE_EQ(window.layer().slice.index, seen++);
      look(window);
    }
  };
  const auto take = [&](std::optional<SplitLayer> layer) {
    if (!layer) return false;
    window.push(edit(*std::move(layer)));
    look_at_all();
    return true;
  };
  for (std::size_t n = 0; n < stack.slices.size(); ++n) {
    core::Slice slice = slice_of(stack, n);
    auto offsets = cutter.cut(slice);
    take(splitter.push({std::move(slice), std::move(offsets)}));
    while (take(splitter.next())) {
    }
  }
  while (take(splitter.finish())) {
  }
  window.finish();
  look_at_all();
  CHECK_EQ(seen, static_cast<core::LayerIndex>(stack.slices.size()));
}

SplitLayer unchanged(SplitLayer layer) { return layer; }

std::vector<LayerStack> stacks() {
  std::vector<LayerStack> all = test::round_stacks(16, 0.8);
  all.push_back(test::wandering_stack(14, 7));
  all.push_back(test::wandering_stack(14, 8));
  all.push_back(test::prefix(test::wandering_stack(2, 9), 1));
  return all;
}

Region united(const WallRegions& regions) {
  return core::unite(core::unite(regions.own, regions.uncovered), regions.neighbours);
}

LayerStack half_ball(double radius_mm) {
  LayerStack stack{"half ball", {}, {}};
  for (double z = 0.1; z < radius_mm; z += 0.2) {
    const double radius = std::sqrt(radius_mm * radius_mm - z * z);
    core::Ring ring;
    for (int i = 0; i < 256; ++i) {
      const double angle = 2 * 3.14159265358979 * i / 256;
      ring.push_back(
          {static_cast<std::int32_t>(Length::from_mm(radius * std::cos(angle)).units()),
           static_cast<std::int32_t>(Length::from_mm(radius * std::sin(angle)).units())});
    }
    stack.slices.push_back(Region::from_clean_rings({ring}));
  }
  return stack;
}

SectionLine across_y(double mm) { return {SectionLine::Across::kY, Length::from_mm(mm)}; }

std::optional<core::ThinnestWall> thinnest(const LayerStack& stack, const Settings& settings,
                                           const SectionLine& line,
                                           const std::function<SplitLayer(SplitLayer)>& edit) {
  std::optional<core::ThinnestWall> found;
  visit(stack, settings, edit, [&](const LayerWindow& window) {
    const auto place = core::thinnest_wall(window, line);
    if (place && (!found || place->thickness_mm < found->thickness_mm)) found = place;
  });
  return found;
}

}  // namespace

TEST_CASE("the three regions are the wall, without overlap, for ball and cylinder") {
  for (const WallShape shape : {WallShape::kBall, WallShape::kCylinder}) {
    for (const LayerStack& stack : stacks()) {
      CAPTURE(stack.name);
      CAPTURE(static_cast<int>(shape));
      visit(stack, settings_for(shape), unchanged, [](const LayerWindow& window) {
        CAPTURE(window.layer().slice.index);
        const WallRegions regions = core::wall_regions(window);
        CHECK_LE(test::widest_difference(united(regions), window.layer().solid), kToleranceUnits);
        CHECK(regions.further.empty());
        const double sum =
            regions.own.area_mm2() + regions.uncovered.area_mm2() + regions.neighbours.area_mm2();
        CHECK_LT(std::abs(sum - window.layer().solid.area_mm2()), 1e-3);
        CHECK_LE(window.layers_held(), 9 + 1);
      });
    }
  }
}

TEST_CASE("each region is the paper's, less those before it") {
  const Settings settings = settings_for(WallShape::kCylinder);
  const int t = core::wall_layers(settings);
  REQUIRE_EQ(t, 4);
  for (const LayerStack& stack : stacks()) {
    CAPTURE(stack.name);
    const auto slice = [&](int i) {
      return 0 <= i && i < static_cast<int>(stack.slices.size())
                 ? stack.slices[static_cast<std::size_t>(i)]
                 : Region();
    };
    core::OffsetCutter cutter(settings);
    std::vector<Region> inners;
    for (std::size_t n = 0; n < stack.slices.size(); ++n) {
      const auto offsets = cutter.cut(slice_of(stack, n));
      inners.push_back(offsets->wall_inners.empty() ? Region()
                                                    : offsets->wall_inners.front().region);
    }
    const auto offset = [&](int i) {
      return slice(i).empty() ? Region()
                              : core::subtract(slice(i), inners[static_cast<std::size_t>(i)]);
    };
    visit(stack, settings, unchanged, [&](const LayerWindow& window) {
      const int n = static_cast<int>(window.layer().slice.index);
      CAPTURE(n);
      Region second, third;
      for (int i = 1; i <= t; ++i) {
        second = core::unite(second, core::subtract(slice(n + i - 1), slice(n + i)));
        second = core::unite(second, core::subtract(slice(n - i + 1), slice(n - i)));
        third = core::unite(third, core::unite(offset(n + i), offset(n - i)));
      }
      second = core::subtract(core::intersect(slice(n), second), offset(n));
      third = core::subtract(core::subtract(core::intersect(slice(n), third), offset(n)), second);
      const WallRegions regions = core::wall_regions(window);
      CHECK_LE(test::widest_difference(regions.own, offset(n)), kToleranceUnits);
      CHECK_LE(test::widest_difference(regions.uncovered, second), kToleranceUnits);
      CHECK_LE(test::widest_difference(regions.neighbours, third), kToleranceUnits);
    });
  }
}

TEST_CASE("what was made solid besides is told apart") {
  Settings settings = settings_for(WallShape::kBall);
  const LayerStack tube{
      "tube", std::vector<Region>(12, test::region_from_text("0:0 20:0 20:2 10:2 10:10 0:10")), {}};
  core::WallStyle style(settings);
  bool seen = false;
  Region before;
  const auto regularised = [&](SplitLayer layer) {
    before = layer.solid;
    return style.apply(std::move(layer));
  };
  visit(tube, settings, regularised, [&](const LayerWindow& window) {
    const WallRegions regions = core::wall_regions(window);
    const Region rest = core::subtract(window.layer().solid, united(regions));
    CHECK_LE(test::widest_difference(regions.further, rest), core::kFurtherWidthMin.units());
    // The tongue to the right is 0.4 mm wide and 10 mm long.
    if (!window.reaches_out()) {
      seen = true;
      CHECK_LT(std::abs(regions.further.area_mm2() - 4), 0.8);
    }
  });
  CHECK(seen);

  settings.style = BuildStyle::kRegular;
  core::WallStyle regular(settings);
  visit(
      tube, settings, [&](SplitLayer layer) { return regular.apply(std::move(layer)); },
      [](const LayerWindow& window) {
        CHECK_EQ(core::wall_regions(window).further, window.layer().slice.region);
        CHECK(core::wall_regions(window).own.empty());
      });
}

TEST_CASE("a section through the regions is the regions of the section") {
  test::Random random(5);
  for (const WallShape shape : {WallShape::kBall, WallShape::kCylinder}) {
    for (const LayerStack& stack : stacks()) {
      CAPTURE(stack.name);
      visit(stack, settings_for(shape), unchanged, [&](const LayerWindow& window) {
        const SectionLine line = across_y(random.between(-6, 6));
        CAPTURE(line.at.mm());
        CAPTURE(window.layer().slice.index);
        const WallRegions regions = core::wall_regions(window);
        const core::WallSection section = core::wall_section(window, line);
        const std::pair<const Region*, const Intervals*> pairs[] = {
            {&regions.own, &section.own},
            {&regions.uncovered, &section.uncovered},
            {&regions.neighbours, &section.neighbours},
            {&window.layer().loose, &section.loose}};
        double sum = 0;
        for (const auto& [region, intervals] : pairs) {
          const Intervals cut = core::section_of(*region, line);
          const Length off = core::total_length(core::subtract(cut, *intervals)) +
                             core::total_length(core::subtract(*intervals, cut));
          // A contour that runs along the line at a slope of 1:20 puts 2 units as 40.
          CHECK_LE(off.units(), 200);
          sum += core::total_length(*intervals).mm();
        }
        sum += core::total_length(section.further).mm();
        CHECK_LT(std::abs(sum - core::total_length(section.slice).mm()), 0.02);
      });
    }
  }
}

TEST_CASE("the wall of a half ball, measured where it is cut in the middle, is as thick as asked") {
  const LayerStack stack = half_ball(6);
  for (const double wall_mm : {0.6, 0.8, 1.3}) {
    CAPTURE(wall_mm);
    Settings settings = settings_for(WallShape::kBall);
    settings.wall_thickness = Length::from_mm(wall_mm);
    const auto place = thinnest(stack, settings, across_y(0), unchanged);
    REQUIRE(place.has_value());
    // The grid and the arcs' tolerance; chords of 256 to the circle.
    CHECK_GT(place->thickness_mm, wall_mm - 0.0028);
    CHECK_LT(place->thickness_mm, wall_mm + 0.0028);
    // And the thinner one, where the wall is thinner.
    const auto thinned = [](SplitLayer layer) {
      if (layer.slice.index == 11) {
        std::vector<core::Ring> rings = layer.loose.rings();
        for (core::Ring& ring : rings) {
          for (core::Point& point : ring) point.x += point.x > 0 ? 1'000 : 0;
        }
        layer.loose = Region::from_clean_rings(rings);
      }
      return layer;
    };
    const auto thinner = thinnest(stack, settings, across_y(0), thinned);
    REQUIRE(thinner.has_value());
    CHECK_LT(thinner->thickness_mm, wall_mm - 0.05);
    CHECK_GT(thinner->thickness_mm, wall_mm - 0.1028);
    CHECK_GT(thinner->loose_along, Length());
    CHECK_EQ(thinner->loose_height, Length::from_mm(2.3));
  }
  // The paper's cylinder is no thinner anywhere.
  const auto place = thinnest(stack, settings_for(WallShape::kCylinder), across_y(0), unchanged);
  REQUIRE(place.has_value());
  CHECK_GT(place->thickness_mm, 0.8 - 0.0028);
}

TEST_CASE("the gauge tells where it measured") {
  // A block of 20 layers with a pit from above, 2 mm deep: the way to its floor is the shortest.
  LayerStack stack{"pit", {}, {}};
  for (int n = 0; n < 20; ++n) {
    const std::string outer = "0:0 20:0 20:10 0:10";
    stack.slices.push_back(test::region_from_text(n < 10 ? outer : outer + ", 8:2 8:8 12:8 12:2"));
  }
  const auto lifted = [](SplitLayer layer) {
    if (layer.slice.index == 7) {
      layer.loose = Region::from_clean_rings({test::rectangle(1, 1, 19, 9)});
    }
    return layer;
  };
  const auto place = thinnest(stack, settings_for(WallShape::kBall), across_y(5), lifted);
  REQUIRE(place.has_value());
  CHECK_EQ(place->thickness_mm, doctest::Approx(0.5));
  CHECK_EQ(place->loose_height, Length::from_mm(1.5));
  CHECK_EQ(place->outside_height, Length::from_mm(2.0));
  CHECK_EQ(place->loose_along, Length::from_mm(10));
  CHECK_EQ(place->outside_along, Length::from_mm(10));
}
