#include "host/part/object_sequence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/part/arrangement.h"
#include "host/part/part_file.h"
#include "tests/support/part_folder.h"
#include "tests/support/part_slices.h"

using core::Length;
using core::Settings;
using test::PartFolder;

namespace {

struct Files {
  PartFolder folder;
  std::string low = folder.add("low.stl", parts::box({3, 4, 0}, 20, 10, 4));
  std::string middle = folder.add("middle.stl", parts::dome(9, 64, 32));
  std::string high = folder.add("high one.stl", parts::box({0, 0, 0}, 8, 9, 30));
};

Settings sequential() {
  Settings settings;
  settings.sequential = true;
  return settings;
}

host::OpenedPart sequence_of(const std::vector<std::string>& paths, const Settings& settings) {
  auto part = host::read_whole(host::open_sequence(paths, settings, {}));
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return std::move(part).value();
}

std::string why_refused(const std::vector<std::string>& paths, const Settings& settings) {
  const auto part = host::read_whole(host::open_sequence(paths, settings, {}));
  return part.ok() ? "" : part.error().message;
}

bool says(const std::string& message, const std::string& what) {
  return message.find(what) != std::string::npos;
}

// The part alone, put where the object lies.
std::vector<core::Slice> alone(const std::string& path, Settings settings,
                               const host::PartObject& object) {
  settings.centre = false;
  settings.part_x = Length::from_units(object.box.min.x);
  settings.part_y = Length::from_units(object.box.min.y);
  auto part = host::open_whole_part(path, settings);
  REQUIRE(part.ok());
  return test::all_slices(part.value());
}

std::int64_t gap_between(const core::Box& a, const core::Box& b) {
  return std::max({std::int64_t{a.min.x} - b.max.x, std::int64_t{b.min.x} - a.max.x,
                   std::int64_t{a.min.y} - b.max.y, std::int64_t{b.min.y} - a.max.y});
}

}  // namespace

TEST_CASE("the lowest object comes first, and each is the part alone") {
  const Files files;
  const std::vector<std::string> by_height{files.low, files.middle, files.high};
  const Settings settings = sequential();
  const host::OpenedPart part = sequence_of({files.high, files.middle, files.low}, settings);
  REQUIRE(part.sequence != nullptr);
  const std::vector<host::PartObject>& objects = part.summary.objects;
  REQUIRE_EQ(objects.size(), 3);
  CHECK_EQ(objects[0].name, "low_1");
  CHECK_EQ(objects[1].name, "middle_2");
  CHECK_EQ(objects[2].name, "high_one_3");
  CHECK_EQ(part.summary.height.mm(), doctest::Approx(30));
  core::LayerIndex before = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    CAPTURE(i);
    CHECK_EQ(part.sequence->layers_before(i), before);
    auto opened = part.sequence->open(i);
    REQUIRE(opened.ok());
    CHECK(opened.value().summary.box == objects[i].box);
    const std::vector<core::Slice> slices = test::all_slices(opened.value());
    const std::vector<core::Slice> wanted = alone(by_height[i], settings, objects[i]);
    REQUIRE_EQ(slices.size(), wanted.size());
    for (std::size_t layer = 0; layer < slices.size(); ++layer) {
      CHECK(slices[layer].region == wanted[layer].region);
      CHECK_EQ(slices[layer].index, wanted[layer].index);
      CHECK_EQ(part.sequence->of_layer(before + slices[layer].index), i);
    }
    before += static_cast<core::LayerIndex>(slices.size());
  }
  CHECK_EQ(part.summary.layers, before);
}

TEST_CASE("the print head has room between any two objects") {
  const Files files;
  Settings settings = sequential();
  settings.copies = 3;
  settings.clearance_height = Length::from_mm(100);
  for (const double brim_mm : {0.0, 8.0}) {
    settings.brim_width = Length::from_mm(brim_mm);
    const host::OpenedPart part = sequence_of({files.low, files.high}, settings);
    const std::vector<host::PartObject>& objects = part.summary.objects;
    REQUIRE_EQ(objects.size(), 6);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        CHECK_GE(gap_between(objects[i].box, objects[k].box),
                 (settings.clearance_radius + settings.brim_width).units());
      }
    }
  }
  settings.sequential = false;
  CHECK_LT(host::object_gap(settings), settings.clearance_radius);
}

TEST_CASE("what would hit the gantry, or can't be done in turn, is refused with the reason") {
  const Files files;
  Settings settings = sequential();
  const std::string both_high = why_refused({files.high, files.high}, settings);
  CHECK(says(both_high, "high_one_1 is 30 mm high, high_one_2 30 mm"));
  CHECK(says(both_high, "clearance_height = 20 mm"));
  // One that is just as high as the gantry is passed.
  settings.clearance_height = Length::from_mm(30);
  CHECK_EQ(why_refused({files.high, files.high}, settings), "");
  CHECK(says(why_refused({files.low, "-"}, settings), "standard input"));
  CHECK(says(why_refused({files.low, files.folder.file("nothing.stl")}, settings), "nothing.stl"));
  settings.clearance_radius = Length::from_mm(300);
  CHECK(says(why_refused({files.low, files.high}, settings), "smaller clearance_radius"));
  settings = sequential();
  settings.at_height = {"2 pause"};
  CHECK(says(why_refused({files.low, files.high}, settings), "at_height"));
}
