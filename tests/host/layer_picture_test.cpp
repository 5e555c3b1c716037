#include "host/layer_picture.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "core/boolean.h"

using core::Length;
using core::Road;
using core::RoadKind;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

core::Ring square(std::int32_t low, std::int32_t high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

core::SplitLayer split_square() {
  core::SplitLayer layer;
  layer.layer.slice.index = 6;
  layer.layer.slice.bottom = Length::from_mm(1.2);
  layer.layer.slice.height = Length::from_mm(0.2);
  layer.layer.slice.region = core::Region::from_clean_rings({square(0, 100'000)});
  layer.loose = core::Region::from_clean_rings({square(10'000, 90'000)});
  layer.solid = core::subtract(layer.layer.slice.region, layer.loose);
  return layer;
}

}  // namespace

TEST_CASE("a picture holds every road with its width, and a legend for every kind that is there") {
  const core::SplitLayer layer = split_square();
  const std::vector<Road> roads = {
      {RoadKind::kOuterPerimeter, Length::from_mm(0.45), true, square(2'250, 97'750)},
      {RoadKind::kLoose, Length::from_mm(0.5), false, {{10'000, 10'000}, {90'000, 90'000}}},
      {RoadKind::kLoose, Length::from_mm(0.5), false, {{10'000, 50'000}, {50'000, 90'000}}}};
  const std::string svg = host::draw_layer({"a <part> & more", &layer, &roads});
  CHECK_EQ(count(svg, "stroke-width=\"0.45\""), 1);
  CHECK_EQ(count(svg, "stroke-width=\"0.5\""), 2);
  CHECK_EQ(count(svg, "outer perimeter, 0.45 mm wide, 38 mm"), 1);
  CHECK_EQ(count(svg, "loose fill, 0.50 mm wide, 17 mm"), 1);
  CHECK_EQ(count(svg, "skirt"), 0);
  CHECK_EQ(count(svg, "36.0 mm² (36 %)"), 1);
  CHECK_EQ(count(svg, "64.0 mm² (64 %)"), 1);
  CHECK_EQ(count(svg, "layer 7, 1.2 to 1.4 mm"), 1);
  CHECK_EQ(count(svg, "a &lt;part&gt; &amp; more"), 1);
  // Every element that is opened is closed.
  CHECK_EQ(count(svg, "<g"), count(svg, "</g>"));
  CHECK_EQ(count(svg, "<text"), count(svg, "</text>"));
  CHECK_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST_CASE("a layer without anything is a picture too") {
  const core::SplitLayer layer;
  const std::vector<Road> roads;
  CHECK_EQ(count(host::draw_layer({"empty", &layer, &roads}), "</svg>"), 1);
}
