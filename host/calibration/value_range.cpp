#include "host/calibration/value_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace host {
namespace {

// Of a step: what rounding may have left of the last one.
constexpr double kSlack = 1e-6;

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

// One end alone moves the other one with it, where they would change places otherwise.
std::pair<double, double> ends_of(const CalibrationRequest& request, const ValueRange& usual,
                                  const ValueLimits& limits) {
  const double span = usual.to - usual.from;
  double from = request.from.value_or(usual.from), to = request.to.value_or(usual.to);
  if ((to - from) * span > 0 || (request.from && request.to)) return {from, to};
  if (request.from) to = std::clamp(from + span, limits.least, limits.most);
  if (request.to) from = std::clamp(to - span, limits.least, limits.most);
  return {from, to};
}

}  // namespace

double rounded_to(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

core::Result<std::vector<double>> values_of(const CalibrationRequest& request,
                                            const ValueRange& usual, const ValueLimits& limits) {
  const auto [from, to] = ends_of(request, usual, limits);
  const double step = std::abs(request.step.value_or(usual.step));
  for (const auto& [option, value] : {std::pair{"--from", from}, std::pair{"--to", to}}) {
    if (value >= limits.least && value <= limits.most) continue;
    return bad(fmt::format("{} {:g}: {} is from {:g} to {:g} {} here: {}", option, value,
                           limits.name, limits.least, limits.most, limits.unit, limits.why));
  }
  if (rounded_to(step, limits.decimals) <= 0) {
    return bad(fmt::format("--step {:g}: the smallest step is {:g} {}", step,
                           std::pow(10.0, -limits.decimals), limits.unit));
  }
  const double steps = std::floor(std::abs(to - from) / step + kSlack);
  if (steps < 1) {
    return bad(
        fmt::format("from {:g} to {:g} {} by {:g} is one value alone: a smaller --step, or "
                    "--from and --to farther apart",
                    from, to, limits.unit, step));
  }
  if (steps + 1 > static_cast<double>(kCalibrationValuesMax)) {
    return bad(
        fmt::format("from {:g} to {:g} {} by {:g} is {:.0f} values, more than {}: a larger "
                    "--step",
                    from, to, limits.unit, step, steps + 1, kCalibrationValuesMax));
  }
  std::vector<double> values;
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    values.push_back(rounded_to(from + (to < from ? -step : step) * i, limits.decimals));
  }
  return values;
}

}  // namespace host
