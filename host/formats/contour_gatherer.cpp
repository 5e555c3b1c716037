#include "host/formats/contour_gatherer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/limits.h"                 // kCoordinateMax
#include "core/units.h"                  // kUnitsPerMm
#include "host/formats/format_limits.h"  // kLayerPointsMax
#include "host/formats/number_text.h"    // number_text

namespace host {

static_assert(kPlaneMaxMm * core::kUnitsPerMm <= core::kCoordinateMax);

std::string ContourGatherer::start() {
  ring_.clear();
  if (rings_.size() < kLayerRingsMax) return {};
  return "a layer of more than " + std::to_string(kLayerRingsMax) +
         " contours, which is more than fits; simplify the part";
}

std::string ContourGatherer::add(double x_mm, double y_mm) {
  const std::optional<core::Point> point = snapped(x_mm, y_mm);
  return point ? add(*point) : too_far(x_mm, y_mm);
}

std::string ContourGatherer::add(core::Point point) {
  if (points_ + ring_.size() >= kLayerPointsMax) {
    return "a layer of more than " + std::to_string(kLayerPointsMax) +
           " points, which is more than fits; simplify the part";
  }
  ring_.push_back(point);
  return {};
}

void ContourGatherer::end(Turn turn) {
  while (ring_.size() > 1 && ring_.back() == ring_.front()) ring_.pop_back();
  const double doubled_area = core::doubled_area_units(ring_);
  if (ring_.size() < 3 || (turn != Turn::kAsWritten && doubled_area == 0)) return ring_.clear();
  const bool wrong = (turn == Turn::kCounterClockwise && doubled_area < 0) ||
                     (turn == Turn::kClockwise && doubled_area > 0);
  if (wrong) std::reverse(ring_.begin(), ring_.end());
  points_ += ring_.size();
  rings_.push_back(std::move(ring_));
  ring_.clear();
}

void ContourGatherer::drop() { ring_.clear(); }

std::string ContourGatherer::add(const core::Region& region) {
  for (const core::Ring& ring : region.rings()) {
    if (std::string cause = start(); !cause.empty()) return cause;
    for (const core::Point point : ring) {
      if (std::string cause = add(point); !cause.empty()) return cause;
    }
    end();
  }
  return {};
}

core::Region ContourGatherer::take(core::FillRule rule) {
  core::Region region = core::clean(rings_, rule);
  rings_.clear();
  points_ = 0;
  return region;
}

std::optional<core::Point> snapped(double x_mm, double y_mm) {
  // NaN compares as false.
  if (!(std::abs(x_mm) <= kPlaneMaxMm && std::abs(y_mm) <= kPlaneMaxMm)) return std::nullopt;
  return core::Point{static_cast<std::int32_t>(std::llround(x_mm * core::kUnitsPerMm)),
                     static_cast<std::int32_t>(std::llround(y_mm * core::kUnitsPerMm))};
}

std::string too_far(double x_mm, double y_mm) {
  if (!std::isfinite(x_mm) || !std::isfinite(y_mm)) {
    return "a coordinate is not a finite number; export the file again";
  }
  return "a point is at " + number_text(x_mm) + ", " + number_text(y_mm) + " mm, farther than " +
         number_text(kPlaneMaxMm) + " mm from the origin; move the part, or check its unit";
}

std::optional<std::int64_t> height_units(double mm) {
  if (!std::isfinite(mm) || std::abs(mm) > kHeightMaxMm) return std::nullopt;
  return std::llround(mm * core::kUnitsPerMm);
}

}  // namespace host
