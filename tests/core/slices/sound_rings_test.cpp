#include "core/slices/sound_rings.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/slices/segment_chains.h"
#include "tests/support/random_regions.h"

using core::Point;
using core::Ring;
using core::Segment;
using core::SegmentIndex;

namespace {

const core::OnOneLine kNever = [](SegmentIndex, SegmentIndex) { return false; };

std::vector<Segment> shuffled(std::vector<Segment> segments, test::Random& random) {
  for (std::size_t i = segments.size(); i > 1; --i) {
    std::swap(segments[i - 1],
              segments[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  }
  return segments;
}

// By the general way: sorted points, numbered.
std::vector<Ring> chained(const std::vector<Segment>& segments) {
  const core::Chains chains = core::chain_segments(segments);
  CHECK(chains.open.empty());
  std::vector<Ring> rings;
  for (const core::Chain& chain : chains.closed) rings.push_back(chain.points);
  return rings;
}

bool is_sound(const std::vector<Segment>& segments) {
  return core::sound_rings(segments, kNever).has_value();
}

}  // namespace

TEST_CASE("rings are those of the general way, in the same order from the same points") {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const core::Region region = test::random_region(random, 200, 12);
    const std::vector<Segment> segments = shuffled(core::edges_of(region.rings()), random);
    const auto rings = core::sound_rings(segments, kNever);
    if (!rings) continue;  // contours touch
    ++found;
    CHECK(*rings == chained(segments));
  }
  CHECK(found >= 40);
}

TEST_CASE("points between two segments on one line are left out, also where a ring starts") {
  // The least point is on a line, too.
  const Ring ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}};
  const std::vector<Segment> segments = core::edges_of({ring});
  const auto on_one_line = [&](SegmentIndex a, SegmentIndex b) {
    return core::cross(segments[a].from, segments[a].to, segments[b].to) == 0;
  };
  const auto rings = core::sound_rings(segments, on_one_line);
  REQUIRE(rings);
  CHECK(*rings == std::vector<Ring>{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
  const Ring turned{{0, 5}, {0, 0}, {10, 0}, {10, 10}, {-1, 10}, {-1, 5}};
  const std::vector<Segment> others = core::edges_of({turned});
  const auto before_first = [](SegmentIndex before, SegmentIndex after) {
    return before == 3 && after == 4;
  };
  const auto left = core::sound_rings(others, before_first);
  REQUIRE(left);
  CHECK(*left == std::vector<Ring>{{{-1, 5}, {0, 5}, {0, 0}, {10, 0}, {10, 10}}});
}

TEST_CASE("segments from a point to itself do not count") {
  std::vector<Segment> segments = core::edges_of({{{0, 0}, {9, 0}, {0, 9}}});
  segments.push_back({{0, 0}, {0, 0}});
  segments.insert(segments.begin(), Segment{{50, 50}, {50, 50}});
  const auto rings = core::sound_rings(segments, kNever);
  REQUIRE(rings);
  CHECK(*rings == std::vector<Ring>{{{0, 0}, {9, 0}, {0, 9}}});
  CHECK(core::sound_rings({}, kNever)->empty());
}

TEST_CASE("what has to be decided is left to the general way") {
  const std::vector<Segment> square =
      core::edges_of({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{20, 0}, {29, 0}, {29, 9}}});
  CHECK(is_sound(square));
  for (std::size_t i = 0; i < square.size(); ++i) {
    CAPTURE(i);
    std::vector<Segment> missing = square, flipped = square, doubled = square, both_ways = square;
    missing.erase(missing.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK_FALSE(is_sound(missing));
    std::swap(flipped[i].from, flipped[i].to);
    CHECK_FALSE(is_sound(flipped));
    doubled.push_back(square[i]);
    CHECK_FALSE(is_sound(doubled));
    both_ways.push_back({square[i].to, square[i].from});
    CHECK_FALSE(is_sound(both_ways));
    // Another chain ends there.
    std::vector<Segment> joined = square;
    joined.push_back({{100, 100}, square[i].from});
    CHECK_FALSE(is_sound(joined));
  }
  CHECK_FALSE(is_sound({{{0, 0}, {5, 0}}, {{5, 0}, {0, 0}}}));
  // Two rings that touch at a point.
  CHECK_FALSE(is_sound(core::edges_of({{{0, 0}, {9, 0}, {9, 9}}, {{0, 0}, {-9, 0}, {-9, -9}}})));
}
