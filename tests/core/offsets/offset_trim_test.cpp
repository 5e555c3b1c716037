#include "core/offsets/offset_trim.h"

#include <doctest/doctest.h>

#include <vector>

#include "core/offsets/offset_runs.h"
#include "tests/support/offset_elements.h"
#include "tests/support/random_regions.h"

using core::OffsetInput;
using core::OffsetTrim;
using core::Region;
using test::Random;

namespace {

// How often an element, sampled along its length, comes out from under the capsules of all edges.
int uncovered_stretches(const OffsetInput& contours, std::size_t edge, double depth) {
  constexpr int kSamples = 500;
  int stretches = 0, length = 0;
  for (int k = 0; k <= kSamples; ++k) {
    const double along = contours.edges()[edge].length * (k + 0.5) / (kSamples + 1);
    const bool covered =
        test::distance_to_all(contours, test::on_line(contours, edge, along, depth)) < depth - 1e-6;
    length = covered ? 0 : length + 1;
    if (length == 1) ++stretches;
  }
  return stretches;
}

struct Trimmed {
  OffsetInput contours;
  core::OffsetSearch search;
  OffsetTrim trim;

  Trimmed(const Region& region, bool mirrored, double deepest) {
    contours.load(region, mirrored);
    prepare(deepest);
  }
  void prepare(double deepest) {
    core::find_runs(contours, deepest);
    search.prepare(contours, deepest);
  }
  void cut(const std::vector<double>& depths) {
    if (trim.trim(contours, search, depths)) return;
    contours.mend_touching();
    prepare(search.deepest());
    REQUIRE(trim.trim(contours, search, depths));
  }
};

}  // namespace

TEST_CASE("pieces start where their own element and the site before are both at the depth") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 60, 20);
    for (const bool mirrored : {false, true}) {
      const std::vector<double> depths{700.00006, 2'500.00006, 8'000.00006};
      Trimmed trimmed(region, mirrored, depths[2] + 1);
      trimmed.cut(depths);
      for (std::size_t at = 0; at < depths.size(); ++at) {
        const double depth = depths[at];
        CAPTURE(depth);
        for (const core::TrimmedPiece& piece : trimmed.trim.pieces(at)) {
          if (piece.element % 2 != 0) continue;
          const auto edge = static_cast<std::size_t>(piece.element / 2);
          const test::ElementPoint p = test::on_line(trimmed.contours, edge, piece.from, depth);
          CHECK(test::distance_to_all(trimmed.contours, p) == doctest::Approx(depth).epsilon(1e-7));
          const auto site = static_cast<std::size_t>(piece.from_site / 2);
          CHECK(test::distance_to_edge(trimmed.contours.edges()[site], p) ==
                doctest::Approx(depth).epsilon(1e-7));
        }
      }
    }
  }
}

TEST_CASE("every stretch of a line that no capsule covers is a piece, and nothing else") {
  int stretches = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 40, 20);
    const double depth = 3'000.00006;
    Trimmed trimmed(region, seed % 2 == 0, depth + 1);
    trimmed.cut({depth});
    int differing = 0;
    for (std::size_t i = 0; i < trimmed.contours.edges().size(); ++i) {
      const auto element = static_cast<core::OffsetSite>(2 * i);
      const int pieces = trimmed.trim.first(0, element + 1) - trimmed.trim.first(0, element);
      const int sampled = uncovered_stretches(trimmed.contours, i, depth);
      stretches += pieces;
      // Shorter than the samples' distance, a piece may not be seen.
      CHECK_GE(pieces, sampled);
      differing += pieces != sampled ? 1 : 0;
    }
    CHECK_LE(differing, 2);
  }
  CHECK_GT(stretches, 100);
}

TEST_CASE("depths that are trimmed together give what each gives alone") {
  int pieces = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Region region = test::random_region(random, 100, 20);
    const std::vector<double> depths{500 + 6e-5, 2'000 + 6e-5, 5'000 + 6e-5, 9'000 + 6e-5};
    Trimmed together(region, seed % 2 == 0, 9'001);
    together.cut(depths);
    for (std::size_t at = 0; at < depths.size(); ++at) {
      CAPTURE(depths[at]);
      Trimmed alone(region, seed % 2 == 0, 9'001);
      alone.cut({depths[at]});
      const auto of_all = together.trim.pieces(at), of_one = alone.trim.pieces(0);
      REQUIRE_EQ(of_all.size(), of_one.size());
      pieces += static_cast<int>(of_one.size());
      for (std::size_t i = 0; i < of_one.size(); ++i) {
        CHECK_EQ(of_all[i].element, of_one[i].element);
        const auto edge = static_cast<std::size_t>(of_one[i].element / 2);
        const bool whole_start = of_one[i].element % 2 != 0 &&
                                 of_one[i].from_site == 2 * alone.contours.edges()[edge].previous;
        if (!whole_start) CHECK_EQ(of_all[i].from, of_one[i].from);
        CHECK_EQ(of_all[i].from_site, of_one[i].from_site);
        CHECK_EQ(of_all[i].to_site, of_one[i].to_site);
      }
    }
  }
  CHECK_GT(pieces, 10'000);
}
