#include "host/part/mesh_sorter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host/part/triangle_record.h"
#include "host/system/limits.h"
#include "tests/support/mesh.h"
#include "tests/support/temporary_folder.h"

using core::Triangle;
using host::MeshSorter;

namespace {

const MeshSorter::Options kAmple{host::kSortBytesDefault, ""};
const MeshSorter::Options kTight{host::kSortBytesMin, ""};

std::vector<Triangle> rest_of(MeshSorter& sorter) {
  std::vector<Triangle> all;
  while (true) {
    const auto triangle = sorter.next();
    REQUIRE(triangle.ok());
    if (!triangle.value()) return all;
    all.push_back(*triangle.value());
  }
}

std::vector<Triangle> sorted(const std::vector<Triangle>& triangles,
                             const MeshSorter::Options& options, int passes) {
  MeshSorter sorter(options);
  for (const Triangle& t : triangles) REQUIRE(sorter.add(t).ok());
  REQUIRE(sorter.finish().ok());
  CHECK_EQ(sorter.size(), std::ssize(triangles));
  CHECK_EQ(sorter.spill_passes(), passes);
  CHECK_EQ(sorter.spilled_bytes() > 0, passes > 0);
  return rest_of(sorter);
}

std::vector<Triangle> random_triangles(test::Random& random, int count, int reach) {
  std::vector<Triangle> triangles;
  const auto corner = [&] {
    return core::Vertex{random.integer(-9, 9), random.integer(-reach, reach),
                        std::int64_t{random.integer(-50, 50)} * reach};
  };
  for (int i = 0; i < count; ++i) triangles.push_back({{corner(), corner(), corner()}});
  return triangles;
}

bool same(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Triangle& s, const Triangle& t) { return s.corners == t.corners; });
}

// The order by its definition.
std::vector<Triangle> in_order(std::vector<Triangle> triangles) {
  std::stable_sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return a.lowest_z() < b.lowest_z();
  });
  return triangles;
}

}  // namespace

TEST_CASE("all triangles come out in order, in memory, in one pass, in several") {
  // 64 KiB hold 960 triangles with their keys, and 15 runs are merged at once.
  struct Case {
    int count, passes;
  };
  for (const Case& each : {Case{0, 0}, {1, 0}, {960, 0}, {961, 1}, {14'000, 1}, {25'000, 2}}) {
    CAPTURE(each.count);
    // Heights of one digit of the radix sort, of two and three, and too far apart for it.
    for (const int reach : {1, 9, 3'000, 20'000'000, 400'000'000}) {
      test::Random random(static_cast<std::uint64_t>(each.count + reach));
      const std::vector<Triangle> triangles = random_triangles(random, each.count, reach);
      CHECK(same(sorted(triangles, kTight, each.passes), in_order(triangles)));
      CHECK(same(sorted(triangles, kAmple, 0), in_order(triangles)));
    }
  }
}

TEST_CASE("equally low ones keep their order, whatever the budget") {
  test::Random random(3);
  std::vector<Triangle> triangles = random_triangles(random, 25'000, 1);
  for (Triangle& t : triangles) t.corners[0].z = -100;  // all with the same lowest z
  CHECK(same(sorted(triangles, kAmple, 0), triangles));
  CHECK(same(sorted(triangles, kTight, 2), triangles));
}

TEST_CASE("it can be read again, and at the end it stays at the end") {
  test::Random random(4);
  const std::vector<Triangle> triangles = random_triangles(random, 3'000, 50);
  for (const MeshSorter::Options& options : {kAmple, kTight}) {
    MeshSorter sorter(options);
    for (const Triangle& t : triangles) REQUIRE(sorter.add(t).ok());
    REQUIRE(sorter.finish().ok());
    const std::vector<Triangle> first = rest_of(sorter);
    CHECK_FALSE(sorter.next().value().has_value());
    REQUIRE(sorter.rewind().ok());
    REQUIRE(sorter.next().ok());
    REQUIRE(sorter.rewind().ok());
    CHECK(same(rest_of(sorter), first));
  }
}

TEST_CASE("records read back to the same triangles, the farthest included") {
  constexpr std::int32_t kLow = INT32_MIN, kHigh = INT32_MAX;
  constexpr std::int64_t kDeep = INT64_MIN, kTall = INT64_MAX;
  test::Random random(5);
  std::vector<Triangle> triangles = random_triangles(random, 200, 1'000'000);
  triangles.push_back({{core::Vertex{kLow, kLow, kDeep}, {kHigh, kHigh, kTall}, {0, -1, 0}}});
  triangles.push_back({{core::Vertex{kHigh, kLow, kTall}, {kLow, kHigh, kDeep}, {1, 0, -1}}});
  std::string bytes;
  core::Vertex before;
  for (const Triangle& t : triangles) {
    const std::size_t begin = bytes.size();
    host::write_triangle(t, before, bytes);
    CHECK_LE(bytes.size() - begin, host::kTriangleRecordBytesMax);
    before = t.corners[0];
  }
  const char* at = bytes.data();
  before = {};
  for (const Triangle& t : triangles) {
    Triangle read;
    at = host::read_triangle(at, before, read);
    CHECK(read.corners == t.corners);
    before = read.corners[0];
  }
  CHECK(at == bytes.data() + bytes.size());
}

TEST_CASE("nothing of the file is to be seen while it is there") {
  const test::TemporaryFolder folder;
  test::Random random(6);
  MeshSorter sorter({host::kSortBytesMin, folder.path()});
  for (const Triangle& t : random_triangles(random, 5'000, 9)) REQUIRE(sorter.add(t).ok());
  CHECK(std::filesystem::is_empty(folder.path()));
  REQUIRE(sorter.finish().ok());
  CHECK_GT(sorter.spilled_bytes(), 0);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a folder that can't be written to is named, with what to do") {
  test::Random random(7);
  const std::vector<Triangle> triangles = random_triangles(random, 2'000, 9);
  MeshSorter sorter({host::kSortBytesMin, "/nowhere"});
  core::Status status;
  for (const Triangle& t : triangles) {
    status = sorter.add(t);
    if (!status.ok()) break;
  }
  REQUIRE_FALSE(status.ok());
  CHECK_EQ(status.error().code, core::ErrorCode::kUnreadable);
  for (const char* text : {"/nowhere", "No such file", "TMPDIR", "--memory"}) {
    CHECK(status.error().message.find(text) != std::string::npos);
  }
}
