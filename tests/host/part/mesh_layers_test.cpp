// Whatever way a mesh takes to its slices, they are those that it has with everything in memory.
#include "host/part/mesh_layers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/slices/height_plan.h"
#include "host/part/mesh_survey.h"
#include "host/system/limits.h"
#include "tests/support/listed_triangles.h"
#include "tests/support/mesh.h"
#include "tests/support/random_regions.h"
#include "tools/parts/part_maker.h"

using core::Length;
using core::Settings;
using core::Slice;
using core::Triangle;
using host::OpenedPart;
using host::OpenOptions;

namespace {

Settings at_origin() {
  Settings settings;
  settings.centre = false;
  return settings;
}

// Everything in memory, set on the bed at its origin by other means than the program's.
std::vector<Slice> reference(std::vector<Triangle> triangles, const Settings& settings) {
  core::Vertex least = triangles[0].corners[0];
  for (const Triangle& t : triangles) {
    for (const core::Vertex& v : t.corners) {
      least = {std::min(least.x, v.x), std::min(least.y, v.y), std::min(least.z, v.z)};
    }
  }
  for (Triangle& t : triangles) {
    for (core::Vertex& v : t.corners) v = {v.x - least.x, v.y - least.y, v.z - least.z};
  }
  std::erase_if(triangles, [](const Triangle& t) { return !host::can_be_cut(t); });
  return test::sweep(triangles, {layer_heights(settings), 0, settings.simplify_tolerance,
                                 settings.chain_gap_max})
      .slices;
}

struct Way {
  std::string name;
  bool pipe = false;
  bool stream = false;
};
const std::vector<Way> kWays = {
    {"file"}, {"pipe", true, false}, {"pipe that may be sliced as it comes", true, true}};

OpenedPart opened(const std::vector<Triangle>& triangles, const Settings& settings, const Way& way,
                  OpenOptions options) {
  options.stream_pipes = options.order_is_sure = way.stream;
  auto part = host::open_mesh(test::listed_mesh(triangles, way.pipe).input, settings, options);
  REQUIRE_MESSAGE(part.ok(), (part.ok() ? "" : part.error().message));
  if (part.value().read_rest) {
    auto summary = part.value().read_rest();
    REQUIRE_MESSAGE(summary.ok(), (summary.ok() ? "" : summary.error().message));
    part.value().summary = summary.value();
  }
  return std::move(part).value();
}

void check_same(const std::vector<Slice>& expected, OpenedPart part) {
  for (const Slice& slice : expected) {
    const auto next = part.layers->next();
    REQUIRE(next.ok());
    REQUIRE(next.value().has_value());
    REQUIRE_EQ(next.value()->region, slice.region);
    REQUIRE_EQ(next.value()->bottom, slice.bottom);
    REQUIRE_EQ(next.value()->defects.dropped_chains, slice.defects.dropped_chains);
    REQUIRE_EQ(next.value()->defects.doubled_facets, slice.defects.doubled_facets);
  }
  const auto after = part.layers->next();
  REQUIRE(after.ok());
  CHECK_FALSE(after.value().has_value());
}

void check_all_ways(const std::vector<Triangle>& triangles, const OpenOptions& options) {
  const Settings settings = at_origin();
  const std::vector<Slice> expected = reference(triangles, settings);
  for (const Way& way : kWays) {
    CAPTURE(way.name);
    OpenedPart part = opened(triangles, settings, way, options);
    if (part.summary.layers != 0) CHECK_EQ(part.summary.layers, std::ssize(expected));
    check_same(expected, std::move(part));
  }
}

// Anywhere, turned any way: nothing of it is closed.
std::vector<Triangle> random_soup(test::Random& random) {
  const bool many = random.integer(0, 9) == 0;
  const int count = many ? random.integer(1'200, 3'000) : random.integer(1, 40);
  const int size = many ? 3'000 : 100'000, height = random.integer(2'000, 20'000);
  std::vector<Triangle> soup;
  for (int i = 0; i < count; ++i) {
    const int x = random.integer(0, 1'000'000), y = random.integer(0, 1'000'000);
    const auto corner = [&] {
      return core::Vertex{x + random.integer(0, size), y + random.integer(0, size),
                          random.integer(-height, height)};
    };
    soup.push_back({{corner(), corner(), corner()}});
  }
  soup.push_back({{core::Vertex{0, 0, -height}, {9'000, 500, height}, {100, 9'000, 3}}});
  return soup;
}

// Square columns, one on the other, each a little smaller: 12 facets each, in order of height.
std::vector<Triangle> stacked_boxes(int count) {
  std::vector<parts::Part> boxes;
  for (int i = 0; i < count; ++i) {
    const double inset = 0.001 * (i % 500);
    boxes.push_back(parts::box({inset, inset, 0.4 * i}, 9, 8, 0.4));
  }
  return test::triangles_of(parts::together(std::move(boxes)));
}

void sort_by_height(std::vector<Triangle>& triangles) {
  std::stable_sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return a.lowest_z() < b.lowest_z();
  });
}

OpenOptions tight() { return {host::kSortBytesMin, host::kReorderTriangles, false}; }

}  // namespace

TEST_CASE("random soups of triangles") {
  // More by hand: RIND_SOUPS=10000 RIND_SOUPS_FROM=0 tests/host_part_mesh_layers_test
  const auto number = [](const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? std::atoi(text) : otherwise;
  };
  const int first = number("RIND_SOUPS_FROM", 0), soups = number("RIND_SOUPS", 60);
  for (int seed = first; seed < first + soups; ++seed) {
    CAPTURE(seed);
    test::Random random(static_cast<std::uint64_t>(seed));
    std::vector<Triangle> soup = random_soup(random);
    const int order = random.integer(0, 2);
    CAPTURE(order);
    // A look-ahead of all lets the stream know its whole extent.
    OpenOptions options = tight();
    if (order > 0) sort_by_height(soup);
    if (order == 2) options.reorder_triangles = std::max<std::size_t>(2, soup.size() / 2);
    if (order < 2) {
      check_all_ways(soup, options);
    } else {
      // The extent of its first half is not the whole's.
      const Settings settings = at_origin();
      const std::vector<Slice> expected = reference(soup, settings);
      check_same(expected, opened(soup, settings, kWays[0], options));
      check_same(expected, opened(soup, settings, kWays[1], options));
    }
  }
}

TEST_CASE("in order, nearly, shuffled, in reverse, in any budget") {
  test::Random random(1);
  const std::vector<Triangle> sorted = stacked_boxes(250);
  for (const std::size_t sort_bytes : {host::kSortBytesMin, host::kSortBytesDefault}) {
    for (const std::size_t window : {std::size_t{2}, std::size_t{100}, std::size_t{1'000}}) {
      CAPTURE(sort_bytes);
      CAPTURE(window);
      const OpenOptions options{sort_bytes, window, false};
      std::vector<Triangle> triangles = sorted;
      check_all_ways(triangles, options);
      for (std::size_t i = 0; i + 40 <= triangles.size(); i += 40) {
        std::reverse(triangles.begin() + static_cast<std::ptrdiff_t>(i),
                     triangles.begin() + static_cast<std::ptrdiff_t>(i) + 40);
      }
      check_all_ways(triangles, {sort_bytes, std::max<std::size_t>(window, 100), false});
      std::reverse(triangles.begin(), triangles.end());
      check_all_ways(triangles, options);
      test::shuffle(triangles, random);
      check_all_ways(triangles, options);
    }
  }
}

TEST_CASE("an order that breaks late: the last facet is the lowest, or as tall as the part") {
  std::vector<Triangle> triangles = stacked_boxes(250);
  const OpenOptions options{host::kSortBytesMin, 100, false};
  const Settings settings = at_origin();
  std::rotate(triangles.begin(), triangles.begin() + 1, triangles.end());
  check_same(reference(triangles, settings), opened(triangles, settings, kWays[0], options));
  check_same(reference(triangles, settings), opened(triangles, settings, kWays[1], options));
  triangles.push_back({{core::Vertex{0, 0, 0}, {9'000, 0, 900'000}, {0, 9'000, 3}}});
  check_same(reference(triangles, settings), opened(triangles, settings, kWays[0], options));
  check_same(reference(triangles, settings), opened(triangles, settings, kWays[1], options));
}

TEST_CASE("all facets with the same lowest z") {
  test::Random random(2);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 3'000; ++i) {
    const int x = 300 * (i % 60), y = 300 * (i / 60);
    triangles.push_back({{core::Vertex{x, y, 5},
                          {x + 250, y, 5 + random.integer(1, 9'000)},
                          {x, y + 250, 5 + random.integer(1, 9'000)}}});
  }
  check_all_ways(triangles, tight());
  test::shuffle(triangles, random);
  check_all_ways(triangles, {host::kSortBytesMin, 50, false});
}

TEST_CASE("a sorted file is never written anew, a sorted pipe not read ahead") {
  const std::vector<Triangle> triangles = stacked_boxes(5'000);
  const OpenOptions options{host::kSortBytesMin, 500, false};
  const Settings settings = at_origin();
  OpenedPart file = opened(triangles, settings, kWays[0], options);
  CHECK_EQ(file.counters().spilled_bytes, 0);
  CHECK_EQ(file.summary.layers, 10'000);
  CHECK_GT(opened(triangles, settings, kWays[1], options).counters().spilled_bytes, 0);

  test::ListedMesh pipe = test::listed_mesh(triangles, true);
  OpenOptions streamed = options;
  streamed.stream_pipes = true;
  auto part = host::open_mesh(std::move(pipe.input), settings, streamed);
  REQUIRE(part.ok());
  CHECK_FALSE(part.value().read_rest);
  CHECK_EQ(part.value().summary.layers, 0);
  for (int layer = 0; layer < 100; ++layer) REQUIRE(part.value().layers->next().ok());
  // 100 layers are 50 boxes; then the window, and two batches that the clock is looked at for.
  CHECK_LT(*pipe.taken, 50 * 12 + 500 + 2 * 1'100);
}

TEST_CASE("a part 100 km high, in a file and in a pipe") {
  const Settings settings = at_origin();
  constexpr std::int64_t kTop = 1'000'000'000'000;  // 100 km
  const std::vector<Triangle> triangles = [] {
    std::vector<Triangle> box = test::triangles_of(parts::box({0, 0, 0}, 9, 8, 1));
    for (Triangle& t : box) {
      for (core::Vertex& v : t.corners) v.z = v.z > 0 ? kTop : 0;
    }
    return box;
  }();
  for (const Way& way : kWays) {
    CAPTURE(way.name);
    OpenOptions options{host::kSortBytesMin, 4, false};
    options.tall = true;
    OpenedPart part = opened(triangles, settings, way, options);
    if (!way.stream) {
      CHECK_EQ(part.summary.layers, 500'000'000);
      CHECK_EQ(part.summary.height.mm(), 1e8);
    }
    for (int layer = 0; layer < 50; ++layer) {
      const auto slice = part.layers->next();
      REQUIRE(slice.ok());
      CHECK_EQ(slice.value()->region.area_mm2(), doctest::Approx(72));
    }
  }
  // Far up, on the way there nothing: two boxes, the upper one 100 km above the bed.
  std::vector<Triangle> apart = test::triangles_of(parts::box({0, 0, 0}, 9, 8, 1));
  std::vector<Triangle> upper = apart;
  for (Triangle& t : upper) {
    for (core::Vertex& v : t.corners) v.z += kTop;
  }
  apart.insert(apart.end(), upper.begin(), upper.end());
  host::MeshSurvey survey(8);
  for (const Triangle& t : apart) survey.add(t);
  CHECK_EQ(survey.empty_layers(layer_heights(settings)).count, 500'000'000 - 5);
}

TEST_CASE("whether a pipe is in order is guessed from its first triangles, unless somebody knows") {
  test::Random random(3);
  std::vector<Triangle> triangles = stacked_boxes(5'000);
  const Settings settings = at_origin();
  const auto streams = [&](const std::vector<Triangle>& all, bool sure) {
    test::ListedMesh pipe = test::listed_mesh(all, true);
    OpenOptions options{host::kSortBytesMin, 1'000, true};
    options.order_is_sure = sure;
    auto part = host::open_mesh(std::move(pipe.input), settings, options);
    REQUIRE(part.ok());
    return !part.value().read_rest;
  };
  CHECK(streams(triangles, false));
  // 40 triangles, a twenty-fifth of the look-ahead.
  for (std::size_t i = 0; i + 40 <= triangles.size(); i += 40) {
    std::reverse(triangles.begin() + static_cast<std::ptrdiff_t>(i),
                 triangles.begin() + static_cast<std::ptrdiff_t>(i) + 40);
  }
  CHECK(streams(triangles, false));
  // 400: enough room to put them in order, but no sign of it; those who know are believed.
  for (std::size_t i = 0; i + 400 <= triangles.size(); i += 400) {
    std::reverse(triangles.begin() + static_cast<std::ptrdiff_t>(i),
                 triangles.begin() + static_cast<std::ptrdiff_t>(i) + 400);
  }
  CHECK_FALSE(streams(triangles, false));
  CHECK(streams(triangles, true));
  test::shuffle(triangles, random);
  CHECK_FALSE(streams(triangles, false));
  check_same(reference(triangles, settings),
             opened(triangles, settings, kWays[1], {host::kSortBytesMin, 1'000, false}));
}

TEST_CASE("a pipe that turns out not to be in order ends with an error, not with a wrong part") {
  std::vector<Triangle> triangles = stacked_boxes(2'000);
  const auto error_of = [](const std::vector<Triangle>& all, const Settings& settings) {
    OpenedPart part = opened(all, settings, kWays[2], {host::kSortBytesMin, 500, false});
    while (true) {
      const auto slice = part.layers->next();
      if (!slice.ok()) return slice.error();
      if (!slice.value()) return core::Error{core::ErrorCode::kBadSetting, "no error"};
    }
  };
  Settings settings = at_origin();
  const auto put_at = [&](std::size_t place, const Triangle& triangle) {
    std::vector<Triangle> all = triangles;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), triangle);
    return all;
  };
  const Triangle low{{core::Vertex{0, 0, 3'000}, {9'000, 0, 9'000}, {0, 9'000, 9'000}}};
  const core::Error late = error_of(put_at(12'000, low), settings);
  CHECK_EQ(late.code, core::ErrorCode::kBadPart);
  for (const char* text : {"facet 12", "0.3 mm", "--sorted no"}) {
    CAPTURE(late.message);
    CHECK(late.message.find(text) != std::string::npos);
  }
  // Between two planes: no slice is wrong without it.
  const Triangle thin{{core::Vertex{0, 0, 3'100}, {9'000, 0, 3'200}, {0, 9'000, 3'300}}};
  CHECK_EQ(error_of(put_at(12'000, thin), settings).message, "no error");
  const Triangle wide{
      {core::Vertex{0, 0, 4'000'000}, {3'001'000, 0, 4'009'000}, {0, 9, 4'009'000}}};
  CHECK_EQ(error_of(put_at(12'000, wide), settings).code, core::ErrorCode::kOutOfBounds);
  settings.axis_z = Length::from_mm(500);
  CHECK_EQ(error_of(triangles, settings).code, core::ErrorCode::kOutOfBounds);
}
