#include "core/offsets/offset_span.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random_regions.h"

using core::OffsetEnd;
using core::OffsetSpan;
using core::TrimmedPiece;
using core::TrimmedPieces;
using test::Random;

namespace {

struct Removed {
  OffsetEnd from, to;
};

constexpr double kTolerance = 1e-9;

// Whether `at` is left of an element that reaches from 0 to 100.
bool left(const std::vector<Removed>& removed, double at) {
  for (const Removed& gap : removed) {
    if (gap.from.at < at && at < gap.to.at) return false;
  }
  return 0 < at && at < 100;
}

}  // namespace

TEST_CASE("what is left is the window without the intervals, each end with its own site") {
  for (std::uint64_t seed = 1; seed <= 3'000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    OffsetSpan span;
    span.reset({0, 1'000}, {100, 1'001}, kTolerance);
    std::vector<Removed> removed;
    for (int i = random.integer(0, 8); i > 0; --i) {
      const double from = random.between(-20, 110);
      const int site = 2 * (10 - i);
      const Removed gap{{from, site}, {from + random.between(0.1, 40), site}};
      span.remove(gap.from, gap.to);
      removed.push_back(gap);
    }
    TrimmedPieces pieces;
    const bool dead = span.dead();
    span.pieces(7, pieces);
    if (dead) CHECK_EQ(pieces.count(), 0);
    // Ends that are left, ascending: where being left changes.
    std::vector<double> ends{0, 100};
    for (const Removed& gap : removed) {
      ends.push_back(gap.from.at);
      ends.push_back(gap.to.at);
    }
    std::vector<double> starts;
    for (const double at : ends) {
      if (left(removed, at + 1e-7) && !left(removed, at - 1e-7)) starts.push_back(at);
    }
    std::sort(starts.begin(), starts.end());
    REQUIRE_EQ(static_cast<std::size_t>(pieces.count()), starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const TrimmedPiece& piece = pieces.all()[i];
      CHECK_EQ(piece.from, starts[i]);
      CHECK_EQ(piece.element, 7);
      const int site = piece.from_site;
      const bool own = starts[i] == 0 && site == 1'000;
      bool known = own;
      for (const Removed& gap : removed)
        known = known || (gap.to.at == starts[i] && site == gap.to.site);
      CHECK(known);
    }
  }
}

TEST_CASE("where an edge and a corner end at one place, the edge gives its name") {
  for (const bool edge_first : {true, false}) {
    OffsetSpan span;
    span.reset({0, 1'000}, {100, 1'001}, 1e-3);
    const OffsetEnd edge{30, 4}, corner{30 + 1e-5, 7};
    // From the left: what is left starts where they end.
    for (const bool is_edge : {edge_first, !edge_first}) {
      span.remove({-1, is_edge ? edge.site : corner.site}, is_edge ? edge : corner);
    }
    TrimmedPieces pieces;
    span.pieces(0, pieces);
    REQUIRE_EQ(pieces.count(), 1);
    CHECK_EQ(pieces.all()[0].from_site, 4);
  }
}

TEST_CASE("an element that is covered whole is dead") {
  OffsetSpan span;
  span.reset({0, 0}, {10, 0}, kTolerance);
  span.remove({-5, 2}, {5, 2});
  CHECK_FALSE(span.dead());
  CHECK_EQ(span.lo(), 5);
  span.remove({4, 6}, {11, 6});
  CHECK(span.dead());
}
