#include "core/offsets/capsule_offset.h"

#include <cmath>

#include "core/booleans/boolean.h"  // clean
#include "core/limits.h"            // kCapsuleToleranceUnits
#include "core/rounded.h"           // rounded
#include "core/trigonometry.h"      // arc_tangent, arc_cosine, cosine, sine

namespace core {
namespace {

// Counter-clockwise about the edge from a to b.
Ring capsule(Point a, Point b, double radius) {
  const double start =
      arc_tangent(static_cast<double>(b.y) - a.y, static_cast<double>(b.x) - a.x) - M_PI / 2;
  const double step = 2 * arc_cosine(std::max(0.0, 1 - kCapsuleToleranceUnits / radius));
  const int chords = std::max(2, static_cast<int>(std::ceil(M_PI / step)));
  Ring ring;
  for (const auto& [centre, from] : {std::pair{b, start}, std::pair{a, start + M_PI}}) {
    for (int i = 0; i <= chords; ++i) {
      const double angle = from + M_PI * i / chords;
      ring.push_back(
          {rounded(centre.x + radius * cosine(angle)), rounded(centre.y + radius * sine(angle))});
    }
  }
  return ring;
}

}  // namespace

Region capsule_offset(const Region& region, Length depth) {
  const double radius = std::abs(static_cast<double>(depth.units()));
  std::vector<Ring> capsules;
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      capsules.push_back(capsule(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], radius));
    }
  }
  const Region near = clean(capsules, FillRule::kPositive);
  return depth > Length() ? subtract(region, near) : unite(region, near);
}

}  // namespace core
