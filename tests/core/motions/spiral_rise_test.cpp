#include "core/motions/spiral_rise.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/random_regions.h"

using core::Length;
using core::SpiralRise;
using core::SpiralTurn;

namespace {

struct Round {
  double material = 0;  // flow over the way
  double worst = 0;     // of a step's flow, against the gap in its middle
  Length end;
};

// Goes once round in pieces; `gap(share)`: under the nozzle there, as a share of a layer.
template <typename Gap>
Round go_round(SpiralRise& rise, const std::vector<double>& pieces, double total, const Gap& gap) {
  Round round;
  double done = 0;
  for (const double mm : pieces) {
    double before = 0;
    for (const SpiralRise::Step& step : rise.advance(mm)) {
      const double middle = (done + mm * (before + step.share) / 2) / total;
      round.material += step.flow * mm * (step.share - before);
      round.worst = std::max(round.worst, std::abs(step.flow - gap(middle)));
      CHECK_GE(step.z, round.end);
      round.end = step.z;
      before = step.share;
    }
    CHECK_EQ(before, 1);
    done += mm;
  }
  return round;
}

}  // namespace

TEST_CASE("what is laid fills the gap between the nozzle and the turn below") {
  constexpr std::uint64_t kSeed = 20261128;
  CAPTURE(kSeed);
  test::Random random(kSeed);
  const Length bottom = Length::from_mm(3), height = Length::from_mm(0.2);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    std::vector<double> pieces;
    double total = 0;
    for (std::int64_t i = random.integer(3, 40); i > 0; --i) {
      pieces.push_back(static_cast<double>(random.integer(1, 1'000)) / 50);
      total += pieces.back();
    }
    // 0: on a flat layer.
    const Length below = Length::from_units(random.integer(0, 3) * 1'000);
    const SpiralTurn turn{below, random.integer(0, 1) == 1};
    SpiralRise rise(turn, bottom, height, total);
    // From the turn below, which rises by its own height, to the nozzle.
    const auto gap = [&](double share) {
      const double surface = bottom.mm() - below.mm() * (1 - share);
      return (bottom.mm() + share * height.mm() - surface) / height.mm();
    };
    const Round up = go_round(rise, pieces, total, gap);
    CHECK_EQ(up.end, bottom + height);
    CHECK(up.worst < 1e-9);
    CHECK(up.material == doctest::Approx(total * (1 + below.mm() / height.mm()) / 2));
    if (!turn.last) continue;
    rise.begin_top_round();
    const Round top = go_round(rise, pieces, total, [](double share) { return 1 - share; });
    CHECK_EQ(top.end, bottom + height);
    CHECK(top.worst < 1e-9);
    CHECK(top.material == doctest::Approx(total / 2));
  }
}
