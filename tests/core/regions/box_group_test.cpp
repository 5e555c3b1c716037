#include "core/regions/box_group.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "core/limits.h"
#include "tests/support/random_regions.h"

using core::Box;
using core::BoxGroup;
using test::Random;

namespace {

Box random_box(Random& random, int size) {
  Box box;
  box.add(core::Point{random.integer(-size, size), random.integer(-size, size)});
  box.add(core::Point{random.integer(-size, size), random.integer(-size, size)});
  return box;
}

}  // namespace

TEST_CASE("a group's boxes overlap what they overlap one by one; empty ones overlap nothing") {
  int overlapping = 0, apart = 0;
  for (std::uint64_t seed = 1; seed <= 3'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int size = seed % 2 == 0 ? 6 : core::kCoordinateMax;
    BoxGroup group;
    std::array<Box, BoxGroup::kSize> boxes;
    for (std::uint32_t i = 0; i < BoxGroup::kSize; ++i) {
      if (random.integer(0, 3) == 0) continue;
      boxes[i] = random_box(random, size);
      group.set(i, boxes[i]);
    }
    const Box box = random_box(random, size);
    const std::uint32_t found = group.overlapping(box);
    for (std::uint32_t i = 0; i < BoxGroup::kSize; ++i) {
      CHECK_EQ((found >> i & 1) != 0, boxes[i].overlaps(box));
      CHECK_EQ(group.box(i), boxes[i]);
      ++(boxes[i].overlaps(box) ? overlapping : apart);
    }
    CHECK_EQ(found >> BoxGroup::kSize, 0);
  }
  CHECK_GT(overlapping, 1'000);
  CHECK_GT(apart, 1'000);
}

TEST_CASE("edges are boxed eight at a time") {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int size = seed % 2 == 0 ? 9 : core::kCoordinateMax;
    std::array<core::Point, BoxGroup::kSize + 1> points;
    for (core::Point& p : points) p = {random.integer(-size, size), random.integer(-size, size)};
    BoxGroup group;
    group.set_edges(points.data());
    Box all;
    std::int32_t widest = 0;
    for (std::uint32_t i = 0; i < BoxGroup::kSize; ++i) {
      const Box box = core::box_of(core::Segment{points[i], points[i + 1]});
      CHECK_EQ(group.box(i), box);
      all.add(box);
      widest = std::max(widest, std::min(box.max.x - box.min.x, box.max.y - box.min.y));
    }
    CHECK_EQ(group.around(), all);
    CHECK_EQ(group.widest(), widest);
  }
}
