#include "core/trigonometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/check.h"

namespace core {
namespace {

// π / 2 as a number of 33 bits and what is missing to it: a multiple below 2^20 of the first is
// exact, so that taking it off an angle loses nothing.
constexpr double kQuarterHead = 0x1.921fb544p+0;
constexpr double kQuarterTail = 0x1.0b4611a626331p-34;

// The series of the sine about 0, without the first term. REQUIRES: |x| <= π/4.
double short_sine(double x) {
  constexpr std::array<double, 8> kTerms{
      -1.0 / 6,           1.0 / 120,         -1.0 / 5'040,          1.0 / 362'880,
      -1.0 / 39'916'800., 1.0 / 6227020800., -1.0 / 1307674368000., 1.0 / 355687428096000.};
  const double square = x * x;
  double sum = 0;
  for (auto term = kTerms.rbegin(); term != kTerms.rend(); ++term) sum = sum * square + *term;
  return x + x * square * sum;
}

// REQUIRES: |x| <= π/4.
double short_cosine(double x) {
  constexpr std::array<double, 8> kTerms{
      1.0 / 24,         -1.0 / 720,          1.0 / 40'320,          -1.0 / 3'628'800,
      1.0 / 479001600., -1.0 / 87178291200., 1.0 / 20922789888000., -1.0 / 6402373705728000.};
  const double square = x * x;
  double sum = 0;
  for (auto term = kTerms.rbegin(); term != kTerms.rend(); ++term) sum = sum * square + *term;
  return 1 - (square / 2 - square * square * sum);
}

struct Turned {
  double rest = 0;   // −π/4 … π/4
  int quarters = 0;  // turns of π/2, 0 … 3
};

Turned without_quarters(double angle) {
  RIND_CHECK(angle >= -1000 && angle <= 1000);
  const double count = std::floor(angle / (std::numbers::pi / 2) + 0.5);
  const double rest = (angle - count * kQuarterHead) - count * kQuarterTail;
  return {rest, static_cast<int>(count) & 3};
}

// The arc tangents of 0, 1/8 … 1: between two of them the series needs a sixteenth at most.
constexpr std::array<double, 9> kEighths{0x0p+0,
                                         0x1.fd5ba9aac2f6ep-4,
                                         0x1.f5b75f92c80ddp-3,
                                         0x1.6f61941e4def1p-2,
                                         0x1.dac670561bb4fp-2,
                                         0x1.1e00babdefeb4p-1,
                                         0x1.4978fa3269ee1p-1,
                                         0x1.700a7c5784634p-1,
                                         0x1.921fb54442d18p-1};

// The arc tangent of low / high. REQUIRES: 0 <= low <= high, high > 0.
double arc_tangent_of_slope(double low, double high) {
  const double slope = low / high;
  RIND_CHECK(slope >= 0 && slope <= 1);
  const double eighth = std::floor(slope * 8 + 0.5);
  const double start = eighth / 8;
  const double x = (low - start * high) / (high + start * low);
  constexpr std::array<double, 7> kTerms{-1.0 / 3,  1.0 / 5,  -1.0 / 7, 1.0 / 9,
                                         -1.0 / 11, 1.0 / 13, -1.0 / 15};
  const double square = x * x;
  double sum = 0;
  for (auto term = kTerms.rbegin(); term != kTerms.rend(); ++term) sum = sum * square + *term;
  return kEighths[static_cast<std::size_t>(eighth)] + (x + x * square * sum);
}

}  // namespace

double sine(double angle) {
  const Turned turned = without_quarters(angle);
  const double value =
      turned.quarters % 2 == 0 ? short_sine(turned.rest) : short_cosine(turned.rest);
  return turned.quarters < 2 ? value : -value;
}

double cosine(double angle) {
  const Turned turned = without_quarters(angle);
  const double value =
      turned.quarters % 2 == 0 ? short_cosine(turned.rest) : short_sine(turned.rest);
  return turned.quarters == 0 || turned.quarters == 3 ? value : -value;
}

double arc_tangent(double y, double x) {
  const double across = std::abs(y), along = std::abs(x);
  if (across == 0 && along == 0) return 0;
  double angle = across <= along ? arc_tangent_of_slope(across, along)
                                 : std::numbers::pi / 2 - arc_tangent_of_slope(along, across);
  if (x < 0) angle = std::numbers::pi - angle;
  return y < 0 ? -angle : angle;
}

double arc_cosine(double x) { return arc_tangent(std::sqrt(std::max(0.0, (1 - x) * (1 + x))), x); }

double hypotenuse(double x, double y) { return std::sqrt(x * x + y * y); }

double hypotenuse(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

}  // namespace core
