#include "host/output/section_picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/offsets/slice_offsets.h"
#include "core/sections/layer_window.h"
#include "core/walls/wall_splitter.h"
#include "tests/support/region_text.h"
#include "tests/support/svg_text.h"

using core::LayerWindow;
using core::Length;
using core::Region;
using core::Settings;
using host::SectionPicture;
using test::count;

namespace {

struct Drawn {
  std::string svg;
  std::size_t longest_piece = 0;  // of the text that one layer gave
  std::size_t layers_held_peak = 0;
  double solid_mm2 = 0, loose_mm2 = 0;
  double thinnest_mm = 0;
  bool shows_roads = false;
};

using View = SectionPicture::View;

SectionPicture::Options options_for(const Settings& settings, double width_mm, int layers) {
  SectionPicture::Options options;
  options.title = "a <part> & more";
  options.subtitle = "cut somewhere";
  options.line = {core::SectionLine::Across::kY, Length::from_mm(5)};
  options.box = {{0, 0}, {static_cast<std::int32_t>(Length::from_mm(width_mm).units()), 100'000}};
  options.height = settings.layer_height * layers;
  options.settings = settings;
  return options;
}

// A block of this width, 10 mm deep, through the splitter and the window into a picture; each
// layer has one road along its front and one that is cut across.
Drawn draw_block(const Settings& settings, double width_mm, int layers,
                 const std::optional<View>& view = std::nullopt) {
  SectionPicture::Options options = options_for(settings, width_mm, layers);
  options.view = view;
  SectionPicture picture(std::move(options));
  core::OffsetCutter cutter(settings);
  core::WallSplitter splitter(settings);
  LayerWindow window(settings);
  const Region block = Region::from_clean_rings({test::rectangle(0, 0, width_mm, 10)});
  const std::vector<core::Road> roads = {
      {core::RoadKind::kOuterPerimeter, Length::from_mm(0.4), false, {{2'000, 0}, {2'000, 90'000}}},
      {core::RoadKind::kSkirt, Length::from_mm(0.4), false, {{-9'000, 0}, {-9'000, 90'000}}}};
  Drawn drawn;
  drawn.shows_roads = picture.shows_roads();
  drawn.svg = picture.start();
  const auto draw = [&] {
    while (window.next()) {
      const std::string piece = picture.layer(window);
      drawn.longest_piece = std::max(drawn.longest_piece, piece.size());
      drawn.svg += piece;
    }
    drawn.layers_held_peak = std::max(drawn.layers_held_peak, window.layers_held());
  };
  const auto take = [&](std::optional<core::SplitLayer> layer) {
    if (!layer) return false;
    if (picture.shows_roads()) drawn.svg += picture.roads(layer->slice, roads);
    window.push(*std::move(layer));
    draw();
    return true;
  };
  for (int n = 0; n < layers; ++n) {
    core::Slice slice{n, settings.layer_height * n, settings.layer_height, block, {}};
    auto offsets = cutter.cut(slice);
    take(splitter.push({std::move(slice), std::move(offsets)}));
    while (take(splitter.next())) {
    }
  }
  while (take(splitter.finish())) {
  }
  window.finish();
  draw();
  drawn.svg += picture.end();
  drawn.solid_mm2 = picture.solid_mm2();
  drawn.loose_mm2 = picture.loose_mm2();
  drawn.thinnest_mm = picture.thinnest() ? picture.thinnest()->thickness_mm : 0;
  return drawn;
}

}  // namespace

TEST_CASE("a block's cut: areas, thickness, legend, a bead for each road and layer") {
  const Drawn drawn = draw_block(Settings(), 20, 50);
  CHECK_EQ(test::svg_fault(drawn.svg), "");
  CHECK_FALSE(test::has_odd_number(drawn.svg));
  CHECK_EQ(count(drawn.svg, "a &lt;part&gt; &amp; more"), 1);
  // 200 mm²; within 0.8 mm of the edge on every side is wall.
  CHECK_EQ(drawn.solid_mm2 + drawn.loose_mm2, doctest::Approx(200));
  CHECK_EQ(drawn.loose_mm2, doctest::Approx(18.4 * 8.4));
  CHECK_EQ(count(drawn.svg, "wall 45.4 mm² (23 %), inside 154.6 mm² (77 %)"), 1);
  CHECK_LT(std::abs(drawn.thinnest_mm - 0.8), 0.0028);
  CHECK_EQ(count(drawn.svg, "thinnest wall in the whole cut: 0.800 mm"), 1);
  CHECK_EQ(count(drawn.svg, "region 1"), 1);
  CHECK_EQ(count(drawn.svg, "region 2"), 1);
  // Its sides are upright: the slices around have no edge that its own has not.
  CHECK_EQ(count(drawn.svg, "region 3"), 0);
  CHECK_EQ(count(drawn.svg, "made dense"), 0);
  REQUIRE(drawn.shows_roads);
  CHECK_EQ(count(drawn.svg, ">outer perimeter</text>"), 1);
  CHECK_EQ(count(drawn.svg, "stroke=\"#c8502f\" stroke-width=\"5.92\""), 50);
  CHECK_EQ(count(drawn.svg, "skirt"), 0);
}

TEST_CASE("rows that look the same are one, and what is held does not grow") {
  const Drawn low = draw_block(Settings(), 4, 300), tall = draw_block(Settings(), 4, 3'000);
  CHECK_FALSE(tall.shows_roads);
  CHECK_EQ(test::svg_fault(tall.svg), "");
  CHECK_EQ(low.layers_held_peak, tall.layers_held_peak);
  CHECK_LE(tall.layers_held_peak, 2 * core::wall_layers(Settings()) + 2);
  // Three runs: the bed's wall, the inside, the top's.
  CHECK_EQ(count(tall.svg, "<path fill=\"#"), 2 + 2 + 2);
  CHECK_LE(tall.svg.size(), low.svg.size() + 100);
  CHECK_LE(tall.longest_piece, 1'000);
}

TEST_CASE("a view draws what lies in it, and measures all") {
  // A corner: 3 mm from the left, from 1 to 4 mm above the bed.
  const View view{{-5'000, 30'000}, Length::from_mm(1), Length::from_mm(4)};
  const Drawn drawn = draw_block(Settings(), 20, 50, view);
  CHECK_EQ(test::svg_fault(drawn.svg), "");
  CHECK_EQ(drawn.loose_mm2, doctest::Approx(18.4 * 8.4));
  // No layer of the bed's wall, 15 layers' beads, and one run of rows.
  CHECK_EQ(count(drawn.svg, ">region 2"), 0);
  CHECK_EQ(count(drawn.svg, "fill=\"none\" stroke-linecap=\"round\"/>\n"), 15);
  CHECK_EQ(count(drawn.svg, "<path fill=\"#"), 2);
}

TEST_CASE("where the style decides, nothing is said of regions and balls") {
  Settings regular;
  regular.style = core::BuildStyle::kRegular;
  const Drawn drawn = draw_block(regular, 20, 50);
  CHECK_EQ(count(drawn.svg, ">filled densely</text>"), 1);
  CHECK_EQ(count(drawn.svg, "region"), 0);
  CHECK_EQ(count(drawn.svg, "balls"), 0);
  CHECK_EQ(count(draw_block(Settings(), 20, 50).svg, ">balls, 0.8 mm in radius"), 1);
}

TEST_CASE("odd parts are pictures too") {
  Settings cylinder;
  cylinder.wall_shape = core::WallShape::kCylinder;
  for (const Settings& settings : {Settings(), cylinder}) {
    for (const double width_mm : {0.05, 1.0, 20.0, 1'000.0}) {
      for (const int layers : {1, 2, 60}) {
        CAPTURE(width_mm);
        CAPTURE(layers);
        const Drawn drawn = draw_block(settings, width_mm, layers);
        CHECK_EQ(test::svg_fault(drawn.svg), "");
        CHECK_FALSE(test::has_odd_number(drawn.svg));
        CHECK_EQ(drawn.solid_mm2 + drawn.loose_mm2,
                 doctest::Approx(width_mm * 0.2 * layers).epsilon(1e-3));
      }
    }
  }
}
