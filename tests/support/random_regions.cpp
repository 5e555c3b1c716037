#include "tests/support/random_regions.h"

#include <cmath>

#include "core/booleans/boolean.h"
#include "core/units.h"

namespace test {

using core::Region;
using core::Ring;

namespace {

std::int32_t units(double mm) { return static_cast<std::int32_t>(std::lround(mm * 10'000.0)); }

}  // namespace

Ring random_ring(Random& random, int points, double size_mm) {
  Ring ring;
  for (int i = 0; i < points; ++i) {
    const double x = random.between(-size_mm / 2, size_mm / 2);
    const double y = random.between(-size_mm / 2, size_mm / 2);
    ring.push_back({units(x), units(y)});
  }
  return ring;
}

Ring random_blob(Random& random, int points, double x_mm, double y_mm, double radius_mm,
                 double roughness) {
  Ring ring;
  const double waves = random.integer(2, 7), phase = random.between(0, 6.28);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * 3.14159265358979 * i / points;
    const double wave = 1 + 0.3 * std::sin(waves * angle + phase);
    const double radius = radius_mm * wave * (1 - roughness * random.unit());
    ring.push_back(
        {units(x_mm + radius * std::cos(angle)), units(y_mm + radius * std::sin(angle))});
  }
  return ring;
}

Region random_region(Random& random, int points, double size_mm) {
  Region region;
  const int blobs = random.integer(3, 6);
  for (int i = 0; i < blobs; ++i) {
    const double x = random.between(-size_mm / 3, size_mm / 3);
    const double y = random.between(-size_mm / 3, size_mm / 3);
    const double radius = random.between(size_mm / 20, size_mm / 4);
    const double roughness = i % 2 == 0 ? 0.05 : 0.6;
    const Ring blob = random_blob(random, std::max(3, points / blobs), x, y, radius, roughness);
    const Region piece = core::clean({blob}, core::FillRule::kNonZero);
    region = i % 3 == 2 ? core::subtract(region, piece) : core::unite(region, piece);
  }
  return region;
}

}  // namespace test
