#include "host/part/height_check.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/part/height_fill.h"
#include "host/part/mesh_layers.h"
#include "tests/support/listed_triangles.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tools/parts/part_maker.h"

using core::Triangle;
using core::Vertex;
using host::OpenOptions;

namespace {

constexpr std::int64_t kMm = 10'000;

std::vector<Triangle> cube() { return test::triangles_of(parts::box({0, 0, 0}, 20, 20, 20)); }

std::vector<Triangle> moved(std::vector<Triangle> triangles, Vertex from, Vertex to) {
  for (Triangle& t : triangles) {
    for (Vertex& v : t.corners) {
      if (v == from) v = to;
    }
  }
  return triangles;
}

std::vector<Triangle> with(std::vector<Triangle> triangles, const std::vector<Triangle>& more) {
  triangles.insert(triangles.end(), more.begin(), more.end());
  return triangles;
}

std::vector<Triangle> raised(std::vector<Triangle> triangles, std::int64_t mm) {
  for (Triangle& t : triangles) {
    for (Vertex& v : t.corners) v.z += mm * kMm;
  }
  return triangles;
}

// What is said against it; empty: nothing.
std::string refusal(const std::vector<Triangle>& triangles, bool pipe = false, bool tall = false) {
  OpenOptions options;
  options.tall = tall;
  auto part = host::open_mesh(test::listed_mesh(triangles, pipe).input, {}, options);
  if (!part.ok()) return part.error().message;
  if (!part.value().read_rest) return "";
  const auto rest = part.value().read_rest();
  return rest.ok() ? "" : rest.error().message;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

constexpr Vertex kCorner{20 * kMm, 20 * kMm, 20 * kMm};
constexpr Vertex kFoot{0, 0, 0};

}  // namespace

TEST_CASE("a corner gone astray is asked about, with its facet, its place and the rest's height") {
  for (const std::int64_t far_mm : {1'000, 30'000, 100'000'000}) {
    CAPTURE(far_mm);
    const auto up = moved(cube(), kCorner, {kCorner.x, kCorner.y, far_mm * kMm});
    for (const bool pipe : {false, true}) {
      const std::string text = refusal(up, pipe);
      CAPTURE(text);
      CHECK(says(text, "has a corner at 20, 20, " + std::to_string(far_mm) + " mm"));
      CHECK(says(text, "all the rest is 20 mm high"));
      CHECK(says(text, "facet "));
      CHECK(says(text, "--tall"));
      CHECK_EQ(refusal(up, pipe, true), "");
    }
    const auto down = moved(cube(), kFoot, {0, 0, -far_mm * kMm});
    CHECK(says(refusal(down), "has a corner at 0, 0, -" + std::to_string(far_mm) + " mm"));
  }
  // One at either end, and two at one.
  const auto both = moved(moved(cube(), kCorner, {kCorner.x, kCorner.y, 5'000 * kMm}), kFoot,
                          {0, 0, -7'000 * kMm});
  CHECK(says(refusal(both), "all the rest is 20 mm high"));
  const auto two = moved(moved(cube(), kCorner, {kCorner.x, kCorner.y, 50'000 * kMm}),
                         {0, 20 * kMm, 20 * kMm}, {0, 20 * kMm, 49'000 * kMm});
  CHECK(says(refusal(two), "facet "));
}

TEST_CASE("a corner astray to the side is named where the part is too wide for it") {
  const std::string text = refusal(moved(cube(), kCorner, {400 * kMm, kCorner.y, kCorner.z}));
  CAPTURE(text);
  CHECK(says(text, "the bed"));
  CHECK(says(text, "has a corner at 400, 20, 20 mm"));
  CHECK(says(text, "only 20 mm wide"));
  CHECK_FALSE(says(refusal(test::triangles_of(parts::box({0, 0, 0}, 400, 20, 20))), "corner"));
}

TEST_CASE("what stands far above everything else, with nothing below it, is asked about") {
  CHECK(says(refusal(with(cube(), raised(cube(), 500))), "no facet stands between 20 and 500 mm"));
  const std::vector<Triangle> stray{
      {{Vertex{0, 0, 900 * kMm}, {kMm, 0, 901 * kMm}, {0, kMm, 900 * kMm}}}};
  CHECK(says(refusal(with(cube(), stray)), "no facet stands between 20 and 900 mm"));
  // A flat facet below is no layer, but the part is set on it.
  const std::vector<Triangle> floor{
      {{Vertex{0, 0, -900 * kMm}, {kMm, 0, -900 * kMm}, {0, kMm, -900 * kMm}}}};
  CHECK(says(refusal(with(cube(), floor)), "facet 13"));
  CHECK_EQ(refusal(with(cube(), raised(cube(), 50))), "");
}

TEST_CASE("tall parts are printed without a question") {
  for (const double height : {300.0, 2'000.0, 19'000.0}) {
    CAPTURE(height);
    CHECK_EQ(refusal(test::triangles_of(parts::box({0, 0, 0}, 10, 10, height))), "");
  }
  // A mast on a plate; a spire; a million layers, filled evenly.
  CHECK_EQ(refusal(with(test::triangles_of(parts::box({0, 0, 0}, 100, 100, 3)),
                        raised(test::triangles_of(parts::box({40, 40, 0}, 5, 5, 1'200)), 3))),
           "");
  CHECK_EQ(refusal(moved(moved(moved(moved(cube(), kCorner, {10 * kMm, 10 * kMm, 300 * kMm}),
                                     {0, 20 * kMm, 20 * kMm}, {10 * kMm, 10 * kMm, 300 * kMm}),
                               {20 * kMm, 0, 20 * kMm}, {10 * kMm, 10 * kMm, 300 * kMm}),
                         {0, 0, 20 * kMm}, {10 * kMm, 10 * kMm, 300 * kMm})),
           "");
  std::vector<Triangle> tower = test::triangles_of(parts::tower(1'000));
  for (Triangle& t : tower) {
    for (Vertex& v : t.corners) v.z *= 1'000;
  }
  CHECK_EQ(refusal(tower), "");
  CHECK_EQ(refusal(tower, true), "");
  // The same height in one step.
  CHECK(says(refusal(test::triangles_of(parts::box({0, 0, 0}, 10, 10, 200'000))),
             "no facet has a corner"));
}

TEST_CASE("a pipe that is sliced as it comes ends with the question when it is met") {
  std::vector<Triangle> tower = test::triangles_of(parts::tower(200));
  std::int64_t top = 0;
  for (const Triangle& t : tower) top = std::max(top, t.highest_z());
  const auto edge = std::find_if(tower.begin(), tower.end(),
                                 [top](const Triangle& t) { return t.highest_z() == top; });
  REQUIRE(edge != tower.end());
  const Vertex astray =
      *std::max_element(edge->corners.begin(), edge->corners.end(),
                        [](const Vertex& a, const Vertex& b) { return a.z < b.z; });
  for (const std::int64_t far_mm : {9'000, 100'000'000}) {
    CAPTURE(far_mm);
    const auto bad = moved(tower, astray, {astray.x, astray.y, far_mm * kMm});
    OpenOptions options{host::kSortBytesMin, 500, true};
    options.order_is_sure = true;
    auto part = host::open_mesh(test::listed_mesh(bad, true).input, {}, options);
    REQUIRE(part.ok());
    REQUIRE_FALSE(part.value().read_rest);
    std::string error;
    for (int layer = 0; layer < 300 && error.empty(); ++layer) {
      const auto slice = part.value().layers->next();
      if (!slice.ok()) error = slice.error().message;
    }
    CAPTURE(error);
    CHECK(says(error, "--tall"));
    CHECK(says(error, std::to_string(far_mm) + " mm"));
  }
}

TEST_CASE("the longest stretch without a corner, however the corners come") {
  test::Random random(5);
  for (int round = 0; round < 50; ++round) {
    CAPTURE(round);
    const std::int64_t scale = std::int64_t{1} << random.integer(0, 40);
    std::vector<std::int64_t> heights;
    for (int i = 0; i < 40; ++i) heights.push_back(scale * random.integer(-1'000, 1'000));
    host::HeightFill fill;
    for (const std::int64_t z : heights) fill.add(z);
    std::sort(heights.begin(), heights.end());
    std::int64_t widest = 0;
    for (std::size_t i = 1; i < heights.size(); ++i) {
      widest = std::max(widest, heights[i] - heights[i - 1]);
    }
    // A bin is at most a sixty-fourth of the whole, and lies at either end.
    const std::int64_t bin = std::max<std::int64_t>(1, (heights.back() - heights.front()) / 63);
    const auto empty = fill.longest_empty();
    CHECK_LE(empty.high - empty.low, widest);
    CHECK_GE(empty.high - empty.low, widest - 2 * bin - 1);
  }
}
