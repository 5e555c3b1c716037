// rind test temperature-tower. A block, seen from the front:
//
//     ╲    ┌─────┐▀▀▀▀▀▀▀▀▀┌────┐     ╱      a bridge of 20 mm; overhangs of 45° and 60° from the
//       ╲  │ 210 │         │    │  ╱         vertical; a label; a groove where the block begins
//         ╲└┬───┬┘         └┬──┬┘╱
#include <fmt/format.h>

#include <algorithm>

#include "host/calibration/calibration_parts.h"
#include "host/calibration/value_range.h"

namespace host {
namespace {

constexpr double kBlock_mm = 10;
constexpr double kDepth_mm = 10;
constexpr double kSpan_mm = 20;
constexpr double kReach_mm = 6;  // of the overhangs
constexpr double kRight_mm = 10;
constexpr double kOverlap_mm = 0.4;

// Grows outwards to the left of x, which is the column's side.
void add_left_overhang(double x, double bottom, double rise, TestSolid& solid) {
  solid.across({{x + kOverlap_mm, bottom - kOverlap_mm},
                {x + kOverlap_mm, bottom + rise + 1},
                {x - kReach_mm, bottom + rise + 1},
                {x - kReach_mm, bottom + rise}},
               {0, kDepth_mm});
}

void add_right_overhang(double x, double bottom, double rise, TestSolid& solid) {
  solid.across({{x + kReach_mm, bottom + rise},
                {x + kReach_mm, bottom + rise + 1},
                {x - kOverlap_mm, bottom + rise + 1},
                {x - kOverlap_mm, bottom - kOverlap_mm}},
               {0, kDepth_mm});
}

}  // namespace

core::Result<Calibration> temperature_tower(const CalibrationRequest& request,
                                            const PrintSettings& settings) {
  const double usual = settings.nozzle_celsius;
  const ValueLimits limits{"a temperature of the nozzle",
                           "°C",
                           150,
                           350,
                           "below, printers refuse to extrude; above, few nozzles last",
                           1};
  const ValueRange range{std::clamp(usual + 15, limits.least, limits.most),
                         std::clamp(usual - 20, limits.least, limits.most), 5};
  const core::Result<std::vector<double>> values = values_of(request, range, limits);
  if (!values.ok()) return values.error();
  const std::vector<CalibrationBlock> blocks = blocks_of(settings, values.value(), kBlock_mm);
  Calibration calibration;
  TestSolid& solid = calibration.solid;
  const LabelForm form = label_form(settings, kBlock_mm);
  const double wide = widest_label(values.value(), form) + 3;
  const double left = kReach_mm + 1, inner = left + wide, right = inner + kSpan_mm;
  const double end = right + kRight_mm;
  solid.box({0, end + kReach_mm + 1}, {-2, kDepth_mm + 2}, {0, blocks.front().bottom.mm()});
  add_notched_column(settings, blocks, {left, inner}, {0, kDepth_mm}, solid);
  add_notched_column(settings, blocks, {right, end}, {0, kDepth_mm}, solid);
  const double deck = in_layers(settings, 2), below_top = in_layers(settings, 1);
  for (const CalibrationBlock& block : blocks) {
    const double bottom = block.bottom.mm(), top = block.top.mm();
    add_left_overhang(left, bottom + 1.5, kReach_mm, solid);        // 45°
    add_right_overhang(end, bottom + 3, kReach_mm / 1.732, solid);  // 60°
    solid.box({inner - 1, right + 1}, {1, kDepth_mm - 1},
              {top - deck - below_top, top - below_top});
  }
  add_labels(settings, blocks, {left + wide / 2, 0}, LabelSide::kFront, form, solid);
  vary("nozzle_celsius", "°C", blocks, settings, calibration);
  calibration.what = "pillars with a bridge and two overhangs in each block";
  calibration.advice = {
      "Too hot: bridges sag, overhangs curl up, threads between the pillars. Too cold: dull roads "
      "with gaps between them; blocks that break when the tower is bent.",
      "The best block is the coolest one that does not break, with clean bridges and digits: set "
      "nozzle_celsius to its number, and nozzle_first_layer_celsius to 5 more.",
  };
  return calibration;
}

}  // namespace host
