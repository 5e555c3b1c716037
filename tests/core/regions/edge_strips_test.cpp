#include "core/regions/edge_strips.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random_regions.h"

using core::EdgeStrips;
using core::Segment;

TEST_CASE("without edges nothing is at any height") {
  CHECK(EdgeStrips(std::vector<Segment>()).at(0).empty());
  CHECK(EdgeStrips(std::vector<Segment>{{{0, 5}, {10, 5}}}).at(5).empty());
}

TEST_CASE("every edge that reaches a height is told there, in order, and lists stay short") {
  test::Random random(42);
  for (int round = 0; round < 50; ++round) {
    CAPTURE(round);
    std::vector<Segment> edges;
    // Some are as tall as the whole.
    const int count = random.integer(1, 300), size = random.integer(1, 3'000);
    for (int i = 0; i < count; ++i) {
      const int x = random.integer(0, size), y = random.integer(0, size);
      const int reach = i % 7 == 0 ? size : 20;
      edges.push_back({{x, y}, {random.integer(0, size), y + random.integer(-reach, reach)}});
    }
    const EdgeStrips strips(edges);
    std::size_t told = 0, strips_seen = 0;
    const std::uint32_t* list = nullptr;
    for (int y = -3'005; y <= 6'005; ++y) {
      const auto there = strips.at(y);
      CHECK(std::is_sorted(there.begin(), there.end()));
      for (std::uint32_t i = 0; i < edges.size(); ++i) {
        const auto [low, high] = std::minmax(edges[i].from.y, edges[i].to.y);
        if (low == high || y < low || y > high) continue;
        REQUIRE(std::binary_search(there.begin(), there.end(), i));
      }
      if (there.empty() || there.data() == list) continue;
      list = there.data();
      told += there.size();
      ++strips_seen;
    }
    // An edge may end in the middle of a strip on both sides.
    CHECK_LE(told, (8 + 2) * edges.size());
    CHECK_LE(strips_seen, edges.size() + 1);
  }
}
