#include "core/roads/overhang_reach.h"

#include <algorithm>
#include <numbers>

#include "core/trigonometry.h"  // cosine, sine

namespace core {
namespace {

// Slopes as steep as the angle are not steeper: what rounding may add.
constexpr Length kAngleSlack = Length::from_units(100);

// Angles beyond this are taken to be this one: nothing is steeper than flat.
constexpr double kAngleMaxDegrees = 89;

}  // namespace

Length overhang_reach(Length planes, const Settings& settings) {
  const double degrees = std::min(settings.overhang_angle_degrees, kAngleMaxDegrees);
  const double angle = degrees * std::numbers::pi / 180;
  return Length::from_mm(planes.mm() * sine(angle) / cosine(angle)) + kAngleSlack;
}

}  // namespace core
