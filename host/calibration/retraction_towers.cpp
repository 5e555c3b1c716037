// rind test retraction: two towers, and travel between them in every layer.
#include <algorithm>

#include "host/calibration/calibration_parts.h"
#include "host/calibration/value_range.h"

namespace host {
namespace {

constexpr double kBlock_mm = 5;
constexpr double kDepth_mm = 10;
constexpr double kGap_mm = 40;
constexpr int kStepsEachWay = 4;

// Filament in a tube is drawn back farther than one that is held beside the nozzle.
double usual_step(double retraction_mm) {
  return retraction_mm > 3 ? 1 : retraction_mm > 1.5 ? 0.4 : 0.2;
}

}  // namespace

core::Result<Calibration> retraction_towers(const CalibrationRequest& request,
                                            const PrintSettings& settings) {
  const ValueLimits limits{"a retraction",
                           "mm",
                           0,
                           20,
                           "farther back, filament is crushed, or leaves the nozzle's heat",
                           2};
  const double usual = settings.retraction_mm, step = usual_step(usual);
  const double from = std::max(0.0, usual - kStepsEachWay * step);
  const ValueRange range{from, std::min(limits.most, from + 2 * kStepsEachWay * step), step};
  const core::Result<std::vector<double>> values = values_of(request, range, limits);
  if (!values.ok()) return values.error();
  const std::vector<CalibrationBlock> blocks = blocks_of(settings, values.value(), kBlock_mm);
  Calibration calibration;
  TestSolid& solid = calibration.solid;
  const LabelForm form = label_form(settings, kBlock_mm);
  const double wide = std::max(kDepth_mm, widest_label(values.value(), form) + 3);
  const double second = wide + kGap_mm;
  solid.box({-2, second + wide + 2}, {-2, kDepth_mm + 2}, {0, blocks.front().bottom.mm()});
  for (const double x : {0.0, second}) {
    add_notched_column(settings, blocks, {x, x + wide}, {0, kDepth_mm}, solid);
    add_labels(settings, blocks, {x + wide / 2, 0}, LabelSide::kFront, form, solid);
  }
  vary("retraction_mm", "mm", blocks, settings, calibration);
  calibration.settings.emplace_back("avoid_crossing_perimeters", "0");
  calibration.what = "two towers, with travel between them in every layer";
  calibration.advice = {
      "Threads and blobs on the towers' inner sides. Gaps where a road begins: more than is "
      "needed.",
      "The best block is the lowest one without threads: set retraction_mm to its number. Where "
      "all "
      "blocks have threads: dry the filament, 5 to 10 °C less (rind test temperature-tower), or "
      "another retraction_speed_mm_s.",
  };
  return calibration;
}

}  // namespace host
