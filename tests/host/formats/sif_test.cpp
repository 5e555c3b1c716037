// SIF: shells, booleans on slices, and the triangles of 1.0.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "host/part/part_file.h"
#include "tests/support/format_samples.h"
#include "tests/support/region_text.h"
#include "tests/support/temporary_folder.h"

using test::error_of;
using test::read_bytes;
using test::region_from_text;

namespace {

bool says(const std::string& message, const std::string& text) {
  CAPTURE(message);
  return message.find(text) != std::string::npos;
}

// A box, its vertices counted from `base`, its triangles looking outwards, or inwards.
std::string box(const std::string& x0, const std::string& x1, const std::string& y1,
                const std::string& z1, int base = 0, bool inwards = false) {
  const std::string xs[2] = {x0, x1}, ys[2] = {"0", y1}, zs[2] = {"0", z1};
  std::string text = "(shell (vertices";
  for (int i = 0; i < 8; ++i) {
    text += " (v " + xs[i & 1] + " " + ys[i >> 1 & 1] + " " + zs[i >> 2 & 1] + ")";
  }
  text += ") (surface (color (rgb 1 0 0)) (triangles";
  const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& face : faces) {
    const int b = inwards ? 2 : 1, c = inwards ? 1 : 2;
    text += " (t " + std::to_string(face[0] + base) + " " + std::to_string(face[b] + base) + " " +
            std::to_string(face[c] + base) + ")";
  }
  return text + ")))";
}

std::string sif(const std::string& body) { return "(SIF_SFF 2 0 (units mm) " + body + ")"; }

struct Sliced {
  host::PartSummary summary;
  std::vector<core::Slice> slices;
};

// At the bed's corner.
Sliced sliced(const std::string& bytes) {
  const test::TemporaryFolder folder;
  core::Settings settings;
  settings.centre = false;
  auto part = host::open_whole_part(folder.write("part.sif", bytes), settings, {});
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  Sliced result{part.value().summary, {}};
  while (true) {
    auto slice = part.value().layers->next();
    REQUIRE_MESSAGE(slice.ok(), (slice.ok() ? "" : slice.error().message));
    if (!slice.value()) return result;
    result.slices.push_back(*std::move(slice).value());
  }
}

}  // namespace

TEST_CASE("shells side by side are united; the file's own words are skipped") {
  const Sliced part = sliced(
      "(* made (* by *) hand *) (SIF_SFF 2 0 (units mm) (desired_accuracy (e 5 -2))\n"
      "# a constellation\n(constellation (solid (color (rgb 0 1 0)) " +
      box("0", "6", "4", "1") + box("4", "(e 8 0)", "4", "1") + ")))");
  CHECK_EQ(part.summary.format, "SIF 2.0");
  CHECK_EQ(part.summary.facets, 24);
  REQUIRE_EQ(part.slices.size(), 5);
  CHECK_EQ(part.slices[0].region, region_from_text("0:0 8:0 8:4 0:4"));
  CHECK(part.summary.warnings.empty());
}

TEST_CASE("booleans are evaluated on every slice") {
  const std::string a = box("0", "8", "4", "1"), b = box("4", "12", "4", "0.6");
  const auto solid = [](const std::string& sets) { return sliced(sif("(solid " + sets + ")")); };
  const Sliced difference = solid("(difference " + a + b + ")");
  REQUIRE_EQ(difference.slices.size(), 5);
  CHECK_EQ(difference.slices[0].region, region_from_text("0:0 4:0 4:4 0:4"));
  CHECK_EQ(difference.slices[4].region, region_from_text("0:0 8:0 8:4 0:4"));
  CHECK_EQ(difference.summary.facets, 24);
  const Sliced intersection = solid("(intersection " + a + b + ")");
  REQUIRE_EQ(intersection.slices.size(), 3);
  CHECK_EQ(intersection.slices[0].region, region_from_text("0:0 4:0 4:4 0:4"));
  const Sliced united = solid("(union " + a + b + ")");
  REQUIRE_EQ(united.slices.size(), 5);
  CHECK_EQ(united.slices[0].region, region_from_text("0:0 12:0 12:4 0:4"));
  // A boolean within a boolean, beside a shell.
  const Sliced nested = solid("(union (difference " + a + "(union " + b + box("0", "1", "4", "1") +
                              ")) " + box("2", "12", "1", "1") + ")");
  CHECK_EQ(nested.slices[0].region, region_from_text("1:0 12:0 12:1 4:1 4:4 1:4"));
}

TEST_CASE("a shell that is inside out is turned, and told") {
  const Sliced part =
      sliced(sif("(solid " + box("0", "6", "4", "1") + box("4", "8", "4", "1", 0, true) + ")"));
  CHECK_EQ(part.slices[0].region, region_from_text("0:0 8:0 8:4 0:4"));
  REQUIRE_EQ(part.summary.warnings.size(), 1);
  CHECK(says(part.summary.warnings[0], "inside out"));
}

TEST_CASE("vertices may be counted from 1; inches") {
  const Sliced part =
      sliced("(SIF_SFF 2 0 (units inches) (solid " + box("0", "1", "1", "0.1", 1) + "))");
  CHECK_EQ(part.slices[0].region, region_from_text("0:0 25.4:0 25.4:25.4 0:25.4"));
}

TEST_CASE("1.0: surfaces defined once and placed often, mirrored too") {
  const std::string square =
      "(def surface side (v a 0 0 0) (v b 4 0 0) (v c 4 0 1) (v d 0 0 1) (f a b c d))";
  // Four walls of a box of 4 by 4, one of them a mirror image.
  const std::string walls =
      "(inst surface side) (inst surface side (rz 90) (tv 4 0 0))"
      "(inst surface side (my) (ty 4)) (inst surface side (rz -90) (tx 0) (ty 4))";
  const Sliced part =
      sliced("(SIF_SFF 1 0 (units (e 1 -3)) (body " + square + "(lump (shell " + walls + "))))");
  CHECK_EQ(part.summary.format, "SIF 1.0");
  REQUIRE_EQ(part.slices.size(), 5);
  CHECK_EQ(part.slices[0].region, region_from_text("0:0 4:0 4:4 0:4"));
  CHECK_FALSE(part.slices[0].defects.any());
}

TEST_CASE("what is wrong, and where") {
  const std::string a = box("0", "8", "4", "1");
  CHECK(says(error_of("(SIF_SFF 2 0 (solid " + a + "))"), "before (units"));
  CHECK(says(error_of("(SIF_SFF 2 0 (units feet))"), "'feet' where"));
  CHECK(says(error_of(sif("")), "no solid"));
  CHECK(says(error_of(sif("(solid " + a)), "the file ends where"));
  CHECK(says(error_of(sif("(solid (shell (vertices (v 0 0 0)) (triangles (t 0 1 5))))")),
             "corner 5"));
  CHECK(says(error_of(sif("(solid (shell (vertices (v 0 0 x))))")), "'x' where a coordinate"));
  CHECK(says(error_of("(SIF_SFF 1 0 (units (e 1 -3)) (body (v A 0 0 0) (t A A B)))"), "'B' is no"));
  CHECK(
      says(error_of("(SIF_SFF 1 0 (units (e 1 -3)) (body (path a)))"), "'path' is not supported"));
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "(union ";
  CHECK(says(error_of(sif(deep)), "more than 64 forms"));
  const auto odd = read_bytes(sif("(solid (texture wood) " + a + ")"));
  REQUIRE(odd.ok());
  CHECK_EQ(odd.value().warnings.size(), 1);
}
