// Pieces that meet a region, held against a boolean of each piece with all of it.
#include "core/supports/pieces_that_meet.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "tests/support/random_regions.h"
#include "tests/support/region_text.h"

using core::Region;

namespace {

// Small blobs anywhere; some meet one another and become one.
Region crumbs(test::Random& random, int count, double radius_max_mm) {
  std::vector<core::Ring> rings;
  for (int i = 0; i < count; ++i) {
    rings.push_back(test::random_blob(random, 7, random.between(0, 20), random.between(0, 20),
                                      random.between(0.05, radius_max_mm), 0.3));
  }
  return core::clean(rings, core::FillRule::kPositive);
}

std::vector<Region> pieces_of(const Region& region) {
  std::vector<Region> pieces;
  for (core::Island& island : core::islands(region)) {
    pieces.push_back(core::region_of(std::move(island)));
  }
  return pieces;
}

}  // namespace

TEST_CASE("the pieces that meet a region are those that have something in common with it") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    const std::vector<Region> pieces = pieces_of(crumbs(random, 120, 0.6));
    for (const Region& with : {crumbs(random, 60, 0.6), crumbs(random, 4, 6), Region(),
                               test::random_region(random, 200, 20)}) {
      std::vector<Region> expected;
      for (const Region& piece : pieces) {
        if (!core::intersect(piece, with).empty()) expected.push_back(piece);
      }
      CHECK(core::pieces_that_meet(pieces, with) == expected);
    }
  }
}

TEST_CASE("a piece in a hole, and one that is touched, don't meet the region") {
  const Region frame = test::region_from_text("0:0 10:0 10:10 0:10, 3:3 3:6 6:6 6:3");
  const std::vector<Region> pieces = {
      test::rectangle_region(4, 4, 1, 1), test::rectangle_region(10, 2, 1, 1),
      test::rectangle_region(9.5, 5, 1, 1), test::rectangle_region(7, 7, 1, 1)};
  const std::vector<Region> met = core::pieces_that_meet(pieces, frame);
  REQUIRE_EQ(met.size(), 2);
  CHECK(met[0] == pieces[2]);
  CHECK(met[1] == pieces[3]);
}
