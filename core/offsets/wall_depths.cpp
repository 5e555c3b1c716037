#include "core/offsets/wall_depths.h"

#include <cmath>

#include "core/check.h"  // RIND_CHECK

namespace core {

Length doubled_middle(const Slice& slice) { return slice.bottom * 2 + slice.height; }

Length doubled_distance(const Slice& from, const Slice& to) {
  if (to.index == from.index) return {};
  return to.index > from.index ? to.bottom * 2 - doubled_middle(from)
                               : doubled_middle(from) - to.top() * 2;
}

Length ball_depth(Length wall_thickness, Length doubled_distance) {
  RIND_CHECK(doubled_distance >= Length() && doubled_distance <= wall_thickness * 2);
  const auto w = static_cast<double>(wall_thickness.units());
  const double z = static_cast<double>(doubled_distance.units()) / 2;
  return Length::from_units(std::llround(std::sqrt((w - z) * (w + z))));
}

std::vector<Length> wall_depths(const Settings& settings, Length layer_height) {
  // The fast style asks only whether a layer is hidden: the slices themselves are compared.
  if (settings.style == BuildStyle::kFast) return {Length()};
  std::vector<Length> depths{settings.wall_thickness};
  if (wall_counts_layers(settings)) return depths;
  const Length doubled_thickness = settings.wall_thickness * 2;
  for (Length z = layer_height; z < doubled_thickness; z += layer_height * 2) {
    depths.push_back(ball_depth(settings.wall_thickness, z));
  }
  return depths;
}

}  // namespace core
