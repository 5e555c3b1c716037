#include "host/mesh_sorter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/support/mesh.h"

using core::Triangle;
using host::MeshSorter;

namespace {

std::vector<Triangle> drained(MeshSorter& sorter) {
  REQUIRE(sorter.finish().ok());
  std::vector<Triangle> all;
  while (true) {
    const auto triangle = sorter.next();
    REQUIRE(triangle.ok());
    if (!triangle.value()) return all;
    all.push_back(*triangle.value());
  }
}

std::vector<Triangle> random_triangles(test::Random& random, int count) {
  std::vector<Triangle> triangles;
  const auto corner = [&random] {
    return core::Vertex{random.integer(-9, 9), random.integer(-9, 9), random.integer(-50, 50)};
  };
  for (int i = 0; i < count; ++i) triangles.push_back({{corner(), corner(), corner()}});
  return triangles;
}

bool by_corners(const Triangle& a, const Triangle& b) { return a.corners < b.corners; }

}  // namespace

TEST_CASE("all triangles come out, in order of lowest z, whatever the runs' size") {
  for (const std::size_t run : {std::size_t{1}, std::size_t{7}, std::size_t{1000}}) {
    for (const int count : {0, 1, 2, 7, 8, 500}) {
      CAPTURE(run);
      CAPTURE(count);
      test::Random random(static_cast<std::uint64_t>(count) + run);
      std::vector<Triangle> triangles = random_triangles(random, count);
      MeshSorter sorter(run);
      for (const Triangle& t : triangles) REQUIRE(sorter.add(t).ok());
      CHECK_EQ(sorter.size(), count);
      std::vector<Triangle> sorted = drained(sorter);
      for (std::size_t i = 1; i < sorted.size(); ++i) {
        CHECK(sorted[i - 1].lowest_z() <= sorted[i].lowest_z());
      }
      std::sort(sorted.begin(), sorted.end(), by_corners);
      std::sort(triangles.begin(), triangles.end(), by_corners);
      REQUIRE_EQ(sorted.size(), triangles.size());
      for (std::size_t i = 0; i < sorted.size(); ++i) {
        CHECK(sorted[i].corners == triangles[i].corners);
      }
    }
  }
}

TEST_CASE("what comes out depends neither on the order of what goes in nor on the runs") {
  test::Random random(3);
  std::vector<Triangle> triangles = random_triangles(random, 300);
  MeshSorter once;
  for (const Triangle& t : triangles) REQUIRE(once.add(t).ok());
  const std::vector<Triangle> expected = drained(once);
  for (const std::size_t run : {std::size_t{2}, std::size_t{64}}) {
    test::shuffle(triangles, random);
    MeshSorter sorter(run);
    for (const Triangle& t : triangles) REQUIRE(sorter.add(t).ok());
    const std::vector<Triangle> sorted = drained(sorter);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CHECK(sorted[i].corners == expected[i].corners);
    }
  }
}

TEST_CASE("at the end it stays at the end") {
  MeshSorter sorter;
  REQUIRE(sorter.add({{core::Vertex{0, 0, 1}, core::Vertex{1, 0, 2}, core::Vertex{0, 1, 3}}}).ok());
  CHECK_EQ(drained(sorter).size(), 1);
  CHECK_FALSE(sorter.next().value().has_value());
}
