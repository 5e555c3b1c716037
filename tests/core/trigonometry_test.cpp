// Against the C library's long double functions, over the ranges that the header gives.
#include "core/trigonometry.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace {

constexpr unsigned kSeed = 20261127;
constexpr double kUnit = 0x1.0p-52;  // the last place of 1

double relative_error(double value, long double exact) {
  if (exact == 0) return std::abs(value);
  return static_cast<double>(std::abs((value - exact) / exact));
}

}  // namespace

TEST_CASE("sine and cosine are within one unit of the last place of 1") {
  std::mt19937_64 random(kSeed);
  INFO("seed ", kSeed);
  double worst = 0;
  const auto look = [&](double angle) {
    const long double exact = angle;
    worst = std::max(worst, static_cast<double>(std::abs(core::sine(angle) - std::sin(exact))));
    worst = std::max(worst, static_cast<double>(std::abs(core::cosine(angle) - std::cos(exact))));
  };
  std::uniform_real_distribution<double> turn(-7, 7), far(-1000, 1000);
  for (int i = 0; i < 100'000; ++i) {
    look(turn(random));
    look(far(random));
  }
  for (int eighth = -2'500; eighth <= 2'500; ++eighth) look(eighth * std::numbers::pi / 8);
  MESSAGE("worst error: ", worst / kUnit, " units");
  CHECK_LE(worst, kUnit);
}

TEST_CASE("right angles") {
  CHECK_EQ(core::sine(0), 0);
  CHECK_EQ(core::cosine(0), 1);
  CHECK_EQ(core::sine(std::numbers::pi / 2), 1);
  CHECK_EQ(core::cosine(std::numbers::pi), -1);
  CHECK_EQ(core::sine(-std::numbers::pi / 2), -1);
  CHECK_EQ(core::arc_tangent(0, 5), 0);
  CHECK_EQ(core::arc_tangent(5, 0), std::numbers::pi / 2);
  CHECK_EQ(core::arc_tangent(-5, 0), -std::numbers::pi / 2);
  CHECK_EQ(core::arc_tangent(0, -5), std::numbers::pi);
  CHECK_EQ(core::arc_tangent(3, 3), std::numbers::pi / 4);
  CHECK_EQ(core::arc_tangent(0, 0), 0);
  CHECK_EQ(core::arc_cosine(1), 0);
  CHECK_EQ(core::arc_cosine(0), std::numbers::pi / 2);
  CHECK_EQ(core::arc_cosine(-1), std::numbers::pi);
  CHECK_EQ(core::arc_cosine(1 + kUnit), 0);
  CHECK_EQ(core::hypotenuse(3, -4), 5);
  CHECK_EQ(core::hypotenuse(2, 3, -6), 7);
}

TEST_CASE("inverses are within two units of their own last place") {
  std::mt19937_64 random(kSeed);
  INFO("seed ", kSeed);
  double worst = 0;
  std::uniform_real_distribution<double> size(-12, 12), cosine(-1, 1);
  for (int i = 0; i < 100'000; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    const double y = sign * std::pow(10, size(random)), x = cosine(random);
    worst = std::max(
        worst, relative_error(core::arc_tangent(y, x), std::atan2(static_cast<long double>(y),
                                                                  static_cast<long double>(x))));
    worst = std::max(worst,
                     relative_error(core::arc_cosine(x), std::acos(static_cast<long double>(x))));
    worst = std::max(
        worst, relative_error(core::hypotenuse(x, y), std::hypot(static_cast<long double>(x),
                                                                 static_cast<long double>(y))));
  }
  MESSAGE("worst error: ", worst / kUnit, " units");
  CHECK_LE(worst, 2 * kUnit);
}
