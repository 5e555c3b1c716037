// Mesh formats: the same part through each gives the same slices; what each says beside triangles.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/part/part_file.h"
#include "tests/support/format_samples.h"
#include "tests/support/mesh_files.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"
#include "tests/support/temporary_folder.h"

using core::Triangle;
using test::error_of;
using test::read_bytes;

namespace {

bool says(const std::string& message, const std::string& text) {
  CAPTURE(message);
  return message.find(text) != std::string::npos;
}

// In whatever order, from whichever corner.
std::vector<Triangle> sorted_triangles(const std::string& bytes) {
  const auto read = read_bytes(bytes);
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  std::vector<Triangle> triangles = read.value().triangles;
  for (Triangle& triangle : triangles) {
    auto& corners = triangle.corners;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  std::sort(triangles.begin(), triangles.end(),
            [](const Triangle& a, const Triangle& b) { return a.corners < b.corners; });
  return triangles;
}

bool same(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Triangle& x, const Triangle& y) { return x.corners == y.corners; });
}

std::vector<core::Slice> slices_of(const test::TemporaryFolder& folder, const std::string& bytes) {
  auto part = host::open_whole_part(folder.write("part", bytes), core::Settings(), {});
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  std::vector<core::Slice> slices;
  while (true) {
    auto slice = part.value().layers->next();
    REQUIRE(slice.ok());
    if (!slice.value()) return slices;
    slices.push_back(*std::move(slice).value());
  }
}

std::string model(const std::string& head, const std::string& resources, const std::string& build) {
  return test::threemf_file(
      "<model " + head +
      " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" "
      "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\"><resources>" +
      resources + "</resources><build>" + build + "</build></model>");
}

// A tetrahedron of 10 units.
const std::string kMesh =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" y=\"0\" z=\"0\"/>"
    "<vertex x=\"0\" y=\"10\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"10\"/></vertices><triangles>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
    "<triangle v1=\"0\" v2=\"3\" v3=\"2\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/>"
    "</triangles></mesh>";
const std::string kObject = "<object id=\"1\">" + kMesh + "</object>";

double volume_mm3(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const auto& [corners] : triangles) {
    const auto& [a, b, c] = corners;
    const auto d = [](std::int64_t v) { return static_cast<double>(v) / core::kUnitsPerMm; };
    sum += d(a.x) * (d(b.y) * d(c.z) - d(b.z) * d(c.y)) -
           d(a.y) * (d(b.x) * d(c.z) - d(b.z) * d(c.x)) +
           d(a.z) * (d(b.x) * d(c.y) - d(b.y) * d(c.x));
  }
  return sum / 6;
}

core::Vertex highest_corner(const std::vector<Triangle>& triangles) {
  core::Vertex highest{0, 0, INT64_MIN};
  for (const Triangle& triangle : triangles) {
    for (const core::Vertex& corner : triangle.corners) {
      if (corner.z > highest.z) highest = corner;
    }
  }
  return highest;
}

}  // namespace

TEST_CASE("one part through every mesh format: the same triangles, the same slices") {
  const test::TemporaryFolder folder;
  for (const parts::Part& part : {parts::demo(), parts::dome(10, 24, 8)}) {
    const std::string stl = test::stl_file(part);
    const std::vector<Triangle> triangles = sorted_triangles(stl);
    const std::vector<core::Slice> slices = slices_of(folder, stl);
    const std::vector<std::pair<std::string, std::string>> others = {
        {"OBJ", test::obj_file(part)},
        {"AMF", test::amf_file(part)},
        {"zipped AMF", test::zip_file({{"part.amf", test::amf_file(part)}})},
        {"3MF", test::threemf_file(test::threemf_model(part))},
        {"SIF 2.0", test::sif_file(part)},
        {"SIF 1.0", test::old_sif_file(part)}};
    for (const auto& other : others) {
      const std::string& bytes = other.second;
      CAPTURE(other.first);
      CHECK(same(sorted_triangles(bytes), triangles));
      const std::vector<core::Slice> theirs = slices_of(folder, bytes);
      REQUIRE_EQ(theirs.size(), slices.size());
      for (std::size_t i = 0; i < slices.size(); ++i) {
        CHECK_EQ(theirs[i].region, slices[i].region);
        CHECK_EQ(theirs[i].bottom, slices[i].bottom);
      }
    }
  }
}

TEST_CASE("OBJ: fans, indices from the end, joined lines, slashes") {
  const std::string cube =
      "v 0 0 0\nv 1 0 0\nv 1 1 0 1.0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
      "f 4/1/1 3/1/1 2/1/1 1/1/1 # a square\nv 0 0 1\nf -5 -4 \\\n -1\n";
  const auto read = read_bytes(cube);
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  REQUIRE_EQ(read.value().triangles.size(), 3);
  CHECK_EQ(read.value().triangles[2].corners[2], core::Vertex{0, 0, 10'000});
  CHECK(says(error_of("v 0 0 0\nv 1 0 0\nf 1 2 3\n"), "line 3: vertex 3 of 2: there is none"));
  CHECK(says(error_of("v 0 0 0\nv 1 0 0\nf -3 1 2\n"), "line 3: vertex -3 of 2 so far"));
  CHECK(says(error_of("v 0 0 0\nv 1 0 0\nf 1 2\n"), "no face"));
  CHECK(says(error_of("v 0 0\nv 1 0 0\n"), "line 1: '' where a coordinate"));
  CHECK(says(error_of("v 0 0 1e12\n"), "line 1: a corner is at"));
  CHECK(says(error_of("v 0 0 0\n"), "no face"));
}

TEST_CASE("3MF: units, transforms, components, mirrors, items that are not to be printed") {
  const std::string parts = kObject +
                            "<object id=\"2\"><components>"
                            "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>"
                            "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"
                            "</components></object><object id=\"3\" type=\"support\">" +
                            kMesh + "</object>";
  const std::string build =
      "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 2\"/><item objectid=\"3\"/>"
      "<item objectid=\"1\" printable=\"0\"/>";
  const auto read = read_bytes(model("unit=\"centimeter\"", parts, build));
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  CHECK_EQ(read.value().format, "3MF");
  CHECK_EQ(read.value().triangles.size(), 8);
  CHECK_EQ(read.value().warnings.size(), 1);
  CHECK(volume_mm3(read.value().triangles) == doctest::Approx(2 * 1e6 / 6));
  // (5, 0, 10) cm turned to (0, 5, 10), lifted by 2.
  CHECK_EQ(highest_corner({read.value().triangles.begin(), read.value().triangles.begin() + 4}),
           core::Vertex{0, 500'000, 1'200'000});
}

TEST_CASE("3MF: components in other parts of the package") {
  const std::string core = "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
  const std::string other = "<model " + core + "><resources>" + kObject + "</resources></model>";
  const std::string root =
      "<model " + core +
      " xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
      "requiredextensions=\"p\"><resources><object id=\"7\"><components>"
      "<component p:path=\"/3D/Objects/one.model\" objectid=\"1\"/></components></object>"
      "</resources><build><item objectid=\"7\"/></build></model>";
  const std::string bytes =
      test::zip_file({{"3D/3dmodel.model", root}, {"3D/Objects/one.model", other}});
  CHECK_EQ(sorted_triangles(bytes).size(), 4);
}

TEST_CASE("3MF: what is refused, by name") {
  const std::string item = "<item objectid=\"1\"/>";
  CHECK(says(error_of(model("requiredextensions=\"b\"", kObject, item)), "beamlattice"));
  CHECK(says(error_of(model("unit=\"parsec\"", kObject, item)), "'parsec'"));
  CHECK(says(error_of(model("", kObject, "<item objectid=\"9\"/>")), "object '9' is not in"));
  CHECK(says(error_of(model("", kObject, "")), "no item to print"));
  CHECK(says(error_of(model(
                 "", "<object id=\"1\" s:meshresolution=\"lowres\">" + kMesh + "</object>", item)),
             "has no slicestackid"));
  CHECK(says(error_of(model("",
                            "<object id=\"1\"><components><component objectid=\"1\"/>"
                            "</components></object>",
                            item)),
             "in a circle"));
  CHECK(says(error_of(model("",
                            "<object id=\"1\"><mesh><vertices/><triangles>"
                            "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>",
                            item)),
             "is no vertex"));
  CHECK(says(error_of(test::threemf_file("<!DOCTYPE a [<!ENTITY a \"b\">]><model/>")),
             "declares entities"));
  CHECK(says(error_of(test::zip_file({{"a.txt", "x"}})), "without a 3MF model"));
  CHECK(says(error_of(test::threemf_file(std::string(64 << 20, ' '))), "zip bomb"));
  // Twice two to the sixtieth copies.
  std::string doubled = kObject;
  for (int i = 2; i < 60; ++i) {
    const std::string below = "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    doubled += "<object id=\"" + std::to_string(i) + "\"><components>" + below + below +
               "</components></object>";
  }
  CHECK(says(error_of(model("", doubled, "<item objectid=\"59\"/>")), "copies of objects"));
}

TEST_CASE("AMF: units, constellations, turns") {
  const std::string object =
      "<object id=\"1\"><mesh><vertices>"
      "<vertex><coordinates><x>0</x><y>0</y><z> 0 </z></coordinates></vertex>"
      "<vertex><coordinates><x>1</x><y>0</y><z>0</z></coordinates></vertex>"
      "<vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates></vertex>"
      "<vertex><coordinates><x>0</x><y>0</y><z>1</z></coordinates></vertex></vertices><volume>"
      "<triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle>"
      "<triangle><v1>0</v1><v2>1</v2><v3>3</v3></triangle>"
      "<triangle><v1>0</v1><v2>3</v2><v3>2</v3></triangle>"
      "<triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle></volume></mesh></object>";
  const std::string constellation =
      "<constellation id=\"2\"><instance objectid=\"1\"><deltaz>2</deltaz><rx>-90</rx></instance>"
      "<instance objectid=\"1\"/></constellation>";
  const auto read = read_bytes("<amf unit=\"inch\">" + object + constellation + "</amf>");
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  CHECK_EQ(read.value().triangles.size(), 8);
  CHECK(volume_mm3(read.value().triangles) == doctest::Approx(2 * 25.4 * 25.4 * 25.4 / 6));
  // About x by -90°, y goes down: z of all is 1 … 2 inches.
  CHECK_EQ(highest_corner(read.value().triangles).z, 508'000);
  CHECK_EQ(sorted_triangles("<amf>" + object + "</amf>").size(), 4);
  CHECK(says(error_of("<amf unit=\"ell\">" + object + "</amf>"), "'ell'"));
  CHECK(says(error_of("<amf>" + object + object + "</amf>"), "there twice"));
  CHECK(says(error_of("<amf><object id=\"1\"><mesh><volume><triangle><v1>0</v1><v2>1</v2>"
                      "<v3>2</v3></triangle></volume></mesh></object></amf>"),
             "is no vertex"));
  CHECK(says(error_of("<amf><object id=\"1\"></object></amf>"), "no triangle"));
}
