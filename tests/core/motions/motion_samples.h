// Slices and roads for a motion builder, and what it makes of them.
#pragma once

#include <cmath>
#include <variant>
#include <vector>

#include "core/motions/motion_builder.h"
#include "tests/support/region_text.h"

namespace motion_test {

[[nodiscard]] inline core::Slice slice_of(core::LayerIndex index, const char* region) {
  core::Slice slice;
  slice.index = index;
  slice.height = core::Length::from_mm(0.2);
  slice.bottom = slice.height * index;
  slice.region = test::region_from_text(region);
  return slice;
}

[[nodiscard]] inline core::Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
}

[[nodiscard]] inline core::Road line(double x0, double y0, double x1, double y1,
                                     core::RoadKind kind = core::RoadKind::kSolid) {
  return {kind, core::Length::from_mm(0.45), false, {at_mm(x0, y0), at_mm(x1, y1)}};
}

inline constexpr const char* kSquare = "0:0 50:0 50:50 0:50";
inline constexpr const char* kTwoSquares = "0:0 10:0 10:10 0:10, 12:0 22:0 22:10 12:10";

struct Recorder {
  std::vector<core::Motion> motions;
  core::MotionBuilder::Sink sink() {
    return [this](const core::Motion& motion) { motions.push_back(motion); };
  }
  template <typename Kind>
  std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const core::Motion& motion : motions) {
      if (const Kind* one = std::get_if<Kind>(&motion)) found.push_back(*one);
    }
    return found;
  }
  double filament_moved() const {
    double sum = 0;
    for (const core::MoveFilament& move : all<core::MoveFilament>()) sum += move.filament_mm;
    for (const core::Wipe& wipe : all<core::Wipe>()) sum += wipe.filament_mm;
    return sum;
  }
};

}  // namespace motion_test
