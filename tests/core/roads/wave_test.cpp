#include "core/roads/wave.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace {

using core::Sign;
using core::Vector;
using core::Wave;

Vector direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST_CASE("the sign between two directions is that of all directions between") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1), angle(-M_PI, M_PI), part(0.01, M_PI - 0.01);
  int told = 0;
  for (int round = 0; round < 20'000; ++round) {
    const Wave wave{any(random), {any(random), any(random)}};
    const double from = angle(random), reach = part(random);
    const Sign sign = wave.sign_between(direction(from), direction(from + reach));
    bool below = false, above = false;
    for (int i = 0; i <= 64; ++i) {
      const double there = wave.at(direction(from + reach * i / 64));
      below = below || there < 0;
      above = above || there >= 0;
    }
    if (sign == Sign::kBelow) CHECK(!above);
    if (sign == Sign::kAbove) CHECK(!below);
    if (sign == Sign::kBoth) continue;
    ++told;
  }
  CHECK(told > 10'000);
}

TEST_CASE("a wave that turns between is told to be of both signs") {
  const Vector from = direction(-0.5), to = direction(0.5);
  CHECK(Wave{-0.95, {1, 0}}.sign_between(from, to) == Sign::kBoth);  // above 0 in the middle alone
  CHECK(Wave{0.95, {-1, 0}}.sign_between(from, to) == Sign::kBoth);
  CHECK(Wave{-2, {1, 0}}.at(direction(0)) == -1);
  CHECK(Wave{0.5, {1, 0}}.sign_between(from, to) == Sign::kAbove);
  CHECK(Wave{-0.5, {-1, 0}}.sign_between(from, to) == Sign::kBelow);
}

}  // namespace
