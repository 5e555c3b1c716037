// rind test max-flow: a loop of one thick road that rises without a seam and is laid faster and
// faster, so that more and more filament has to be molten.
//
//     ╭────────────────╮   long straight sides, on which the nozzle reaches its speed
//     █                │   every other block has a rib at its left end, so that they can be counted
//     ╰────────────────╯
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/roads/road.h"  // bead_area_mm2
#include "host/calibration/calibration_parts.h"
#include "host/calibration/value_range.h"

namespace host {
namespace {

constexpr double kBlock_mm = 4;
constexpr double kLengthMost_mm = 120;
constexpr double kLengthLeast_mm = 60;
constexpr double kRadius_mm = 12;
constexpr double kRib_mm = 0.5;
constexpr double kRibHalf_mm = 4;
constexpr int kArcPieces = 24;         // of each end
constexpr double kNoLimit_mm3_s = 15;  // the middle, where the settings have no limit
constexpr double kFastest_mm_s = 500;

std::vector<Place> stadium(double length) {
  std::vector<Place> outline;
  for (int end = 0; end < 2; ++end) {
    const double middle = end == 0 ? length - kRadius_mm : kRadius_mm;
    for (int i = 0; i <= kArcPieces; ++i) {
      const double angle = std::numbers::pi * (end - 0.5 + static_cast<double>(i) / kArcPieces);
      outline.push_back(
          {middle + kRadius_mm * std::cos(angle), kRadius_mm + kRadius_mm * std::sin(angle)});
    }
  }
  return outline;
}

// Whole numbers, or quarters for slow filaments.
double usual_step(double limit) { return limit >= 6 ? 1 : 0.25; }

}  // namespace

core::Result<Calibration> max_flow_loop(const CalibrationRequest& request,
                                        const PrintSettings& settings) {
  const ValueLimits limits{"a flow", "mm3/s", 0.25, 100, "no nozzle melts more", 2};
  const double limit = settings.volumetric_speed_max_mm3_s > 0 ? settings.volumetric_speed_max_mm3_s
                                                               : kNoLimit_mm3_s;
  const double step = usual_step(limit);
  const ValueRange range{std::max(step, std::round(limit / 2 / step) * step),
                         std::round(limit * 2 / step) * step, step};
  const core::Result<std::vector<double>> values = values_of(request, range, limits);
  if (!values.ok()) return values.error();
  PrintSettings own = settings;
  const double nozzle = settings.nozzle_diameter.mm();
  own.road_width = core::Length::from_mm(rounded_to(1.5 * nozzle, 2));
  own.layer_height = core::Length::from_mm(rounded_to(0.7 * nozzle, 2));
  const double area = core::bead_area_mm2(own.road_width, own.layer_height);
  const double most = *std::max_element(values.value().begin(), values.value().end());
  if (most / area / settings.extrusion_multiplier > kFastest_mm_s) {
    return core::Error{
        core::ErrorCode::kBadSetting,
        fmt::format("{:g} mm3/s would be {:.0f} mm/s with roads of {:g} by {:g} mm, "
                    "more than {:g}: a lower --to",
                    most, most / area, own.road_width.mm(), own.layer_height.mm(), kFastest_mm_s)};
  }
  const double room = std::min(settings.bed_x.mm(), settings.bed_y.mm()) * 0.8 - 2 * margin_mm(own);
  const double length = std::clamp(room, kLengthLeast_mm, kLengthMost_mm);
  const std::vector<CalibrationBlock> blocks = blocks_of(own, values.value(), kBlock_mm);
  Calibration calibration;
  calibration.solid.upright(stadium(length), {0, blocks.back().top.mm()});
  for (std::size_t i = 1; i < blocks.size(); i += 2) {
    calibration.solid.box({-kRib_mm, kRadius_mm / 2},
                          {kRadius_mm - kRibHalf_mm, kRadius_mm + kRibHalf_mm},
                          {blocks[i].bottom.mm(), blocks[i].top.mm()});
  }
  set_vase(calibration);
  vary("volumetric_speed_max_mm3_s", "mm3/s", blocks, settings, calibration);
  auto& fixed = calibration.settings;
  fixed.emplace_back("road_width", fmt::format("{:g}", own.road_width.mm()));
  fixed.emplace_back("layer_height", fmt::format("{:g}", own.layer_height.mm()));
  // As fast as the flow allows.
  for (const char* key : {"perimeter_speed_mm_s", "outer_perimeter_speed_mm_s"}) {
    fixed.emplace_back(key, fmt::format("{:g}", 2 * kFastest_mm_s));
  }
  fixed.emplace_back("small_perimeter_speed_mm_s", "off");
  fixed.emplace_back("cool_short_layers", "0");
  calibration.what = fmt::format(
      "a loop of one road, {:g} mm wide and {:g} mm high, laid at {:.0f} "
      "to {:.0f} mm/s",
      own.road_width.mm(), own.layer_height.mm(), values.value().front() / area,
      values.value().back() / area);
  calibration.advice = {
      fmt::format(
          "The height at which the wall gets thinner, rough, dull or has holes, or the "
          "extruder clicks, measured with a ruler from the bed, or by the ribs of every other "
          "block of {:g} mm. Only the "
          "straight sides count: the printer may not reach its speed at the ends.",
          (blocks.front().top - blocks.front().bottom).mm()),
      "Set volumetric_speed_max_mm3_s to 9/10 of the last good block's value: faster roads are "
      "slowed down to it. Stop the print once the wall has failed.",
  };
  return calibration;
}

}  // namespace host
