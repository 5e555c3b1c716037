// One layer's contours on their way from a file to a region: snapped to the grid, turned as the
// format says, cleaned.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"  // FillRule
#include "core/geometry.h"          // Ring
#include "core/regions/region.h"    // Region

namespace host {

// What a format says about the side on which the inside lies.
enum class Turn { kAsWritten, kCounterClockwise, kClockwise };

class ContourGatherer {
 public:
  // These return why the contour can't be taken, and an empty text when it can.
  [[nodiscard]] std::string begin();
  [[nodiscard]] std::string add(double x_mm, double y_mm);
  // REQUIRES: within the plane's bounds, as what a region holds is.
  [[nodiscard]] std::string add(core::Point point);
  // A last point that repeats the first is left out; what has no area is dropped.
  void end(Turn turn = Turn::kAsWritten);
  // What was begun is not wanted.
  void drop();
  // A region as a whole: its rings are clean among themselves.
  [[nodiscard]] std::string add(const core::Region& region);

  [[nodiscard]] bool empty() const { return rings_.empty(); }

  // All contours ended so far, and then none.
  // COSTS: near-linear (boolean.h).
  [[nodiscard]] core::Region take(core::FillRule rule);

 private:
  std::vector<core::Ring> rings_;
  core::Ring ring_;
  std::size_t points_ = 0;
};

// A point on the grid, unless it lies beyond ±kPlaneMaxMm, or nowhere; and what to say then.
[[nodiscard]] std::optional<core::Point> snapped(double x_mm, double y_mm);
[[nodiscard]] std::string too_far(double x_mm, double y_mm);

// In grid units, where it is a height that can be: finite, within ±kHeightMaxMm.
[[nodiscard]] std::optional<std::int64_t> height_units(double mm);

}  // namespace host
