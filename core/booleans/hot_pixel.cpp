#include "core/booleans/hot_pixel.h"

#include <cmath>

#include "core/wide_product.h"

namespace core {
namespace {

// ⌊start + step · part / whole + ½⌋. REQUIRES: 0 < part < whole
std::int32_t round_between(std::int32_t start, std::int64_t step, std::int64_t part,
                           std::int64_t whole) {
  // Wrong by less than 2^-20 units; only next to a rounding boundary is that not good enough.
  const double guess =
      static_cast<double>(step) * (static_cast<double>(part) / static_cast<double>(whole)) + 0.5;
  const double floor = std::floor(guess);
  constexpr double kUnsure = 0x1.0p-16;
  if (guess - floor > kUnsure && guess - floor < 1 - kUnsure) {
    return static_cast<std::int32_t>(start + static_cast<std::int64_t>(floor));
  }
  return static_cast<std::int32_t>(start + rounded_share(step, part, whole));
}

}  // namespace

Point crossing_pixel(Point a, Point b, Point c, Point d) {
  std::int64_t part = cross(c, d, a);
  std::int64_t whole = part - cross(c, d, b);
  if (whole < 0) {
    part = -part;
    whole = -whole;
  }
  return {round_between(a.x, std::int64_t{b.x} - a.x, part, whole),
          round_between(a.y, std::int64_t{b.y} - a.y, part, whole)};
}

}  // namespace core
