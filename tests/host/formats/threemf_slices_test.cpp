// 3MF's slice extension: objects that are stacks of slices.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "core/units.h"
#include "host/part/part_file.h"
#include "tests/support/format_samples.h"
#include "tests/support/mesh_files.h"
#include "tests/support/region_text.h"
#include "tests/support/temporary_folder.h"

using core::Slice;
using test::region_from_text;

namespace {

const std::string kNames =
    " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
    "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\"";

std::string model(const std::string& resources, const std::string& build,
                  const std::string& unit = "millimeter") {
  return "<model unit=\"" + unit + "\" requiredextensions=\"s\"" + kNames + "><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

std::string slice(const std::string& ztop, const std::string& polygons) {
  return "<s:slice ztop=\"" + ztop +
         "\"><s:vertices><s:vertex x=\"0\" y=\"0\"/><s:vertex x=\"8\" y=\"0\"/>"
         "<s:vertex x=\"0\" y=\"8\"/><s:vertex x=\"1\" y=\"1\"/><s:vertex x=\"1\" y=\"3\"/>"
         "<s:vertex x=\"3\" y=\"1\"/></s:vertices>" +
         polygons + "</s:slice>";
}

std::string polygon(const std::string& start, const std::vector<std::string>& others) {
  std::string text = "<s:polygon startv=\"" + start + "\">";
  for (const std::string& other : others) text += "<s:segment v2=\"" + other + "\"/>";
  return text + "</s:polygon>";
}

const std::string kOuter = polygon("0", {"1", "2", "0"});
const std::string kHole = polygon("3", {"4", "5", "3"});

std::string stack(const std::string& slices, const std::string& id = "5",
                  const std::string& more = "") {
  return "<s:slicestack id=\"" + id + "\"" + more + ">" + slices + "</s:slicestack>";
}

// Two layers, with a hole in the second.
const std::string kStack =
    stack(slice("1.2", kOuter) + slice("1.5", kOuter + kHole), "5", " zbottom=\"1\"");

std::string sliced_object(const std::string& id, const std::string& stack_id = "5") {
  return "<object id=\"" + id + "\" s:slicestackid=\"" + stack_id +
         "\" s:meshresolution=\"lowres\"><mesh><vertices/><triangles/></mesh></object>";
}

std::string item(const std::string& id, const std::string& transform = "") {
  return "<item objectid=\"" + id + "\"" +
         (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

std::vector<Slice> slices_of(const std::string& text) {
  const auto read = test::read_bytes(test::threemf_file(text));
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  CHECK_EQ(read.value().format, "3MF slices");
  return read.value().slices;
}

void check_refused(const std::string& text, const std::string& part) {
  const std::string message = test::error_of(test::threemf_file(text));
  CAPTURE(message);
  CHECK(message.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("slices with holes, heights of their own, in the model's unit") {
  const std::vector<Slice> slices = slices_of(model(kStack + sliced_object("1"), item("1")));
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[0].bottom.mm(), 1);
  CHECK_EQ(slices[0].height.mm(), doctest::Approx(0.2));
  CHECK_EQ(slices[1].height.mm(), doctest::Approx(0.3));
  CHECK_EQ(slices[0].region, region_from_text("0:0 8:0 0:8"));
  CHECK_EQ(slices[1].region, region_from_text("0:0 8:0 0:8, 1:1 1:3 3:1"));
  const auto inches = slices_of(model(kStack + sliced_object("1"), item("1"), "inch"));
  CHECK_EQ(inches[0].bottom.mm(), doctest::Approx(25.4));
  CHECK_EQ(inches[0].region, region_from_text("0:0 203.2:0 0:203.2"));
}

TEST_CASE("items are moved, turned and mirrored, and united at each height") {
  const std::string resources = kStack + sliced_object("1");
  const std::vector<Slice> slices = slices_of(model(
      resources, item("1", "0 1 0 -1 0 0 0 0 1 20 0 2") + item("1", "-1 0 0 0 1 0 0 0 1 40 0 2") +
                     item("1", "1 0 0 0 1 0 0 0 1 60 0 2.5")));
  REQUIRE_EQ(slices.size(), 4);
  CHECK_EQ(slices[0].bottom.mm(), 3);
  CHECK_EQ(slices[0].region, region_from_text("12:0 20:0 20:8, 32:0 40:0 40:8"));
  CHECK_EQ(slices[2].bottom.mm(), doctest::Approx(3.5));
  CHECK_EQ(slices[2].region, region_from_text("60:0 68:0 60:8"));
  const auto doubled = slices_of(model(resources, item("1") + item("1")));
  CHECK_EQ(doubled[1].region, region_from_text("0:0 8:0 0:8, 1:1 1:3 3:1"));
}

TEST_CASE("a stack may be references to stacks in other parts, with units of their own") {
  const std::string root =
      model(stack("<s:sliceref slicestackid=\"7\" slicepath=\"/2D/a.model\"/>"
                  "<s:sliceref slicestackid=\"8\" slicepath=\"/2D/a.model\"/>") +
                sliced_object("1"),
            item("1"));
  const std::string parts =
      model(stack(slice("0.02", kOuter), "7") + stack(slice("0.05", kHole + kOuter), "8"), "",
            "centimeter");
  const auto read =
      test::read_bytes(test::zip_file({{"3D/3dmodel.model", root}, {"2D/a.model", parts}}));
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  REQUIRE_EQ(read.value().slices.size(), 2);
  CHECK_EQ(read.value().slices[1].height.mm(), doctest::Approx(0.3));
  CHECK_EQ(read.value().slices[1].region, region_from_text("0:0 80:0 0:80, 10:10 10:30 30:10"));
  check_refused(root, "(2D/a.model): there is no such entry");
  const std::string gap = model(
      stack(slice("0.02", kOuter), "7") + stack(slice("0.52", kOuter), "8", " zbottom=\"0.5\""), "",
      "centimeter");
  const std::string message =
      test::error_of(test::zip_file({{"3D/3dmodel.model", root}, {"2D/a.model", gap}}));
  CHECK_NE(message.find("'8' begins at zbottom '0.5', not where"), std::string::npos);
}

TEST_CASE(
    "a full mesh counts more than its slices; polygons that stay open are left out, and told") {
  std::string full = test::threemf_model(parts::box({0, 0, 0}, 4, 3, 2));
  full.insert(full.find("<object") + 7,
              " xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" "
              "s:slicestackid=\"5\" s:meshresolution=\"fullres\"");
  CHECK_EQ(test::read_bytes(test::threemf_file(full)).value().triangles.size(), 12);
  const auto open = test::read_bytes(test::threemf_file(model(
      stack(slice("0.2", kOuter + polygon("0", {"1", "4"}))) + sliced_object("1"), item("1"))));
  REQUIRE(open.ok());
  CHECK_EQ(open.value().slices[0].region, region_from_text("0:0 8:0 0:8"));
  CHECK_EQ(open.value().warnings.size(), 1);
}

TEST_CASE("what can't be one print is refused by name") {
  const std::string object = sliced_object("1");
  const auto one = [&](const std::string& slices) {
    return model(stack(slices) + object, item("1"));
  };
  check_refused(one(slice("0.2", polygon("0", {"1", "9", "0"}))), "v2 '9' is no vertex of its");
  check_refused(one(slice("0.2", kOuter) + slice("0.2", kOuter)), "'0.2' does not lie above");
  check_refused(one(slice("x", kOuter)), "without a number for ztop");
  check_refused(model(object, item("1")), "slicestack '5' is not in the file");
  check_refused(model(kStack + object, item("1", "1 0 0 0 0 1 0 -1 0 0 0 0")), "tilts them");
  check_refused(model(kStack + object + stack(slice("1.3", kOuter), "6", " zbottom=\"1\"") +
                          sliced_object("2", "6"),
                      item("1") + item("2")),
                "items with other layers can't be one print");
  check_refused(model(kStack + object, item("1") + item("1", "1 0 0 0 1 0 0 0 1 0 0 3")),
                "no slice between 1.5 and 4 mm");
  check_refused(model(kStack + object +
                          "<object id=\"2\"><components><component objectid=\"1\"/>"
                          "</components></object>",
                      item("2")),
                "as a component: not supported");
  std::string many;
  for (int i = 0; i < 65; ++i) many += item("1");
  check_refused(model(kStack + object, many), "more than 64 items");
}

TEST_CASE("a part of slices is opened as layers, from a file and once more") {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("part.3mf", test::threemf_file(model(kStack + sliced_object("1"), item("1"))));
  auto part = host::open_whole_part(path, core::Settings());
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  CHECK_EQ(part.value().summary.layers, 2);
  CHECK_EQ(part.value().summary.height.mm(), doctest::Approx(0.5));
  const auto first = part.value().layers->next();
  REQUIRE(first.ok());
  REQUIRE(first.value());
  CHECK_EQ(first.value()->bottom.mm(), 0);
}
