#include "host/part/layer_file.h"

#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <vector>

#include "host/formats/formats.h"
#include "host/part/part_file.h"
#include "tests/support/format_samples.h"
#include "tests/support/part_slices.h"
#include "tests/support/region_text.h"
#include "tests/support/temporary_folder.h"

using core::ErrorCode;
using core::Length;
using core::Settings;
using test::all_slices;

namespace {

std::string cli(const std::string& head, const std::string& layers) {
  return "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n" + head + "$$HEADEREND\n$$GEOMETRYSTART\n" + layers +
         "$$GEOMETRYEND\n";
}

std::string layer(const std::string& z, const std::string& x0, const std::string& x1) {
  return "$$LAYER/" + z + "\n$$POLYLINE/1,1,5," + x0 + ",2," + x1 + ",2," + x1 + ",6," + x0 +
         ",6," + x0 + ",2\n";
}

const std::string kTwoLayers =
    "$$LAYER/5\n" + layer("5.3", "-10", "10") + layer("5.5", "-10", "-2");

// As a pipe would come: once.
core::Result<host::OpenedPart> open_once(const std::string& bytes, const Settings& settings) {
  host::InputFile file = host::InputFile::from_bytes("pipe", bytes);
  const auto kind = host::kind_of(file);
  REQUIRE(kind.ok());
  auto layers = host::open_layers(kind.value(), std::move(file));
  REQUIRE(layers.ok());
  return host::open_layer_file({"pipe", std::move(layers).value(), {}}, settings);
}

Settings small_bed() {
  Settings settings;
  settings.bed_x = Length::from_mm(100);
  settings.bed_y = Length::from_mm(50);
  return settings;
}

}  // namespace

TEST_CASE("a file is read through first: centred, its height and layers known") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("part.cli", cli("", kTwoLayers));
  auto opened = host::open_whole_part(path, small_bed(), {});
  REQUIRE_MESSAGE(opened.ok(), (opened.ok() ? "" : opened.error().message));
  host::OpenedPart& part = opened.value();
  CHECK_EQ(part.summary.format, "ASCII CLI");
  CHECK_EQ(part.summary.layers, 2);
  CHECK_EQ(part.summary.height.mm(), 0.5);
  CHECK_EQ(part.summary.box, core::Box{{400'000, 230'000}, {600'000, 270'000}});
  CHECK(part.summary.warnings.empty());
  const std::vector<core::Slice> slices = all_slices(part);
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[0].bottom.mm(), 0);
  CHECK_EQ(slices[0].height.mm(), 0.3);
  CHECK_EQ(slices[0].region, test::region_from_text("40:23 60:23 60:27 40:27"));
  CHECK_EQ(slices[1].bottom.mm(), 0.3);
  CHECK_EQ(slices[1].region, test::region_from_text("40:23 48:23 48:27 40:27"));
}

TEST_CASE("a pipe whose head tells the extent is centred by it") {
  auto opened = open_once(cli("$$DIMENSION/-10,2,5,10,6,5.5\n", kTwoLayers), small_bed());
  REQUIRE_MESSAGE(opened.ok(), (opened.ok() ? "" : opened.error().message));
  CHECK(opened.value().summary.warnings.empty());
  CHECK_EQ(opened.value().summary.layers, 0);
  CHECK_EQ(all_slices(opened.value())[0].region, test::region_from_text("40:23 60:23 60:27 40:27"));
}

TEST_CASE("layers keep their own heights, and say so where others are asked for") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("part.cli", cli("", kTwoLayers));
  for (const bool ranges : {false, true}) {
    Settings settings = small_bed();
    settings.adaptive_layer_height = !ranges;
    if (ranges) settings.height_range = {"0-1 0.1"};
    auto file = host::open_whole_part(path, settings, {});
    auto pipe = open_once(cli("", kTwoLayers), settings);
    for (auto* opened : {&file, &pipe}) {
      REQUIRE_MESSAGE(opened->ok(), (opened->ok() ? "" : opened->error().message));
      const std::vector<std::string>& warnings = opened->value().summary.warnings;
      REQUIRE_FALSE(warnings.empty());
      CHECK(
          warnings[0].ends_with("its layers have heights of their own: adaptive_layer_height and "
                                "height_range change nothing"));
      CHECK_EQ(all_slices(opened->value())[0].height.mm(), 0.3);
    }
  }
}

TEST_CASE("any other pipe is where its first layer is, and says so") {
  Settings settings = small_bed();
  const std::string bytes =
      cli("$$LAYERS/3\n",
          "$$LAYER/0\n$$LAYER/0.2\n" + layer("0.4", "10", "30") + layer("0.6", "10", "20"));
  auto opened = open_once(bytes, settings);
  REQUIRE(opened.ok());
  CHECK_EQ(opened.value().summary.layers, 3);
  CHECK(opened.value().summary.box.empty());
  REQUIRE_EQ(opened.value().summary.warnings.size(), 1);
  CHECK(opened.value().summary.warnings[0].find("that of its first layer") != std::string::npos);
  const std::vector<core::Slice> slices = all_slices(opened.value());
  REQUIRE_EQ(slices.size(), 3);
  CHECK(slices[0].region.empty());
  CHECK_EQ(slices[1].region, test::region_from_text("40:23 60:23 60:27 40:27"));
  CHECK_EQ(slices[2].region, test::region_from_text("40:23 50:23 50:27 40:27"));
  CHECK_EQ(slices[2].bottom.mm(), doctest::Approx(0.4));
  settings.centre = false;
  settings.part_x = Length::from_mm(50);
  auto moved = open_once(bytes, settings);
  REQUIRE(moved.ok());
  CHECK_EQ(all_slices(moved.value())[1].region, test::region_from_text("50:0 70:0 70:4 50:4"));
}

TEST_CASE("a layer from a pipe that leaves the bed or the axis is an error there") {
  const auto last_error = [](const std::string& layers, const Settings& settings) {
    auto opened = open_once(cli("", layers), settings);
    REQUIRE(opened.ok());
    REQUIRE(opened.value().layers->next().ok());
    const auto second = opened.value().layers->next();
    REQUIRE_FALSE(second.ok());
    return second.error();
  };
  const core::Error off =
      last_error(layer("0.2", "10", "30") + layer("0.4", "90", "101"), small_bed());
  CHECK_EQ(off.code, ErrorCode::kOutOfBounds);
  CHECK(off.message.find("layer 2: the part would lie at 120 … 131") != std::string::npos);
  Settings low = small_bed();
  low.axis_z = Length::from_mm(0.3);
  const core::Error high = last_error(layer("0.2", "10", "30") + layer("0.4", "10", "30"), low);
  CHECK(high.message.find("axis") != std::string::npos);
}

TEST_CASE("empty layers on top are none, in a file and in a pipe; those in between are layers") {
  const test::TemporaryFolder folder;
  const std::string bytes = cli("", layer("0.2", "10", "30") + "$$LAYER/0.4\n" +
                                        layer("0.6", "10", "30") + "$$LAYER/0.8\n$$LAYER/1.0\n");
  auto file = host::open_whole_part(folder.write("part.cli", bytes), small_bed(), {});
  auto pipe = open_once(bytes, small_bed());
  REQUIRE(file.ok());
  REQUIRE(pipe.ok());
  CHECK_EQ(file.value().summary.layers, 3);
  CHECK_EQ(file.value().summary.height.mm(), doctest::Approx(0.6));
  for (host::OpenedPart* part : {&file.value(), &pipe.value()}) {
    const std::vector<core::Slice> slices = all_slices(*part);
    REQUIRE_EQ(slices.size(), 3);
    CHECK(slices[1].region.empty());
    CHECK_FALSE(slices[2].region.empty());
  }
}

TEST_CASE("layers that can't be printed are refused by number, before anything is printed") {
  const test::TemporaryFolder folder;
  const auto refusal = [&](const std::string& layers) {
    const auto opened =
        host::open_whole_part(folder.write("part.cli", cli("", layers)), small_bed(), {});
    REQUIRE_FALSE(opened.ok());
    return opened.error().message;
  };
  CHECK(refusal("$$LAYER/0\n" + layer("0.2", "0", "9") + layer("0.7", "0", "9"))
            .find("layer 2: it is 0.5 mm high, more than") != std::string::npos);
  CHECK(refusal("$$LAYER/0\n" + layer("0.01", "0", "9")).find("layer 1: it is 0.01 mm high") !=
        std::string::npos);
  CHECK(refusal("$$LAYER/0\n$$LAYER/0.2\n").find("nothing to print") != std::string::npos);
  CHECK(refusal(layer("0.2", "0", "101")).find("the part is 101 × 4 mm") != std::string::npos);
}

TEST_CASE("every kind is told by its content") {
  for (const host::FormatRow& row : host::formats()) {
    CAPTURE(row.name);
    CHECK((row.reads || row.writes));
  }
}

TEST_CASE("a binary STL is one, whatever its head begins with") {
  for (const std::string head :
       {"ASCII to binary", "o cube", "v 1.0 2.0", "(SIF_SFF 2 0", "# x", "(LSIF", "Slice V0"}) {
    CAPTURE(head);
    std::string bytes = head + std::string(80 - head.size(), ' ') + std::string("\1\0\0\0", 4);
    host::InputFile file = host::InputFile::from_bytes("part", bytes + std::string(50, '\0'));
    const auto kind = host::kind_of(file);
    REQUIRE(kind.ok());
    CHECK(kind.value() == host::FileKind::kStl);
  }
}

TEST_CASE("what is no kind of file is refused with what it looks like") {
  const auto refusal = [](const std::string& bytes) { return test::error_of(bytes); };
  CHECK(refusal(std::string("\xFF\xFEs\0o\0l\0", 8)).find("text in UTF-16") != std::string::npos);
  CHECK(refusal("ply\nformat ascii 1.0\n").find("text of no kind that is known") !=
        std::string::npos);
}
