// Against the formula in the header, taken literally over all bins.
#include "core/slices/height_ceiling.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using core::HeightCeiling;
using core::HeightLimits;
using core::Length;

namespace {

constexpr core::HeightBounds kBounds{Length::from_units(700), Length::from_units(3'000)};

HeightLimits random_limits(std::mt19937& random) {
  HeightLimits limits(Length::from_mm(0.05), kBounds);
  const auto below = [&](std::int64_t most) { return static_cast<std::int64_t>(random()) % most; };
  for (int i = 0; i < 6; ++i) {
    const std::int64_t low = below(60'000) - 20'000;
    limits.limit(low, low + 1 + below(8'000), Length::from_units(500 + below(2'600)));
  }
  for (std::int64_t times = below(6); times > 0; --times) limits.widen();
  return limits;
}

std::int64_t literal(const HeightLimits& limits, std::int64_t z) {
  std::int64_t least = limits.bounds().highest.units();
  for (std::int64_t bin = limits.first(); bin <= limits.last(); ++bin) {
    const std::int64_t low = bin * limits.bin_width(), high = low + limits.bin_width();
    const std::int64_t away = std::max({low - z, z - high, std::int64_t{0}});
    least = std::min(least, limits.at_bin(bin).units() + away / core::kCeilingRun);
  }
  return least;
}

}  // namespace

TEST_CASE("the ceiling is the least of all bins' limits with what the distance adds") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 40; ++i) {
    const HeightLimits limits = random_limits(random);
    const std::int64_t bed = -static_cast<std::int64_t>(random() % 5'000);
    const HeightCeiling ceiling(limits, bed);
    for (std::int64_t z = -40'000; z < 90'000; z += 1 + static_cast<std::int64_t>(random() % 99)) {
      // Eighths are rounded down bin by bin.
      REQUIRE(std::abs(ceiling.at(Length::from_units(z - bed)).units() - literal(limits, z)) <= 1);
    }
  }
}

TEST_CASE("the least between two heights, and how far it stays level, as found unit by unit") {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const HeightCeiling ceiling(random_limits(random), 0);
    const std::int64_t from = static_cast<std::int64_t>(random() % 100'000) - 40'000;
    const std::int64_t to = from + static_cast<std::int64_t>(random() % 3'000);
    const auto at = [&](std::int64_t z) { return ceiling.at(Length::from_units(z)); };
    Length least = at(from);
    for (std::int64_t z = from; z <= to; ++z) least = std::min(least, at(z));
    REQUIRE_EQ(ceiling.least(Length::from_units(from), Length::from_units(to)), least);
    const Length level = ceiling.level_until(Length::from_units(from));
    REQUIRE_GE(level, Length::from_units(from));
    const std::int64_t end = std::min(level.units(), from + 20'000);
    for (std::int64_t z = from; z < end; ++z) REQUIRE_EQ(at(z), at(from));
  }
}

TEST_CASE("without limits it is level without end") {
  const HeightCeiling ceiling(HeightLimits(Length::from_mm(0.05), kBounds), 0);
  CHECK_EQ(ceiling.at(Length::from_mm(1e6)), kBounds.highest);
  CHECK_GT(ceiling.level_until(Length()), Length::from_mm(1e9));
  CHECK_EQ(HeightCeiling(Length::from_mm(0.2)).at(Length::from_mm(3)), Length::from_mm(0.2));
}
