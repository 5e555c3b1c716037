// The values that a test tries: from one to another, by steps.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/result.h"                   // Result
#include "host/calibration/calibration.h"  // CalibrationRequest

namespace host {

// More blocks are not told apart, and too high.
inline constexpr std::size_t kCalibrationValuesMax = 40;

struct ValueRange {
  double from = 0, to = 0;  // may sink
  double step = 1;          // > 0
};

struct ValueLimits {
  std::string_view name;  // "a temperature of the nozzle"
  std::string_view unit;
  double least = 0, most = 0;
  std::string_view why;  // of the limits
  int decimals = 2;
};

// At least two values. What the request leaves open is as `usual` says.
[[nodiscard]] core::Result<std::vector<double>> values_of(const CalibrationRequest& request,
                                                          const ValueRange& usual,
                                                          const ValueLimits& limits);

// As it stands in tables, labels and settings: without needless zeros.
[[nodiscard]] double rounded_to(double value, int decimals);

}  // namespace host
