#include "host/gcode/model_changes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "host/gcode/gcode_numbers.h"

namespace host {
namespace {

using core::AxisLimits;
using core::MotionModel;
using firmware_link::Flavor;

constexpr std::string_view kAxes = "XYZE";
constexpr double kLeast_mm_s2 = 1;

std::optional<double> number(const GcodeNumbers& numbers, char letter) {
  const std::optional<std::int64_t> fixed = numbers.fixed(letter);
  if (!fixed) return std::nullopt;
  return static_cast<double>(*fixed) * 1e-5;
}

// `scale`: of what is told.
void put_axes(const GcodeNumbers& numbers, double scale, AxisLimits& limits) {
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const std::optional<double> told = number(numbers, kAxes[axis]);
    if (told && *told > 0) limits[axis] = *told * scale;
  }
}

void put_acceleration(std::optional<double> told, double& into) {
  if (told && *told > 0) into = std::max(*told, kLeast_mm_s2);
}

void put_accelerations(const GcodeNumbers& numbers, Flavor flavor, MotionModel& model) {
  if (flavor == Flavor::kKlipper) {
    // P and T: the smaller of both, for all moves.
    std::optional<double> all = number(numbers, 'S');
    const std::optional<double> print = number(numbers, 'P'), travel = number(numbers, 'T');
    if (!all && print && travel) all = std::min(*print, *travel);
    put_acceleration(all, model.acceleration_mm_s2);
    return;
  }
  if (const std::optional<double> all = number(numbers, 'S'); all && *all > 0) {
    put_acceleration(all, model.acceleration_mm_s2);
    model.travel_acceleration_mm_s2 = 0;
  }
  const std::optional<double> travel = number(numbers, 'T');
  if (number(numbers, 'P') && !travel && model.travel_acceleration_mm_s2 == 0) {
    // Travel keeps what it had.
    model.travel_acceleration_mm_s2 = model.acceleration_mm_s2;
  }
  put_acceleration(number(numbers, 'P'), model.acceleration_mm_s2);
  put_acceleration(travel, model.travel_acceleration_mm_s2);
  put_acceleration(number(numbers, 'R'), model.filament_acceleration_mm_s2);
}

void put_corners(const GcodeNumbers& numbers, double scale, MotionModel& model) {
  if (const std::optional<double> deviation = number(numbers, 'J'); deviation && *deviation >= 0) {
    model.junction_deviation_mm = *deviation;
    model.jerk_mm_s = {};
    return;
  }
  put_axes(numbers, scale, model.jerk_mm_s);
}

// "ACCEL=3000" behind a blank.
std::optional<double> named(std::string_view parameters, std::string_view name) {
  const std::string word = " " + std::string(name) + "=";
  const std::size_t at = (" " + std::string(parameters)).find(word);
  if (at == std::string::npos) return std::nullopt;
  const std::string behind(parameters.substr(at + word.size() - 1));
  char* end = nullptr;
  const double value = std::strtod(behind.c_str(), &end);
  if (end == behind.c_str() || !std::isfinite(value)) return std::nullopt;
  return value;
}

void put_velocity_limit(std::string_view parameters, MotionModel& model) {
  put_acceleration(named(parameters, "ACCEL"), model.acceleration_mm_s2);
  if (const auto speed = named(parameters, "VELOCITY"); speed && *speed > 0) {
    model.speed_max_mm_s[0] = model.speed_max_mm_s[1] = *speed;
  }
  const auto corner = named(parameters, "SQUARE_CORNER_VELOCITY");
  if (corner && *corner >= 0) model.square_corner_mm_s = *corner;
}

}  // namespace

bool changes_model(std::string_view command, std::string_view parameters, Flavor flavor,
                   MotionModel& model) {
  const bool reprap = flavor == Flavor::kRepRapFirmware;
  const bool klipper = flavor == Flavor::kKlipper;
  if (command == "SET_VELOCITY_LIMIT") {
    put_velocity_limit(parameters, model);
    return true;
  }
  if (command == "M204") {
    put_accelerations(GcodeNumbers(parameters), flavor, model);
    return true;
  }
  if (klipper) return false;  // it has none of the others
  if (command == "M201") {
    put_axes(GcodeNumbers(parameters), 1, model.acceleration_max_mm_s2);
  } else if (command == "M203") {
    put_axes(GcodeNumbers(parameters), reprap ? 1.0 / 60 : 1, model.speed_max_mm_s);
  } else if (command == (reprap ? "M566" : "M205")) {
    put_corners(GcodeNumbers(parameters), reprap ? 1.0 / 60 : 1, model);
  } else {
    return false;
  }
  return true;
}

}  // namespace host
