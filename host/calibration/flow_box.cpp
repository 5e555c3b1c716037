// rind test flow: an open box whose walls are one road wide.
#include <fmt/format.h>

#include <numbers>

#include "core/roads/road.h"  // bead_area_mm2
#include "host/calibration/calibration_parts.h"

namespace host {
namespace {

constexpr double kSide_mm = 40;
constexpr double kHeight_mm = 25;

}  // namespace

core::Result<Calibration> flow_box(const PrintSettings& settings) {
  Calibration calibration;
  calibration.solid.box({0, kSide_mm}, {0, kSide_mm}, {0, kHeight_mm});
  set_vase(calibration);
  const double width = settings.road_width.mm(), now = settings.extrusion_multiplier;
  // A bead has round sides: its area is its height times (width - round).
  const double round = settings.layer_height.mm() * (1 - std::numbers::pi / 4);
  calibration.what = "an open box with walls of one road";
  const auto factor = [&](double measured) { return now * (width - round) / (measured - round); };
  calibration.advice = {
      fmt::format("Measure the walls with a caliper, in the middle of each side and near the top, "
                  "and take the mean. They should be {:.2f} mm thick (road_width = {:g} mm).",
                  width, width),
      fmt::format("extrusion_multiplier = {:g} x ({:.3f} - {:.3f}) / (measured - {:.3f}): {:.3f} "
                  "where {:.2f} mm are measured, {:.3f} for {:.2f} mm. Print the test again with "
                  "it. Measure the filament first: filament_diameter is {:g} mm.",
                  now, width, round, round, factor(width - 0.04), width - 0.04,
                  factor(width + 0.04), width + 0.04, settings.filament_diameter.mm()),
  };
  return calibration;
}

}  // namespace host
