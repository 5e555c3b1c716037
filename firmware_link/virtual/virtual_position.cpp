#include "firmware_link/virtual/virtual_position.h"

#include <algorithm>
#include <cmath>

#include "firmware_link/wire/line_codec.h"  // word

namespace firmware_link {
namespace {

constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};

}  // namespace

VirtualTravel travel_of(const VirtualControllerOptions& options) {
  const std::array<double, kAxes.size()> low_mm = {options.bed_origin_x_mm, options.bed_origin_y_mm,
                                                   0};
  const std::array<double, kAxes.size()> sides_mm = {options.bed_x_mm, options.bed_y_mm,
                                                     options.height_z_mm};
  VirtualTravel travel;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    travel.low_um[axis] = std::llround(low_mm[axis] * 1000);
    travel.high_um[axis] = travel.low_um[axis] + std::llround(sides_mm[axis] * 1000);
  }
  return travel;
}

VirtualPosition::Target VirtualPosition::target_of(std::string_view text,
                                                   const VirtualTravel& travel, bool clamps) {
  if (const auto feed = word(text, 'F', 0); feed && *feed > 0) feed_mm_min_ = *feed;
  Target target;
  target.um = um_;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto value = word(text, kAxes[axis], 3);
    if (!value) continue;
    const std::int64_t wanted = relative_ ? um_[axis] + *value : *value;
    target.um[axis] = wanted;
    if (!clamps || !homed_[axis]) continue;
    target.um[axis] = std::clamp(wanted, travel.low_um[axis], travel.high_um[axis]);
    target.clamped = target.clamped || target.um[axis] != wanted;
  }
  if (const auto value = word(text, 'E', 5)) {
    target.filament_10nm = relative_filament_ ? *value : *value - filament_10nm_;
  }
  return target;
}

void VirtualPosition::go(const Target& target) {
  um_ = target.um;
  filament_10nm_ += target.filament_10nm;
}

void VirtualPosition::set(std::string_view text) {
  const auto filament = word(text, 'E', 5);
  bool any = filament.has_value();
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if (const auto value = word(text, kAxes[axis], 3)) {
      um_[axis] = *value;
      any = true;
    }
  }
  if (filament) filament_10nm_ = *filament;
  if (any) return;
  um_ = {};
  filament_10nm_ = 0;
}

void VirtualPosition::home(std::size_t axis, std::int64_t um) {
  um_[axis] = um;
  homed_[axis] = true;
}

}  // namespace firmware_link
