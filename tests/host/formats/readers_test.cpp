// SLC, Slice V0, L-SIF and SVG, each by what its files look like.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/format_samples.h"
#include "tests/support/region_text.h"

using core::Slice;
using test::error_of;
using test::format_sample;
using test::read_bytes;
using test::region_from_text;

namespace {

std::vector<Slice> slices_of(const std::string& bytes) {
  const auto read = read_bytes(bytes);
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  return read.value().slices;
}

core::Region only_region(const std::string& bytes) {
  const std::vector<Slice> slices = slices_of(bytes);
  REQUIRE_EQ(slices.size(), 1);
  return slices[0].region;
}

bool says(const std::string& message, const std::string& text) {
  CAPTURE(message);
  return message.find(text) != std::string::npos;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

// One layer around these sets.
std::string lsif(const std::string& sets) {
  return "(LSIF 1 0 (units mm) (thickness 0.2) (offset 0) (layer"
         " (v 1 0 0) (v 2 8 0) (v 3 8 8) (v 4 0 8) (v 11 4 0) (v 12 12 0) (v 13 12 8) (v 14 4 8)"
         " (v 21 2 2) (v 22 6 2) (v 23 6 6) (v 24 2 6)" +
         sets + "))";
}

std::string svg(const std::string& groups) {
  return "<svg height=\"20\" xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:slic3r=\"http://slic3r.org/namespaces/slic3r\">" +
         groups + "</svg>";
}

}  // namespace

TEST_CASE("SLC: layers reach up to the next; heads may be padded; inches") {
  const std::string plain = format_sample("3d.slc");
  std::vector<Slice> slices = slices_of(plain);
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[0].region, region_from_text("0:0 8:0 0:8"));
  CHECK_EQ(slices[1].bottom.mm(), 0.25);
  CHECK_EQ(slices[1].height.mm(), 0.25);
  std::string padded = plain;
  const std::size_t head_end = plain.find('\x1A') + 1;
  padded.insert(head_end, 2'048 - head_end, ' ');
  CHECK_EQ(slices_of(padded).size(), 2);
  CHECK_EQ(slices_of(padded)[1].region, slices[1].region);
  CHECK_EQ(slices_of(replaced(plain, "-UNIT MM", "-UNITS INCH"))[0].region,
           region_from_text("0:0 203.2:0 0:203.2"));
  CHECK(says(error_of(replaced(plain, "-UNIT MM", "-UNIT XX")), "names no unit"));
}

TEST_CASE("SLC: keys without blanks between them, a name that looks like a unit, supports") {
  const std::string plain = format_sample("3d.slc");
  CHECK_EQ(slices_of(replaced(plain, "-UNIT MM -TYPE PART", "-UNIT MM-TYPE PART"))[0].region,
           region_from_text("0:0 8:0 0:8"));
  CHECK_EQ(slices_of(replaced(plain, "-TYPE PART", "-PACKAGE INCHWORM"))[0].region,
           region_from_text("0:0 8:0 0:8"));
  CHECK(read_bytes(plain).value().warnings.empty());
  const auto support = read_bytes(replaced(plain, "-TYPE PART", "-TYPE SUPPORT"));
  REQUIRE(support.ok());
  REQUIRE_EQ(support.value().warnings.size(), 1);
  CHECK(says(support.value().warnings[0], "no part but a SUPPORT"));
}

TEST_CASE("Slice V0: inches, contours that nest either way round, empty layers") {
  const std::vector<Slice> slices = slices_of(format_sample("v0.ssl"));
  REQUIRE_EQ(slices.size(), 3);
  CHECK_EQ(slices[0].region,
           region_from_text("0:0 25.4:0 25.4:25.4 0:25.4, 6.35:6.35 6.35:19.05 19.05:19.05 "
                            "19.05:6.35"));
  CHECK_EQ(slices[0].height.mm(), 0.254);
  CHECK(slices[1].region.empty());
  CHECK_EQ(slices[2].bottom.mm(), 0.508);
  CHECK_EQ(only_region("Slice V0\nFILE(a,UNITS(MM))\nZ 0 .2\n0 0\n1 0\n0 1\nC\nEND\n"),
           region_from_text("0:0 1:0 0:1"));
}

TEST_CASE("Slice V0: heights that differ by rounding are one upon the other") {
  const std::string begin = "Slice V0\nFILE(a,UNITS(MM))\nZ 0 0.2\n0 0\n1 0\n0 1\nC\n";
  const std::vector<Slice> slices = slices_of(begin + "Z 0.201 0.2\nEND\n");
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[1].bottom.mm(), 0.2);
  CHECK_EQ(slices[1].top().mm(), doctest::Approx(0.401));
  CHECK(says(error_of(begin + "Z 0.25 0.2\nEND\n"), "line 8: the layer begins at 0.25 mm"));
  CHECK(says(error_of(begin + "Z 0.2 0\nEND\n"), "without thickness"));
  CHECK(says(error_of(begin + "0 0\n1 1\nEND\n"), "'C', which closes"));
  CHECK(says(error_of(begin), "the file ends where"));
  CHECK(says(error_of(begin + "Q\n"), "'Q' where"));
}

TEST_CASE("QuickSlice 6's own files are refused by name") {
  CHECK(says(error_of("ASCII\nMODELER fdm2000\n"), "'ASCII' begins a QuickSlice 6 .ssl"));
  CHECK(says(error_of("MODELER fdm2000\n"), "'MODELER' begins a QuickSlice 6 .ssl"));
}

TEST_CASE("L-SIF: numbers, comments, heights of their own, vertices in the contour") {
  const std::vector<Slice> slices = slices_of(format_sample("layers.lsif"));
  REQUIRE_EQ(slices.size(), 3);
  CHECK_EQ(slices[0].region, region_from_text("0:0 20:0 20:15 15:15 20:20 0:20, 5:5 5:10 10:10"));
  CHECK_EQ(slices[1].bottom.mm(), 0.2);
  CHECK_EQ(slices[1].height.mm(), 0.3);
  CHECK(slices[1].region.empty());
  CHECK_EQ(slices[2].bottom.mm(), 0.5);
  CHECK_EQ(slices[2].region, region_from_text("0:0 9:0 0:9"));
}

TEST_CASE("L-SIF: booleans") {
  const std::string a = "(contour 1 2 3 4)", b = "(contour 11 12 13 14)",
                    c = "(contour 21 22 23 24)";
  const auto region = [](const std::string& sets) { return only_region(lsif(sets)); };
  const core::Region united = region_from_text("0:0 12:0 12:8 0:8");
  CHECK_EQ(region("(union " + a + b + ")"), united);
  CHECK_EQ(region(a + b), united);
  CHECK_EQ(region("(intersection " + a + b + ")"), region_from_text("4:0 8:0 8:8 4:8"));
  CHECK_EQ(region("(difference " + a + b + ")"), region_from_text("0:0 4:0 4:8 0:8"));
  CHECK_EQ(region("(difference " + a + c + b + ")"),
           region_from_text("0:0 4:0 4:2 2:2 2:6 4:6 4:8 0:8"));
  CHECK_EQ(region("(difference (union) " + a + ")"), core::Region());
  CHECK_EQ(region("(intersection)(difference)(union)"), core::Region());
  CHECK_EQ(region("(difference " + a + ")"), region_from_text("0:0 8:0 8:8 0:8"));
  // The wall and the inside, as the paper has them.
  CHECK_EQ(region("(difference " + a + c + ")" + c), region_from_text("0:0 8:0 8:8 0:8"));
  // What is solid is told by the structure, not by the way round.
  const core::Region ring = region_from_text("0:0 8:0 8:8 0:8, 2:2 2:6 6:6 6:2");
  CHECK_EQ(region("(nested1d " + a + c + ")"), ring);
  CHECK_EQ(region("(nested1d (contour 4 3 2 1)" + c + ")"), ring);
  CHECK_EQ(region("(nested1d " + a + c +
                  "(nested1d (contour (v 31 3 3) (v 32 5 3) (v 33 5 5) 31 32 33)))"),
           region_from_text("0:0 8:0 8:8 0:8, 2:2 2:6 6:6 6:2, 3:3 5:3 5:5"));
}

TEST_CASE("L-SIF: what is wrong, and where") {
  CHECK(says(error_of(lsif("(contour 1 2 99)")), "vertex 99 is not in this layer"));
  CHECK(says(error_of(lsif("(contour 1 2 x)")), "'x' where a vertex's number"));
  CHECK(says(error_of("(LSIF 1 0 (units mm) (layer (union)))"), "layer 1 has no thickness"));
  CHECK(says(error_of("(LSIF 1 0 (layer (union)))"), "before (units"));
  CHECK(says(error_of("(LSIF 1 0 (units feet))"), "'feet' where 'mm' or 'inches'"));
  CHECK(says(error_of("(LSIF 1 0 (units mm)"), "the file ends where"));
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "(union ";
  CHECK(says(error_of(lsif(deep)), "more than 64 forms"));
  const auto odd = read_bytes(lsif("(spline 1 2 (3 4)) (contour 1 2 3)"));
  REQUIRE(odd.ok());
  REQUIRE_EQ(odd.value().warnings.size(), 1);
  CHECK(says(odd.value().warnings[0], "'spline' was not understood"));
}

TEST_CASE("SVG: both of Slic3r's dialects") {
  const std::vector<Slice> slices = slices_of(format_sample("layers.svg"));
  REQUIRE_EQ(slices.size(), 2);
  CHECK_EQ(slices[0].region, region_from_text("0:0 10:0 10:10 0:10, 4:4 4:6 6:6 6:4"));
  CHECK_EQ(slices[1].region, region_from_text("0:0 9:0 0:9"));
  CHECK_EQ(slices[1].bottom.mm(), 0.2);
  // Slic3r 1.3: the middle of the layer, in km.
  const auto polygon = [](const std::string& z, const std::string& holes) {
    return "<g slic3r:z=\"" + z +
           "\"><polygon slic3r:type=\"contour\" points=\"0,0 0,9 9,9 9,0\"/>" + holes + "</g>";
  };
  const auto read = read_bytes(
      svg(polygon("1.5e-07", "<polygon slic3r:type=\"hole\" points=\"2,2 4,2 4,4 2,4\"/>") +
          polygon("4e-07", "")));
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().message));
  REQUIRE_EQ(read.value().slices.size(), 2);
  CHECK_EQ(read.value().slices[0].height.mm(), 0.3);
  CHECK_EQ(read.value().slices[1].height.mm(), doctest::Approx(0.2));
  CHECK_EQ(read.value().slices[0].region, region_from_text("0:0 9:0 9:9 0:9, 2:2 2:4 4:4 4:2"));
  CHECK_EQ(read.value().warnings.size(), 1);
}

TEST_CASE("SVG paths: relative, several, signs without blanks") {
  const auto path = [](const std::string& data) {
    return only_region(
        svg("<g slic3r:z=\"0.2\" slic3r:layer-height=\"0.2\"><path d=\"" + data + "\"/></g>"));
  };
  CHECK_EQ(path("M0,20L8,20L0,12Z"), region_from_text("0:0 8:0 0:8"));
  CHECK_EQ(path("m 0 20 l 8-0 -8-8z m 10 0 8 0 0 -8 z"),
           region_from_text("0:0 8:0 0:8, 10:0 18:0 18:8"));
}

TEST_CASE("SVG: what is refused") {
  const std::string path = "<g slic3r:z=\"0.2\" slic3r:layer-height=\"0.2\"><path d=\"";
  CHECK(says(error_of(svg("")), "it has no layers"));
  CHECK(says(error_of(svg(path + "M 0 0 C 1 1 2 2 3 3\"/></g>")), "path command 'C'"));
  CHECK(says(error_of(svg(path + "M 0 x\"/></g>")), "where a coordinate should be"));
  CHECK(says(error_of(svg("<g slic3r:z=\"a\"/>")), "'a' is no height"));
  for (const char* moved : {"<g transform=\"scale(2)\">", "<g slic3r:z=\"1\" transform=\"\">"}) {
    CHECK(says(error_of(svg(moved + path + "M 0 0\"/></g></g>")), "<g transform=…> is not"));
  }
  CHECK(says(error_of(svg("<g slic3r:z=\"0.2\"><path transform=\"scale(2)\"/></g>")),
             "<path transform=…> is not"));
  const auto circle = read_bytes(svg(path + "M 0 0 9 0 0 9\"/><circle r=\"3\"/><rect/></g>"));
  REQUIRE(circle.ok());
  REQUIRE_EQ(circle.value().warnings.size(), 1);
  CHECK(says(circle.value().warnings[0], "<circle> and other shapes"));
  CHECK(says(error_of(svg(path)), "no XML"));
  CHECK(says(error_of(svg(path + "M 0 0\"/></g>").substr(0, 150)), "the document ends early"));
  CHECK(says(error_of("<!DOCTYPE svg [<!ENTITY a \"aaaa\">]>" + svg("")), "declares entities"));
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<g>";
  CHECK(says(error_of(svg(deep)), "more than 64 elements"));
}
