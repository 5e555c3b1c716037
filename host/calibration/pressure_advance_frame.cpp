// rind test pressure-advance: a frame of two roads with sharp corners, and a scale at its back.
//
//     ┌──▄▄▄──┐   the scale: a groove where a block begins, its value behind
//     │       │
//     └───────┘   the corners to look at
#include <fmt/format.h>

#include <algorithm>

#include "host/calibration/calibration_parts.h"
#include "host/calibration/value_range.h"

namespace host {
namespace {

constexpr double kBlock_mm = 5;
constexpr double kSide_mm = 60;
constexpr double kScaleDepth_mm = 4;
constexpr double kSpeedLeast_mm_s = 80;  // slower, corners look well with any value
// Filament that is pushed through a tube gives way about ten times as much.
constexpr double kTubeRetraction_mm = 2.5;

std::string advice_on_firmware(const PrintSettings& settings) {
  switch (settings.gcode_flavor) {
    case core::GcodeFlavor::kKlipper:
      return "Klipper is told by SET_PRESSURE_ADVANCE; its own value is pressure_advance in "
             "[extruder].";
    case core::GcodeFlavor::kRepRapFirmware:
      return "RepRapFirmware is told by M572; its own value is in config.g.";
    case core::GcodeFlavor::kMarlin:
      break;
  }
  return "Marlin is told by M900 K. It answers an unknown command, and all blocks are alike, where "
         "it was built without linear advance.";
}

}  // namespace

core::Result<Calibration> pressure_advance_frame(const CalibrationRequest& request,
                                                 const PrintSettings& settings) {
  const ValueLimits limits{
      "a pressure advance", "s", 0, 2, "printers with the longest tubes need about 1", 4};
  const bool tube = settings.retraction_mm > kTubeRetraction_mm;
  const ValueRange range{0, tube ? 1.0 : 0.1, tube ? 0.1 : 0.01};
  const core::Result<std::vector<double>> values = values_of(request, range, limits);
  if (!values.ok()) return values.error();
  const std::vector<CalibrationBlock> blocks = blocks_of(settings, values.value(), kBlock_mm);
  Calibration calibration;
  TestSolid& solid = calibration.solid;
  const double wall = 2 * settings.road_width.mm();
  const double top = blocks.back().top.mm();
  solid.box({0, kSide_mm}, {0, wall}, {0, top});
  solid.box({0, kSide_mm}, {kSide_mm - wall, kSide_mm}, {0, top});
  solid.box({0, wall}, {0, kSide_mm}, {0, top});
  solid.box({kSide_mm - wall, kSide_mm}, {0, kSide_mm}, {0, top});
  const LabelForm form = label_form(settings, kBlock_mm);
  const double wide = widest_label(values.value(), form) + 3;
  const Span x{(kSide_mm - wide) / 2, (kSide_mm + wide) / 2};
  const Span y{kSide_mm - wall / 2, kSide_mm + kScaleDepth_mm};
  solid.box(x, y, {0, blocks.front().bottom.mm()});
  add_notched_column(settings, blocks, x, y, solid);
  add_labels(settings, blocks, {kSide_mm / 2, y.to}, LabelSide::kBack, form, solid);
  vary("pressure_advance_s", "s", blocks, settings, calibration);
  const double speed = std::max(
      {kSpeedLeast_mm_s, settings.perimeter_speed_mm_s, settings.outer_perimeter_speed_mm_s});
  for (const char* key : {"perimeter_speed_mm_s", "outer_perimeter_speed_mm_s"}) {
    calibration.settings.emplace_back(key, fmt::format("{:g}", speed));
  }
  calibration.settings.emplace_back("small_perimeter_speed_mm_s", "off");
  calibration.settings.emplace_back("cool_short_layers", "0");
  calibration.settings.emplace_back("seam", "rear");
  calibration.what = "a frame of two roads, with a scale at its back";
  calibration.advice = {
      "The two corners at the front, and the roads beside them. Corners that bulge: too low a "
      "value. "
      "Corners that are rounded or have gaps, roads that are thin before or behind them: too high.",
      "The best block has the sharpest corners and even roads: set pressure_advance_s to the "
      "number "
      "at its back. " +
          advice_on_firmware(settings),
  };
  if (settings.pressure_advance_s < 0) {
    calibration.advice.emplace_back(
        "The printer keeps the last block's value after the print, until it is told another one or "
        "is switched off: no setting says what it had before (pressure_advance_s).");
  }
  return calibration;
}

}  // namespace host
