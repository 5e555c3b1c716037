#include "host/printing/virtual_machine.h"

#include "core/motions/motion_model.h"  // motion_model

namespace host {
namespace {

firmware_link::VirtualDialect dialect_of(core::GcodeFlavor flavor) {
  switch (flavor) {
    case core::GcodeFlavor::kKlipper:
      return firmware_link::VirtualDialect::kKlipper;
    case core::GcodeFlavor::kRepRapFirmware:
      return firmware_link::VirtualDialect::kRepRap;
    case core::GcodeFlavor::kMarlin:
      break;
  }
  return firmware_link::VirtualDialect::kMarlin;
}

}  // namespace

firmware_link::VirtualControllerOptions virtual_machine(const core::Settings& settings) {
  firmware_link::VirtualControllerOptions machine;
  machine.dialect = dialect_of(settings.gcode_flavor);
  machine.bed_x_mm = settings.bed_x.mm();
  machine.bed_y_mm = settings.bed_y.mm();
  machine.bed_origin_x_mm = settings.bed_origin_x.mm();
  machine.bed_origin_y_mm = settings.bed_origin_y.mm();
  const core::MotionModel model = core::motion_model(settings);
  firmware_link::VirtualLimits& limits = machine.limits;
  limits.acceleration_mm_s2 = model.acceleration_mm_s2;
  limits.travel_acceleration_mm_s2 = model.travel_acceleration_mm_s2;
  limits.filament_acceleration_mm_s2 = model.filament_acceleration_mm_s2;
  limits.speed_max_mm_s = model.speed_max_mm_s;
  limits.acceleration_max_mm_s2 = model.acceleration_max_mm_s2;
  limits.corners = {model.jerk_mm_s, model.square_corner_mm_s, model.junction_deviation_mm};
  return machine;
}

}  // namespace host
