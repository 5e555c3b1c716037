#include "firmware_link/virtual/virtual_limits.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "firmware_link/wire/line_codec.h"  // word

namespace firmware_link {
namespace {

constexpr std::array<char, 4> kLetters = {'X', 'Y', 'Z', 'E'};

std::optional<double> value(std::string_view text, char letter) {
  const auto thousandths = word(text, letter, 3);
  if (!thousandths) return std::nullopt;
  return static_cast<double>(*thousandths) * 1e-3;
}

void set_axes(std::string_view text, double scale, VirtualAxes& axes) {
  for (std::size_t axis = 0; axis < kLetters.size(); ++axis) {
    if (const auto told = value(text, kLetters[axis]); told && *told > 0)
      axes[axis] = *told * scale;
  }
}

void set_if_told(const std::optional<double>& told, double& into) {
  if (told && *told > 0) into = *told;
}

// "ACCEL=3000": as a word of one letter behind a command, so that it is read as others are.
std::optional<double> named(std::string_view text, std::string_view name) {
  const std::size_t at = text.find(std::string(" ").append(name).append("="));
  if (at == std::string_view::npos) return std::nullopt;
  std::string one = " V";
  one += text.substr(at + name.size() + 2);
  return value(std::string_view(one).substr(0, one.find(' ', 1)), 'V');
}

// The largest value along the way that keeps every axis within its own.
double within(const VirtualAxes& axes, const VirtualAxes& share, double wanted) {
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const double part = std::abs(share[axis]);
    if (axes[axis] > 0 && wanted * part > axes[axis]) wanted = axes[axis] / part;
  }
  return wanted;
}

}  // namespace

void VirtualLimits::set_speeds(std::string_view text, bool minutes) {
  set_axes(text, minutes ? 1.0 / 60 : 1.0, speed_max_mm_s);
}

void VirtualLimits::set_accelerations_max(std::string_view text) {
  set_axes(text, 1, acceleration_max_mm_s2);
}

void VirtualLimits::set_accelerations(std::string_view text) {
  const auto all = value(text, 'S');
  if (travel_acceleration_mm_s2 == 0) travel_acceleration_mm_s2 = acceleration_mm_s2;
  set_if_told(all, acceleration_mm_s2);
  set_if_told(all, travel_acceleration_mm_s2);
  set_if_told(value(text, 'P'), acceleration_mm_s2);
  set_if_told(value(text, 'T'), travel_acceleration_mm_s2);
  set_if_told(value(text, 'R'), filament_acceleration_mm_s2);
}

void VirtualLimits::set_corners(std::string_view text, bool minutes) {
  if (const auto deviation = word(text, 'J', 5)) {
    corners.junction_deviation_mm = static_cast<double>(*deviation) * 1e-5;
    corners.jerk_mm_s = {};
    return;
  }
  set_axes(text, minutes ? 1.0 / 60 : 1.0, corners.jerk_mm_s);
}

void VirtualLimits::set_velocity_limit(std::string_view text) {
  set_if_told(named(text, "ACCEL"), acceleration_mm_s2);
  set_if_told(named(text, "ACCEL"), travel_acceleration_mm_s2);
  set_if_told(named(text, "VELOCITY"), speed_max_mm_s[0]);
  set_if_told(named(text, "VELOCITY"), speed_max_mm_s[1]);
  if (const auto corner = named(text, "SQUARE_CORNER_VELOCITY")) {
    corners.square_corner_mm_s = *corner;
  }
}

double VirtualLimits::speed_mm_s(const VirtualAxes& share, double wanted_mm_s) const {
  return within(speed_max_mm_s, share, wanted_mm_s);
}

double VirtualLimits::acceleration(const VirtualAxes& share) const {
  double wanted = acceleration_mm_s2;
  if (share[0] == 0 && share[1] == 0 && share[2] == 0) {
    wanted = filament_acceleration_mm_s2;
  } else if (share[3] == 0 && travel_acceleration_mm_s2 > 0) {
    wanted = travel_acceleration_mm_s2;
  }
  return within(acceleration_max_mm_s2, share, wanted);
}

}  // namespace firmware_link
