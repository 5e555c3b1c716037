#include "core/regions/clear_contours.h"

#include <doctest/doctest.h>

#include <vector>

#include "core/limits.h"
#include "core/regions/region.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using core::Region;
using core::Ring;
using test::Random;

namespace {

// Edges, or corners, that meet anywhere but in the corner that two edges of a ring share.
bool touch_anywhere(const std::vector<Ring>& rings) {
  struct Edge {
    core::Segment line;
    std::size_t ring, index, count;
  };
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      edges.push_back({{rings[r][i], rings[r][(i + 1) % rings[r].size()]}, r, i, rings[r].size()});
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = i + 1; k < edges.size(); ++k) {
      const std::size_t apart = edges[k].index - edges[i].index;
      if (edges[i].ring == edges[k].ring && (apart == 1 || apart == edges[i].count - 1)) continue;
      for (const core::Point p : {edges[i].line.from, edges[i].line.to}) {
        if (test::distance_to_segment(p, edges[k].line) < 1e-9) return true;
      }
      for (const core::Point p : {edges[k].line.from, edges[k].line.to}) {
        if (test::distance_to_segment(p, edges[i].line) < 1e-9) return true;
      }
    }
  }
  return false;
}

// Rings of three to five corners on a small grid; repeated corners are left to the check.
std::vector<Ring> few_rings(Random& random, int size) {
  std::vector<Ring> rings(static_cast<std::size_t>(random.integer(1, 2)));
  for (Ring& ring : rings) {
    for (int i = random.integer(3, 5); i > 0; --i) {
      core::Point p{random.integer(0, size), random.integer(0, size)};
      if (ring.empty() || ring.back() != p) ring.push_back(p);
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  }
  return rings;
}

}  // namespace

TEST_CASE("rings keep clear just when they are clean and nothing touches") {
  int clear = 0, touching = 0;
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const std::vector<Ring> rings = few_rings(random, random.integer(3, 9));
    const bool clean = test::is_clean(Region::from_clean_rings(rings));
    const bool touches = clean && touch_anywhere(rings);
    CHECK_EQ(core::keep_clear(rings), clean && !touches);
    clear += clean && !touches ? 1 : 0;
    touching += touches ? 1 : 0;
  }
  CHECK_GT(clear, 1'000);
  CHECK_GT(touching, 20);
}

TEST_CASE("nesting is looked at: a hole stands in a contour, an island in a hole") {
  const auto rings = [](const char* text) { return test::rings_from_text(text); };
  CHECK(core::keep_clear(rings("0:0 9:0 9:9 0:9, 2:2 2:7 7:7 7:2, 4:4 5:4 5:5 4:5")));
  CHECK_FALSE(core::keep_clear(rings("0:0 9:0 9:9 0:9, 2:2 7:2 7:7 2:7")));
  CHECK_FALSE(core::keep_clear(rings("0:0 9:0 9:9 0:9, 12:2 12:7 17:7 17:2")));
  CHECK_FALSE(core::keep_clear(rings("0:0 0:9 9:9 9:0")));
  CHECK(core::keep_clear({}));
}

TEST_CASE("it is exact at the limit of coordinates") {
  constexpr std::int32_t kM = core::kCoordinateMax;
  const Ring outer{{-kM, -kM}, {kM, -kM}, {kM, kM}, {-kM, kM}};
  // A needle whose tip comes to a unit from the diagonal's side.
  CHECK(core::keep_clear({outer, {{0, 0}, {-1, 1}, {kM - 1, kM - 2}}}));
  CHECK_FALSE(core::keep_clear({outer, {{0, 0}, {-1, 1}, {kM, kM - 1}}}));
}
