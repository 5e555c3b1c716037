#include "core/motions/motion_model.h"

namespace core {
namespace {

// Klipper's own, where printer.cfg says nothing.
constexpr double kKlipperSquareCorner_mm_s = 5;

}  // namespace

MotionModel motion_model(const Settings& settings) {
  MotionModel model{.acceleration_mm_s2 = settings.acceleration_mm_s2,
                    .filament_acceleration_mm_s2 = settings.filament_acceleration_mm_s2};
  model.speed_max_mm_s = {settings.speed_max_xy_mm_s, settings.speed_max_xy_mm_s,
                          settings.speed_max_z_mm_s, settings.speed_max_filament_mm_s};
  model.acceleration_max_mm_s2 = {
      settings.acceleration_max_xy_mm_s2, settings.acceleration_max_xy_mm_s2,
      settings.acceleration_max_z_mm_s2, settings.acceleration_max_filament_mm_s2};
  // Klipper has no jerk, whatever other slicers' profiles say of it.
  if (settings.gcode_flavor == GcodeFlavor::kKlipper) {
    const double square_mm_s = settings.square_corner_speed_mm_s;
    model.square_corner_mm_s = square_mm_s > 0 ? square_mm_s : kKlipperSquareCorner_mm_s;
  } else {
    model.jerk_mm_s = {settings.jerk_xy_mm_s, settings.jerk_xy_mm_s, settings.jerk_z_mm_s,
                       settings.jerk_filament_mm_s};
    model.square_corner_mm_s = settings.square_corner_speed_mm_s;
  }
  model.junction_deviation_mm = settings.junction_deviation_mm;
  return model;
}

}  // namespace core
