#include "host/formats/cli_writer.h"

#include <doctest/doctest.h>

#include <string>

#include "core/booleans/boolean.h"

TEST_CASE("walls and insides are closed polylines, outer ones counter-clockwise") {
  core::SplitLayer layer;
  layer.slice.bottom = core::Length::from_mm(0.4);
  layer.slice.height = core::Length::from_mm(0.2);
  layer.loose =
      core::Region::from_clean_rings({{{10'000, 10'000}, {20'000, 10'000}, {20'000, 20'000}}});
  layer.solid =
      core::Region::from_clean_rings({{{0, 0}, {40'000, 0}, {40'000, 30'005}},
                                      {{20'000, 20'000}, {20'000, 10'000}, {10'000, 10'000}}});
  host::LayerFileHead head;
  head.layers = 3;
  const auto writer = host::cli_writer(host::CliKind::kText, head);
  std::string text;
  writer->begin(text);
  writer->layer(layer, {}, text);
  writer->end(text);
  CHECK_EQ(text,
           "$$HEADERSTART\n$$ASCII\n$$UNITS/1.0\n$$VERSION/200\n$$LAYERS/3\n"
           "$$LABEL/1,\"solid\"\n$$LABEL/2,\"loose\"\n$$HEADEREND\n$$GEOMETRYSTART\n"
           "$$LAYER/0.6\n"
           "$$POLYLINE/1,1,4,0.0,0.0,4.0,0.0,4.0,3.0005,0.0,0.0\n"
           "$$POLYLINE/1,0,4,2.0,2.0,2.0,1.0,1.0,1.0,2.0,2.0\n"
           "$$POLYLINE/2,1,4,1.0,1.0,2.0,1.0,2.0,2.0,1.0,1.0\n"
           "$$GEOMETRYEND\n");
}
