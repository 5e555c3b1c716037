// What is written is read back, region by region, and writing that again gives the same bytes.
#include <doctest/doctest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"
#include "host/formats/cli_writer.h"
#include "host/formats/lsif_writer.h"
#include "host/formats/slice_v0_writer.h"
#include "host/formats/svg_writer.h"
#include "tests/support/format_samples.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"

using core::Length;
using core::SplitLayer;
using host::LayerContents;
using host::LayerFileHead;

namespace {

struct Writer {
  const char* name;
  const char* format;  // as the reader calls it
  std::function<std::unique_ptr<host::LayerWriter>(const LayerFileHead&)> make;
};

const std::vector<Writer>& writers() {
  static const std::vector<Writer> all = {
      {"cli", "ASCII CLI",
       [](const LayerFileHead& head) { return host::cli_writer(host::CliKind::kText, head); }},
      {"cli-binary", "binary CLI",
       [](const LayerFileHead& head) { return host::cli_writer(host::CliKind::kBinary, head); }},
      {"lsif", "L-SIF", host::lsif_writer},
      {"ssl", "Slice V0", host::slice_v0_writer},
      {"svg", "SVG layers", host::svg_writer},
  };
  return all;
}

// Layers of several heights, the first one thicker, an empty one among them; each with an inside.
std::vector<SplitLayer> random_layers(test::Random& random, std::size_t count) {
  std::vector<SplitLayer> layers(count);
  Length bottom;
  for (std::size_t i = 0; i < count; ++i) {
    core::Slice& slice = layers[i].slice;
    slice.index = static_cast<core::LayerIndex>(i);
    slice.bottom = bottom;
    slice.height = Length::from_units(i == 0 ? 3'000 : random.integer(1'500, 2'500));
    bottom = slice.top();
    if (i != 2) slice.region = test::random_region(random, 60, 40);
    layers[i].loose = core::intersect(slice.region, test::random_region(random, 60, 40));
    layers[i].solid = core::subtract(slice.region, layers[i].loose);
  }
  return layers;
}

std::string written(const Writer& writer, LayerContents contents,
                    const std::vector<SplitLayer>& layers) {
  LayerFileHead head;
  head.layers = static_cast<core::LayerIndex>(layers.size());
  head.layer_height = Length::from_units(2'000);
  head.bed_x = head.bed_y = Length::from_mm(300);
  head.contents = contents;
  const std::unique_ptr<host::LayerWriter> file = writer.make(head);
  std::string text;
  file->begin(text);
  for (const SplitLayer& layer : layers) file->layer(layer, {}, text);
  file->end(text);
  return text;
}

std::vector<SplitLayer> as_layers(const std::vector<core::Slice>& slices) {
  std::vector<SplitLayer> layers(slices.size());
  for (std::size_t i = 0; i < slices.size(); ++i) {
    layers[i].slice = slices[i];
    layers[i].solid = slices[i].region;
  }
  return layers;
}

}  // namespace

TEST_CASE("slices come back as they were, and are written again byte for byte") {
  for (const Writer& writer : writers()) {
    CAPTURE(writer.name);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      test::Random random(seed);
      const std::vector<SplitLayer> layers = random_layers(random, 6);
      const std::string text = written(writer, LayerContents::kSlices, layers);
      const core::Result<test::ReadFile> read = test::read_bytes(text);
      REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
      CHECK_EQ(read.value().format, writer.format);
      CHECK(read.value().warnings.empty());
      REQUIRE_EQ(read.value().slices.size(), layers.size());
      for (std::size_t i = 0; i < layers.size(); ++i) {
        const core::Slice &was = layers[i].slice, &is = read.value().slices[i];
        CAPTURE(i);
        CHECK_EQ(is.index, was.index);
        CHECK_EQ(is.bottom.units(), was.bottom.units());
        CHECK_EQ(is.height.units(), was.height.units());
        CHECK_EQ(is.region, was.region);
      }
      CHECK_EQ(written(writer, LayerContents::kSlices, as_layers(read.value().slices)), text);
    }
  }
}

TEST_CASE("a wall and its inside are the part") {
  for (const LayerContents contents : {LayerContents::kWalls, LayerContents::kWallsForQuickSlice}) {
    for (const Writer& writer : writers()) {
      CAPTURE(writer.name);
      for (unsigned seed = 1; seed <= 10; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const std::vector<SplitLayer> layers = random_layers(random, 4);
        const auto read = test::read_bytes(written(writer, contents, layers));
        REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
        REQUIRE_EQ(read.value().slices.size(), layers.size());
        for (std::size_t i = 0; i < layers.size(); ++i) {
          CHECK(test::widest_difference(read.value().slices[i].region, layers[i].slice.region) <=
                2);
        }
      }
    }
  }
}

TEST_CASE("for QuickSlice, both copies of a shared contour stand among the inside's") {
  SplitLayer layer;
  layer.slice.height = Length::from_mm(0.254);
  const core::Ring outer = {{0, 0}, {762'000, 0}, {762'000, 762'000}, {0, 762'000}};
  const core::Ring inner = {{254'000, 254'000}, {508'000, 254'000}, {508'000, 508'000}};
  layer.loose = core::Region::from_clean_rings({inner});
  layer.slice.region = core::Region::from_clean_rings({outer});
  layer.solid = core::subtract(layer.slice.region, layer.loose);
  const Writer& ssl = writers()[3];
  const std::string text = written(ssl, LayerContents::kWallsForQuickSlice, {layer});
  CHECK_EQ(text,
           "Slice V0\nFILE(rind,UNITS(INCH))\nSLICES()\nZ 0.0 0.01\n"
           "0.0 3.0\n3.0 3.0\n3.0 0.0\n0.0 0.0\nC\n"
           "2.0 1.0\n2.0 2.0\n1.0 1.0\nC\n2.0 2.0\n2.0 1.0\n1.0 1.0\nC\nEND\n");
}

TEST_CASE("roads are hatches, a label for each kind") {
  LayerFileHead head;
  head.layers = 1;
  const auto writer = host::cli_writer(host::CliKind::kRoads, head);
  CHECK(writer->wants_roads());
  core::Road open, closed;
  open.kind = core::RoadKind::kLoose;
  open.points = {{0, 0}, {10'000, 0}, {10'000, 5'000}};
  closed.kind = core::RoadKind::kOuterPerimeter;
  closed.closed = true;
  closed.points = {{0, 0}, {10'000, 0}, {10'000, 5'000}};
  SplitLayer layer;
  layer.slice.height = Length::from_mm(0.2);
  std::string text;
  writer->begin(text);
  text.clear();
  writer->layer(layer, {open, closed}, text);
  CHECK_EQ(text,
           "$$LAYER/0.2\n$$HATCHES/6,2,0.0,0.0,1.0,0.0,1.0,0.0,1.0,0.5\n"
           "$$HATCHES/2,3,0.0,0.0,1.0,0.0,1.0,0.0,1.0,0.5,1.0,0.5,0.0,0.0\n");
}
