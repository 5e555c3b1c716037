#include "host/printing/machine_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace host {
namespace {

using core::Length;
using firmware_link::TravelLimits;

// Limits are told in hundredths of a millimetre.
constexpr double kRounding_mm = 0.011;

Length shorter(Length length, double max_mm) {
  return Length::from_mm(std::min(length.mm(), std::max(max_mm, 0.0)));
}

bool lies_within(double low_mm, double high_mm, const TravelLimits& limits, std::size_t axis) {
  return low_mm >= limits.min_mm[axis] - kRounding_mm &&
         high_mm <= limits.max_mm[axis] + kRounding_mm;
}

double mm(std::int32_t units) { return Length::from_units(units).mm(); }

}  // namespace

MachineSpace space_of(const core::Settings& settings) {
  return {settings.bed_x, settings.bed_y, settings.axis_z, false, settings.bed_shape};
}

core::Settings with_space(core::Settings settings, const MachineSpace& space) {
  settings.bed_x = space.bed_x;
  settings.bed_y = space.bed_y;
  settings.axis_z = space.axis_z;
  settings.bed_shape = space.bed_shape;
  return settings;
}

TravelLimits from_bed(TravelLimits limits, const core::Settings& settings) {
  const double origin_mm[] = {settings.bed_origin_x.mm(), settings.bed_origin_y.mm()};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    limits.min_mm[axis] -= origin_mm[axis];
    limits.max_mm[axis] -= origin_mm[axis];
  }
  return limits;
}

core::Box on_machine(const core::Box& part, const core::Settings& settings) {
  if (part.empty()) return part;
  const auto moved = [&settings](core::Point at) {
    return core::Point{static_cast<std::int32_t>(at.x + settings.bed_origin_x.units()),
                       static_cast<std::int32_t>(at.y + settings.bed_origin_y.units())};
  };
  return {moved(part.min), moved(part.max)};
}

MachineSpace within(MachineSpace space, const TravelLimits& limits) {
  space.bed_x = shorter(space.bed_x, limits.max_mm[0]);
  space.bed_y = shorter(space.bed_y, limits.max_mm[1]);
  // A virtual machine's axis may be longer than a height can be.
  constexpr double kAxis_mm = 1e7;
  if (limits.max_mm[2] < kAxis_mm) {
    space.axis_z = space.axis_z > Length() ? shorter(space.axis_z, limits.max_mm[2])
                                           : Length::from_mm(limits.max_mm[2]);
  }
  return space;
}

std::string space_note(const MachineSpace& space, const std::optional<TravelLimits>& limits) {
  if (!limits) {
    if (!space.guessed) return {};
    return fmt::format(
        "the bed's size was not given, and the controller does not tell it: it is taken to be "
        "{:g} × {:g} mm. A pause or a resumed print drives to its corner: give the printer's own "
        "by --set bed_x=… --set bed_y=…",
        space.bed_x.mm(), space.bed_y.mm());
  }
  const bool larger = space.bed_x.mm() > limits->max_mm[0] + kRounding_mm ||
                      space.bed_y.mm() > limits->max_mm[1] + kRounding_mm;
  if (!larger) return {};
  return fmt::format(
      "the bed is {} {:g} × {:g} mm, but the controller's axes end at X {:g}, Y {:g} mm: parking "
      "and resuming stay within that. For a part in the bed's middle give the printer's own by "
      "--set bed_x=… --set bed_y=…",
      space.guessed ? "taken to be" : "set to", space.bed_x.mm(), space.bed_y.mm(),
      limits->max_mm[0], limits->max_mm[1]);
}

core::Status check_travel(const core::Box& part, Length height, const TravelLimits& limits) {
  if (part.empty()) return {};
  const double left = mm(part.min.x), right = mm(part.max.x);
  const double front = mm(part.min.y), back = mm(part.max.y);
  if (!lies_within(left, right, limits, 0) || !lies_within(front, back, limits, 1)) {
    return core::Error{
        core::ErrorCode::kOutOfBounds,
        fmt::format("the part would lie at X {:g} … {:g}, Y {:g} … {:g} mm, but the controller's "
                    "axes go from X {:g} to {:g} and from Y {:g} to {:g} mm; set bed_x and bed_y "
                    "to the printer's bed, or move or scale the part",
                    left, right, front, back, limits.min_mm[0], limits.max_mm[0], limits.min_mm[1],
                    limits.max_mm[1])};
  }
  if (height.mm() <= limits.max_mm[2] + kRounding_mm) return {};
  return core::Error{core::ErrorCode::kOutOfBounds,
                     fmt::format("the part is {:g} mm high, but the controller's Z ends at {:g} "
                                 "mm; scale the part",
                                 height.mm(), limits.max_mm[2])};
}

bool within_travel(const firmware_link::Move& move, const TravelLimits& limits) {
  const auto inside = [&limits](const std::optional<std::int64_t>& to_um, std::size_t axis) {
    const double to_mm = static_cast<double>(to_um.value_or(0)) / 1'000;
    return !to_um || lies_within(to_mm, to_mm, limits, axis);
  };
  return inside(move.x_um, 0) && inside(move.y_um, 1) && inside(move.z_um, 2);
}

}  // namespace host
