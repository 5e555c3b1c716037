// Parts that people print to find a setting's value (`rind test`). Each is a body, the settings it
// needs, a table of what is varied at which height, and words on what to look for.
//
//     first-layer        squares all over the bed
//     temperature-tower  a bridge and two overhangs in each block; hottest below
//     retraction         two towers, and travel between them
//     flow               a box with walls of one road, to be measured
//     pressure-advance   a frame with sharp corners
//     max-flow           a loop of one road that is laid faster and faster
//
// What changes with the height is a setting's value (core/motions/height_actions.h), so a test is
// printed, written and resumed like any part. Blocks are whole layers, and have labels.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"                   // Result
#include "core/units.h"                    // Length
#include "host/calibration/test_solid.h"   // TestSolid
#include "host/pipeline/print_settings.h"  // PrintSettings

namespace host {

// What was asked for. What is not set follows from the settings.
struct CalibrationRequest {
  std::string test;  // one of calibration_names()
  std::optional<double> from, to, step;
};

// A value, and the heights between which it holds.
struct CalibrationBlock {
  core::Length bottom, top;
  double value = 0;
};

struct Calibration {
  std::string what;  // "two towers"
  TestSolid solid;
  // Keys of settings and their values, over those that were asked for.
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::string> at_height;  // the setting of that name; empty: as it was
  std::string key;                     // of the setting that is varied; empty: none is
  std::string unit;                    // of it
  std::vector<CalibrationBlock> blocks;
  std::vector<std::string> advice;  // what to look for, and what to do then; a line each
};

// In the order above.
[[nodiscard]] std::span<const std::string_view> calibration_names();

// Errors: the test has no range, or one beyond its limits; the bed or the axis is too small.
// REQUIRES: settings are validated.
[[nodiscard]] core::Result<Calibration> plan_calibration(const CalibrationRequest& request,
                                                         const PrintSettings& settings);

// What is varied at which heights, and the advice.
[[nodiscard]] std::string calibration_text(const Calibration& calibration, const std::string& test);

}  // namespace host
