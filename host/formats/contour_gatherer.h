// Builds a region from one layer's contours: snaps points to the grid, orients contours as the
// format says, and cleans them.
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

// How a format orients a contour that has its inside on the left.
enum class Turn { kAsWritten, kCounterClockwise, kClockwise };

class ContourGatherer {
 public:
  // These return why the contour can't be used; an empty text if it can.
  [[nodiscard]] std::string start();
  [[nodiscard]] std::string add(double x_mm, double y_mm);
  // REQUIRES: the point is within the bounds of a region.
  [[nodiscard]] std::string add(core::Point point);
  // Ends the contour. A last point that repeats the first is left out; a contour without area is
  // dropped.
  void end(Turn turn = Turn::kAsWritten);
  // Discards the contour that was started.
  void drop();
  // Adds all rings of a region, which are clean already.
  [[nodiscard]] std::string add(const core::Region& region);

  [[nodiscard]] bool empty() const { return rings_.empty(); }

  // The region of all contours so far; forgets them. COSTS: near-linear (boolean.h).
  [[nodiscard]] core::Region take(core::FillRule rule);

 private:
  std::vector<core::Ring> rings_;
  core::Ring ring_;
  std::size_t points_ = 0;
};

// Snaps to the grid; nullopt if not finite or beyond ±kPlaneMaxMm. too_far() is the message.
[[nodiscard]] std::optional<core::Point> snapped(double x_mm, double y_mm);
[[nodiscard]] std::string too_far(double x_mm, double y_mm);

// In grid units; nullopt if not finite or beyond ±kHeightMaxMm.
[[nodiscard]] std::optional<std::int64_t> height_units(double mm);

}  // namespace host
