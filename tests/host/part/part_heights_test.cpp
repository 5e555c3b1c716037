// Heights of a mesh's layers, whatever way it takes to its slices.
#include "host/part/part_heights.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "core/slices/height_plan.h"
#include "host/part/mesh_layers.h"
#include "host/part/part_file.h"
#include "tests/support/adaptive_heights.h"
#include "tests/support/listed_triangles.h"
#include "tests/support/mesh.h"
#include "tests/support/part_slices.h"
#include "tests/support/temporary_folder.h"
#include "tools/parts/part_maker.h"

using core::Length;
using core::Settings;
using core::Triangle;

namespace {

Settings adaptive() {
  Settings settings = test::adaptive_settings();
  settings.height_range = {"3-4.1 0.12"};
  return settings;
}

host::OpenedPart opened(const std::vector<Triangle>& triangles, const Settings& settings,
                        bool pipe) {
  host::OpenOptions options;
  options.stream_pipes = options.order_is_sure = pipe;
  options.reorder_triangles = 64;
  auto part = host::open_mesh(test::listed_mesh(triangles, pipe).input, settings, options);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  if (part.value().read_rest) {
    auto summary = part.value().read_rest();
    REQUIRE_MESSAGE(summary.ok(), (summary.ok() ? "" : summary.error().message));
    part.value().summary = summary.value();
  }
  return std::move(part).value();
}

void check_slices(host::OpenedPart part, const core::LayerHeights& heights, Length top) {
  CHECK_EQ(part.summary.layers, heights.count(top));
  core::LayerIndex next = 0;
  for (const core::Slice& slice : test::all_slices(part)) {
    REQUIRE_EQ(slice.index, next);
    REQUIRE_EQ(slice.bottom, heights.bottom(next));
    REQUIRE_EQ(slice.height, heights.height(next++));
  }
  CHECK_EQ(next, heights.count(top));
}

std::string corner(const char* x, const char* y, const char* z) {
  return std::string(" (v ") + x + " " + y + " " + z + ")";
}

// A box of 8 × 8 × 12 mm, and a tetrahedron with an upright corner, `z` mm above the bed.
std::string box() {
  std::string text = "(shell (vertices";
  for (int i = 0; i < 8; ++i) {
    text += corner((i & 1) != 0 ? "8" : "0", (i & 2) != 0 ? "8" : "0", (i & 4) != 0 ? "12" : "0");
  }
  return text +
         ") (surface (triangles (t 0 2 1) (t 1 2 3) (t 4 5 6) (t 5 7 6) (t 0 1 4) (t 1 5 4)"
         " (t 2 6 3) (t 3 6 7) (t 0 4 2) (t 2 4 6) (t 1 3 5) (t 3 7 5))))";
}
std::string tetrahedron(const char* z, const char* top) {
  return "(shell (vertices" + corner("0", "0", z) + corner("4", "0", z) + corner("0", "4", z) +
         corner("0", "0", top) + ") (surface (triangles (t 0 2 1) (t 0 1 3) (t 0 3 2) (t 1 2 3))))";
}

std::vector<core::Slice> slices_of_sif(const std::string& body) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("part.sif", "(SIF_SFF 2 0 (units mm) " + body + ")");
  Settings settings;
  settings.adaptive_layer_height = true;
  auto part = host::open_whole_part(path, settings, {});
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  return test::all_slices(part.value());
}

Length lowest_between(const std::vector<core::Slice>& slices, double from_mm, double to_mm) {
  Length lowest = Length::from_mm(1);
  for (const core::Slice& slice : slices) {
    if (slice.top().mm() <= from_mm || slice.bottom.mm() >= to_mm) continue;
    lowest = std::min(lowest, slice.height);
  }
  return lowest;
}

}  // namespace

TEST_CASE("a file, a pipe, and one that could be sliced as it comes have the same layers") {
  std::vector<Triangle> triangles =
      test::triangles_of(parts::together({parts::dome(8), parts::box({20, 0, 0}, 9, 9, 1.57)}));
  std::sort(triangles.begin(), triangles.end(),
            [](const Triangle& a, const Triangle& b) { return a.lowest_z() < b.lowest_z(); });
  // Heights in the file begin anywhere.
  for (Triangle& t : triangles) {
    for (core::Vertex& v : t.corners) v.z -= 12'345;
  }
  const Settings settings = adaptive();
  core::HeightLimits limits = *core::adaptive_limits(settings);
  for (const Triangle& t : triangles) limits.add(t);
  const Length top = Length::from_mm(8);
  const core::LayerHeights heights = core::adaptive_heights(settings, limits, -12'345, top);
  CHECK_GT(heights.bands().size(), 5);
  // A layer ends at the box's top.
  core::LayerIndex above = 0;
  while (heights.bottom(above) < Length::from_mm(1.56)) ++above;
  CHECK_EQ(heights.bottom(above), Length::from_mm(1.57));
  check_slices(opened(triangles, settings, false), heights, top);
  check_slices(opened(triangles, settings, true), heights, top);
  std::reverse(triangles.begin(), triangles.end());
  check_slices(opened(triangles, settings, false), heights, top);
  check_slices(opened(triangles, settings, true), heights, top);
}

TEST_CASE("ranges alone leave a pipe to be sliced as it comes") {
  std::vector<Triangle> triangles = test::triangles_of(parts::dome(8));
  std::sort(triangles.begin(), triangles.end(),
            [](const Triangle& a, const Triangle& b) { return a.lowest_z() < b.lowest_z(); });
  Settings settings = adaptive();
  settings.adaptive_layer_height = false;
  host::OpenedPart part = opened(triangles, settings, true);
  CHECK_EQ(part.summary.layers, 0);
  const core::LayerHeights heights = core::layer_heights(settings);
  for (const core::Slice& slice : test::all_slices(part)) {
    REQUIRE_EQ(slice.height, heights.height(slice.index));
  }
}

TEST_CASE("what booleans take from count with all their facets") {
  const auto plain = slices_of_sif("(solid (difference " + box() + box() + "))");
  CHECK_EQ(lowest_between(plain, 1, 9), Length::from_mm(0.3));
  const auto carved = slices_of_sif("(solid (difference " + box() + tetrahedron("2", "3.5") + "))");
  CHECK_GT(carved.size(), plain.size());
  CHECK_EQ(lowest_between(carved, 2, 3.5), Length::from_mm(0.07));
  CHECK_EQ(lowest_between(carved, 6, 9), Length::from_mm(0.3));
}

TEST_CASE("a layer that a wall can't be made of is refused before anything is printed") {
  Settings settings;
  settings.wall_thickness = Length::from_mm(8);
  settings.height_range = {"1.11-2 0.2"};
  // 0.91 mm below the range: 3 layers, and two of 0.155 mm.
  CHECK(host::part_heights(settings, std::nullopt, 0, Length::from_mm(9), "a.stl").ok());
  settings.wall_thickness = Length::from_mm(10);
  const auto refused = host::part_heights(settings, std::nullopt, 0, Length::from_mm(9), "a.stl");
  REQUIRE_FALSE(refused.ok());
  CHECK_EQ(refused.error().message.find("a.stl, layer 5: it is 0.155 mm high, a wall of 10 mm"), 0);
}
