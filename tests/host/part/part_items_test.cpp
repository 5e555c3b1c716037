// The items of a 3MF as objects: names, boxes, those that overlap, copies, and each by itself.
#include "host/part/part_items.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/part/object_sequence.h"
#include "host/part/part_file.h"
#include "host/part/plate.h"
#include "tests/support/marked_files.h"
#include "tests/support/part_folder.h"
#include "tests/support/part_slices.h"
#include "tests/support/run_program.h"

using core::Length;
using core::Settings;
using test::PartFolder;

namespace {

host::OpenedPart whole(core::Result<host::OpenedPart> opened) {
  auto part = host::read_whole(std::move(opened));
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return std::move(part).value();
}

std::string names_of(const host::OpenedPart& part) {
  std::string names;
  for (const host::PartObject& object : part.summary.objects) names += object.name + " ";
  return names;
}

double side_mm(const host::PartObject& object) {
  return Length::from_units(std::int64_t{object.box.max.x} - object.box.min.x).mm();
}

// Three things apart from one another: the second is the highest, the third stands in the middle.
std::string three_items() {
  return test::named_threemf(
      {{"Lid.stl", parts::box({0, 0, 0}, 20, 10, 4), "1 0 0 0 1 0 0 0 1 -30 0 0"},
       {"Tall one", parts::box({0, 0, 0}, 8, 8, 12), "1 0 0 0 1 0 0 0 1 30 5 0"},
       {"", parts::box({0, 0, 0}, 6, 9, 6), ""}});
}

}  // namespace

TEST_CASE("items of a 3MF are objects where they lie, named as there") {
  const PartFolder folder;
  const std::string path = folder.add_text("plate of three.3mf", three_items());
  const host::OpenedPart part = whole(host::open_part(path, Settings()));
  CHECK_EQ(names_of(part), "Lid_1 Tall_one_2 plate_of_three_3 ");
  const std::vector<host::PartObject>& objects = part.summary.objects;
  REQUIRE_EQ(objects.size(), 3);
  CHECK_EQ(side_mm(objects[0]), 20);
  CHECK_EQ(objects[0].height.mm(), 4);
  CHECK_EQ(side_mm(objects[1]), 8);
  CHECK_EQ(objects[1].height.mm(), 12);
  CHECK_EQ(objects[1].box.min.x - objects[0].box.min.x, Length::from_mm(60).units());
  core::Box all;
  for (const host::PartObject& object : objects) all.add(object.box);
  CHECK(all == part.summary.box);
  // A raft lifts them; as large as the part is, so are they.
  Settings settings;
  settings.raft_layers = 2;
  settings.part_scale = "2";
  const host::OpenedPart larger = whole(host::open_part(path, settings));
  REQUIRE_EQ(larger.summary.objects.size(), 3);
  CHECK_EQ(side_mm(larger.summary.objects[1]), 16);
  CHECK_EQ(larger.summary.objects[1].height, larger.summary.height);
}

TEST_CASE("names that slicers give to objects count") {
  const PartFolder folder;
  const std::string path = folder.add_text(
      "b.3mf", test::prusa_threemf({{parts::box({0, 0, 0}, 5, 5, 5), "ModelPart"}},
                                   {"", "1 0 0 0 1 0 0 0 1 20 0 0"}, {{"name", "Bolt M3.stl"}}));
  CHECK_EQ(names_of(whole(host::open_part(path, Settings()))), "Bolt_M3_1 Bolt_M3_2 ");
}

TEST_CASE("items whose boxes meet are one object") {
  const PartFolder folder;
  const auto objects_at = [&](const std::vector<std::string>& places) {
    std::vector<test::NamedItem> items;
    for (const std::string& place : places) {
      const std::string name(1, static_cast<char>('a' + items.size()));
      items.push_back(
          {name, parts::box({0, 0, 0}, 10, 10, 5), "1 0 0 0 1 0 0 0 1 " + place + " 0"});
    }
    const std::string path = folder.add_text("meet.3mf", test::named_threemf(items));
    return names_of(whole(host::open_part(path, Settings())));
  };
  CHECK_EQ(objects_at({"0 0", "20 0"}), "a_1 b_2 ");
  CHECK_EQ(objects_at({"0 0", "9 9"}), "");
  CHECK_EQ(objects_at({"0 0", "40 0", "9 9"}), "a_1 b_2 ");
  // The last one joins the first two, and so do boxes that only grow by it.
  CHECK_EQ(objects_at({"0 0", "18 0", "50 0", "9 5"}), "a_1 c_2 ");
  CHECK_EQ(objects_at({"0 0", "12 12", "24 24", "50 0", "6 6"}), "a_1 c_2 d_3 ");
  CHECK_EQ(objects_at({"0 0"}), "");
}

TEST_CASE("the slices are as before, and copies and other files have items, too") {
  const PartFolder folder;
  const std::string path = folder.add_text("three.3mf", three_items());
  const std::string box = folder.add("box.stl", parts::box({3, 4, 0}, 20, 10, 3));
  Settings settings;
  settings.copies = 2;
  host::OpenedPart part = whole(host::open_plate({path, box}, settings, {}));
  CHECK_EQ(names_of(part), "Lid_1 Tall_one_2 three_3 Lid_4 Tall_one_5 three_6 box_7 box_8 ");
  const std::vector<core::Slice> slices = test::all_slices(part);
  for (const core::Slice& slice : slices) {
    const double height_mm = slice.bottom.mm();
    double area_mm2 = 0;
    if (height_mm < 2.9) area_mm2 += 2 * 20 * 10;
    if (height_mm < 3.9) area_mm2 += 2 * 20 * 10;
    if (height_mm < 5.9) area_mm2 += 2 * 6 * 9;
    area_mm2 += 2 * 8 * 8;
    CHECK_EQ(slice.region.area_mm2(), doctest::Approx(area_mm2));
  }
}

TEST_CASE("items one after another: each by itself, the lowest first") {
  const PartFolder folder;
  const std::string path = folder.add_text("three.3mf", three_items());
  Settings settings;
  settings.sequential = true;
  const host::OpenedPart part = whole(host::open_sequence({path}, settings, {}));
  CHECK_EQ(names_of(part), "Lid_1 three_2 Tall_one_3 ");
  REQUIRE_EQ(part.sequence->size(), 3);
  core::LayerIndex layers = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    auto object = part.sequence->open(i);
    REQUIRE(object.ok());
    const std::vector<core::Slice> slices = test::all_slices(object.value());
    const host::PartObject& told = part.summary.objects[i];
    CHECK_EQ(slices.back().top().mm(), doctest::Approx(told.height.mm()));
    core::Box box;
    for (const core::Slice& slice : slices) box.add(slice.region.box());
    CHECK(box == told.box);
    layers += static_cast<core::LayerIndex>(slices.size());
  }
  CHECK_EQ(layers, part.summary.layers);
}

TEST_CASE("a file tells which item is printed, a plan lists them, and they are printed in turn") {
  const PartFolder folder;
  const std::string path = folder.add_text("three.3mf", three_items());
  const test::ProgramRun plan = test::rind("plan " + path);
  CHECK(test::says(plan, "objects    1 Lid_1, 2 Tall_one_2, 3 three_3"));
  const std::string gcode = folder.file("three.gcode");
  REQUIRE_EQ(test::rind("slice " + path + " --preset klipper --quiet -o " + gcode).exit_code, 0);
  const std::string text = test::content(gcode);
  CHECK_NE(text.find("EXCLUDE_OBJECT_DEFINE NAME=Tall_one_2"), std::string::npos);
  CHECK_NE(text.find("EXCLUDE_OBJECT_START NAME=Lid_1"), std::string::npos);
  CHECK_NE(text.find("; printing object three_3 id:2 copy 0"), std::string::npos);
  CHECK_NE(text.find("; thumbnail begin"), std::string::npos);
  REQUIRE_EQ(test::rind("slice " + path + " --sequential --quiet -o " + gcode).exit_code, 0);
  // Each once, in their order.
  const std::string in_turn = test::content(gcode);
  CHECK_NE(in_turn.find("; thumbnail begin"), std::string::npos);
  const std::size_t lid = in_turn.rfind("; printing object Lid_1 ");
  const std::size_t third = in_turn.find("; printing object three_2 ");
  CHECK_NE(lid, std::string::npos);
  CHECK_LT(lid, third);
  CHECK_LT(in_turn.rfind("; printing object three_2 "),
           in_turn.find("; printing object Tall_one_3 "));
}
