#include "core/motions/fan_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random_regions.h"

using core::FanWish;

namespace {

int changes(const std::vector<double>& shares, double at_first) {
  int count = 0;
  double last = at_first;
  for (const double share : shares) {
    count += share != last ? 1 : 0;
    last = share;
  }
  return count;
}

}  // namespace

TEST_CASE("the fan is faster where a way wants it") {
  const std::vector<double> shares =
      core::fan_plan(0.3, {{100, 0}, {20, 0.8}, {100, 0.2}, {30, 1}, {100, 0}});
  CHECK_EQ(shares, std::vector<double>{0.3, 0.8, 0.3, 1, 0.3});
  CHECK(core::fan_plan(0.3, {}).empty());
}

TEST_CASE("near runs are one, short ones get nothing, a slower wish changes nothing") {
  CHECK_EQ(core::fan_plan(0.3, {{100, 0}, {20, 0.8}, {10, 0}, {30, 1}, {100, 0}}),
           std::vector<double>{0.3, 1, 1, 1, 0.3});
  CHECK_EQ(core::fan_plan(0.3, {{100, 0}, {2, 0.8}, {100, 0}}), std::vector<double>{0.3, 0.3, 0.3});
  CHECK_EQ(core::fan_plan(0.9, {{100, 0}, {20, 0.8}, {100, 0}}),
           std::vector<double>{0.9, 0.9, 0.9});
}

TEST_CASE("a layer has a limited number of changes, and no long wish is left out") {
  for (const unsigned seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    test::Random random(seed);
    std::vector<FanWish> ways;
    for (int i = 0; i < 2'000; ++i) {
      ways.push_back({random.between(1, 60), random.integer(0, 1) == 0 ? 0 : random.unit()});
    }
    const std::vector<double> shares = core::fan_plan(0.2, ways);
    REQUIRE_EQ(shares.size(), ways.size());
    CHECK_LE(changes(shares, 0.2), 2 * static_cast<int>(core::kFanRunsMax));
    for (std::size_t i = 0; i < ways.size(); ++i) {
      CHECK_GE(shares[i], 0.2);
      if (ways[i].length_mm >= core::kFanRunMin_mm) CHECK_GE(shares[i], ways[i].share);
    }
  }
}
