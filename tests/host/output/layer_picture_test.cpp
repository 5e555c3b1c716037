#include "host/output/layer_picture.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/sections/layer_window.h"
#include "core/settings.h"
#include "tests/support/prism_window.h"
#include "tests/support/svg_text.h"

using core::Length;
using core::Road;
using core::RoadKind;
using test::count;
using test::square;
using test::window_in_prism;

TEST_CASE("a picture holds every road with its width, and a legend for every kind that is there") {
  const core::LayerWindow window = window_in_prism(core::Settings());
  const std::vector<Road> roads = {
      {RoadKind::kOuterPerimeter, Length::from_mm(0.45), true, square(2'250, 97'750)},
      {RoadKind::kLoose, Length::from_mm(0.5), false, {{10'000, 10'000}, {90'000, 90'000}}},
      {RoadKind::kLoose, Length::from_mm(0.5), false, {{10'000, 50'000}, {50'000, 90'000}}}};
  const std::string svg = host::draw_layer(
      {"a <part> & more", &window, &roads, host::layer_words(window.layer().slice, "a wall")});
  CHECK_EQ(count(svg, "stroke-width=\"0.45\""), 1);
  CHECK_EQ(count(svg, "stroke-width=\"0.5\""), 2);
  CHECK_EQ(count(svg, "outer perimeter, 0.45 mm wide, 38 mm"), 1);
  CHECK_EQ(count(svg, "loose fill, 0.50 mm wide, 17 mm"), 1);
  CHECK_EQ(count(svg, "skirt"), 0);
  CHECK_EQ(count(svg, "wall 36.0 mm² (36 %), inside 64.0 mm² (64 %)"), 1);
  // 0.8 mm within the edge; 0.2 mm more are solid, which the window does not ask for.
  CHECK_EQ(count(svg, "region 1: within 0.8 mm of the slice's own edge: 29.4 mm²"), 1);
  CHECK_EQ(count(svg, "region 2"), 0);
  CHECK_EQ(count(svg, "region 3"), 0);
  CHECK_EQ(count(svg, "made dense: 6.6 mm²"), 1);
  CHECK_EQ(count(svg, "layer 7, 1.2 to 1.4 mm"), 1);
  CHECK_EQ(count(svg, "a &lt;part&gt; &amp; more"), 1);
  CHECK_EQ(test::svg_fault(svg), "");
  CHECK_FALSE(test::has_odd_number(svg));
}

TEST_CASE("a layer without anything is a picture too") {
  core::LayerWindow window((core::Settings()));
  window.push({});
  window.finish();
  REQUIRE(window.next());
  const std::vector<Road> roads;
  const std::string svg = host::draw_layer({"empty", &window, &roads, "layer 1"});
  CHECK_EQ(test::svg_fault(svg), "");
  CHECK_FALSE(test::has_odd_number(svg));
}
