#include "core/slices/segment_chains.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/booleans/boolean.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Length;
using core::Point;
using core::Region;
using core::Ring;
using core::Segment;
using core::SegmentIndex;
using core::SliceDefects;

namespace {

constexpr std::int64_t kGapMax = 20'000;

std::vector<Segment> segments_of(const std::vector<Ring>& rings) {
  std::vector<Segment> segments;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  return segments;
}

// Not closed.
std::vector<Segment> path(std::string_view points_mm) {
  const Ring points = test::rings_from_text(points_mm).front();
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < points.size(); ++i) segments.push_back({points[i - 1], points[i]});
  return segments;
}

std::vector<Segment> operator+(std::vector<Segment> a, const std::vector<Segment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Outcome {
  Region region;
  SliceDefects defects;
};

Outcome outcome(const std::vector<Segment>& segments, std::int64_t gap_max = kGapMax) {
  Outcome result;
  const auto never = [](SegmentIndex, SegmentIndex) { return false; };
  const std::vector<Ring> rings =
      core::rings_of(segments, Length::from_units(gap_max), never, result.defects).rings;
  result.region = core::clean(rings, core::FillRule::kNonZero);
  return result;
}

void shuffle(std::vector<Segment>& segments, test::Random& random) {
  for (std::size_t i = segments.size(); i > 1; --i) {
    std::swap(segments[i - 1],
              segments[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  }
}

}  // namespace

TEST_CASE("shuffled segments of any regions chain back to them") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Region region = test::random_region(random, 200, 10);
    std::vector<Segment> segments = segments_of(region.rings());
    shuffle(segments, random);
    const Outcome chained = outcome(segments);
    CHECK(test::widest_difference(chained.region, region) == 0);
    CHECK_FALSE(chained.defects.any());
  }
}

TEST_CASE("some flipped segments do not matter, and are counted") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    Ring ring = test::random_blob(random, 100, 0, 0, 5, 0.3);
    std::vector<Segment> segments = segments_of({ring});
    for (int i = 0; i < 10; ++i) {
      Segment& s = segments[static_cast<std::size_t>(i) * 9];
      std::swap(s.from, s.to);
    }
    shuffle(segments, random);
    const Outcome chained = outcome(segments);
    CHECK(test::widest_difference(chained.region, core::clean({ring}, core::FillRule::kNonZero)) ==
          0);
    CHECK_EQ(chained.defects.flipped_facets, 10);
    CHECK_EQ(chained.defects.closed_chains, 0);
  }
}

TEST_CASE("a wall that two bodies share joins them") {
  const Outcome joined = outcome(segments_of(test::rings_from_text("0:0 5:0 5:5 0:5")) +
                                 segments_of(test::rings_from_text("5:0 9:0 9:5 5:5")));
  CHECK(joined.region.area_mm2() == doctest::Approx(45));
  CHECK_EQ(joined.region.rings().size(), 1);
  CHECK_FALSE(joined.defects.any());
  // The same with the shared wall flipped in one of the two.
  const Outcome flipped = outcome(segments_of(test::rings_from_text("0:0 5:0 5:5 0:5")) +
                                  path("5:0 9:0 9:5 5:5") + path("5:0 5:5"));
  CHECK(flipped.region.area_mm2() == doctest::Approx(45));
}

TEST_CASE("a sheet without thickness is nothing") {
  CHECK(outcome(path("0:0 5:0 9:3") + path("9:3 5:0 0:0")).region.empty());
}

TEST_CASE("small gaps are closed wherever they are, nearest ends first") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const Ring ring = test::random_blob(random, 200, 0, 0, 20, 0.1);
    const Region whole = core::clean({ring}, core::FillRule::kNonZero);
    std::vector<Segment> all = segments_of({ring}), segments;
    // Every tenth segment is cut short at its end by a twentieth of a millimetre.
    for (std::size_t i = 0; i < all.size(); ++i) {
      Segment s = all[i];
      if (i % 10 == 0) s.to.x += 300, s.to.y -= 400;
      segments.push_back(s);
    }
    shuffle(segments, random);
    const Outcome closed = outcome(segments);
    CHECK_EQ(closed.defects.closed_chains, 20);
    CHECK_EQ(closed.defects.dropped_chains, 0);
    CHECK_EQ(closed.defects.widest_gap.units(), 500);
    // A corner is moved by 500 units, and the line that closes the gap goes back to its old place.
    CHECK(test::boundary_distance(closed.region, whole) <= 1'000);
  }
}

TEST_CASE("wide gaps: what is left of a contour is kept, a sheet is not made a body") {
  struct Case {
    const char* why;
    std::vector<Segment> segments;
    double area_mm2;
    std::int64_t closed, dropped;
  };
  const std::vector<Case> cases = {
      {"one side missing", path("20:0 20:20 0:20 0:0"), 400, 1, 0},
      {"half a side missing", path("10:0 20:0 20:20 0:20 0:0"), 400, 1, 0},
      {"the long side of a plate missing", path("0:0 0:4 20:4 20:0"), 80, 1, 0},
      {"two short sides missing", path("0:0 20:0") + path("20:15 0:15"), 300, 2, 0},
      {"two long sides missing", path("0:0 15:0") + path("15:20 0:20"), 0, 0, 1},
      {"two sheets that look the same way", path("0:0 10:0") + path("0:5 10:5"), 0, 0, 1},
      {"half of two opposite sides missing", path("15:20 0:20 0:0 5:0") + path("15:0 20:0 20:20"),
       400, 2, 0},
      {"a straight sheet", path("0:0 10:0 20:0"), 0, 0, 1},
      {"a bent sheet", path("0:0 10:1 20:0"), 0, 0, 1},
      {"a sheet and a body",
       path("0:0 10:0 20:0") + segments_of(test::rings_from_text("0:5 9:5 9:9 0:9")), 36, 0, 1},
  };
  for (const Case& c : cases) {
    CAPTURE(c.why);
    const Outcome result = outcome(c.segments);
    CHECK(result.region.area_mm2() == doctest::Approx(c.area_mm2));
    CHECK_EQ(result.defects.closed_chains, c.closed);
    CHECK_EQ(result.defects.dropped_chains, c.dropped);
  }
}

TEST_CASE("thousands of loose pieces: none is lost count of") {
  // A grid of squares, each of four loose sides with gaps at its corners.
  std::vector<Segment> segments;
  constexpr int kSquares = 60;
  for (int i = 0; i < kSquares; ++i) {
    for (int j = 0; j < kSquares; ++j) {
      const std::int32_t x = i * 100'000, y = j * 100'000, s = 50'000, gap = 100;
      segments.push_back({{x + gap, y}, {x + s - gap, y}});
      segments.push_back({{x + s, y + gap}, {x + s, y + s - gap}});
      segments.push_back({{x + s - gap, y + s}, {x + gap, y + s}});
      segments.push_back({{x, y + s - gap}, {x, y + gap}});
    }
  }
  const Outcome result = outcome(segments);
  CHECK_EQ(result.defects.closed_chains, 4 * kSquares * kSquares);
  CHECK_EQ(result.defects.dropped_chains, 0);
  CHECK_EQ(result.region.rings().size(), kSquares * kSquares);
}

TEST_CASE("points between segments on one line are left out") {
  const std::vector<Segment> segments = path("0:0 3:0 9:0 9:9 0:9 0:0");
  SliceDefects defects;
  const auto rings = core::rings_of(
                         segments, Length::from_units(0),
                         [](SegmentIndex a, SegmentIndex b) { return a < 2 && b < 2; }, defects)
                         .rings;
  REQUIRE_EQ(rings.size(), 1);
  CHECK_EQ(rings[0].size(), 4);
  CHECK_EQ(std::count(rings[0].begin(), rings[0].end(), Point{30'000, 0}), 0);
}

TEST_CASE("random segments, loops and stars never break it") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<Segment> segments;
    const int span = random.integer(1, 12);
    const auto point = [&random, span] {
      return Point{10'000 * random.integer(0, span), 10'000 * random.integer(0, span)};
    };
    for (int i = random.integer(0, 60); i > 0; --i) segments.push_back({point(), point()});
    const Outcome first = outcome(segments);
    CHECK(test::is_clean(first.region));
    shuffle(segments, random);
    const Outcome second = outcome(segments);
    CHECK_EQ(second.region, first.region);
    CHECK_EQ(second.defects.closed_chains, first.defects.closed_chains);
    CHECK_EQ(second.defects.dropped_chains, first.defects.dropped_chains);
  }
}
