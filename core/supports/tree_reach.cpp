#include "core/supports/tree_reach.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "core/bed.h"                       // Bed
#include "core/booleans/boolean.h"          // subtract, unite
#include "core/booleans/simplified.h"       // simplified
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/trigonometry.h"              // cosine, sine

namespace core {
namespace {

// What is blocked is grown this exactly, and by as much more.
constexpr Length kBlockedTolerance = Length::from_units(200);

// A step's tolerance of arcs and of what is simplified, as a share of the step.
constexpr double kStepTolerance = 0.0025;

// What a boolean may move a contour by.
constexpr Length kBooleanSlack = Length::from_units(1);

// How wide the border around the bed is; branches move by less in a layer.
constexpr Length kBorder = Length::from_units(200'000);

Ring rectangle(std::int64_t from_x, std::int64_t from_y, std::int64_t to_x, std::int64_t to_y) {
  const auto x0 = static_cast<std::int32_t>(from_x), y0 = static_cast<std::int32_t>(from_y);
  const auto x1 = static_cast<std::int32_t>(to_x), y1 = static_cast<std::int32_t>(to_y);
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// What is not over the bed, near its edge.
Region border(const Settings& settings) {
  const std::int64_t x = settings.bed_x.units(), y = settings.bed_y.units();
  const std::int64_t inset = (branch_core(settings) + settings.road_width).units();
  if (x <= 2 * inset || y <= 2 * inset) return {};
  const std::int64_t out = kBorder.units();
  if (!settings.bed_shape.empty()) {
    const Region bed = Region::from_clean_rings({Bed(settings).outline()});
    return subtract(Region::from_clean_rings({rectangle(-out, -out, x + out, y + out)}),
                    offset(bed, Length::from_units(inset), kBlockedTolerance));
  }
  Ring hole = rectangle(inset, inset, x - inset, y - inset);
  std::reverse(hole.begin() + 1, hole.end());
  return Region::from_clean_rings({rectangle(-out, -out, x + out, y + out), std::move(hole)});
}

}  // namespace

Length branch_step(Length planes, const Settings& settings) {
  const double angle = settings.support_branch_angle_degrees * std::numbers::pi / 180;
  return Length::from_mm(planes.mm() * sine(angle) / cosine(angle));
}

Length branch_core(const Settings& settings) {
  return Length::from_units(settings.support_tip_diameter.units() / 2);
}

Region blocked_for_branches(const Region& slice, const Settings& settings) {
  if (slice.empty()) return border(settings);
  const Length by = settings.support_xy_distance + branch_core(settings) + kBlockedTolerance * 2;
  return unite(offset(simplified(slice, kBlockedTolerance), -by, kBlockedTolerance),
               border(settings));
}

SharedRegion TreeReach::push(const Region& slice, Length height) {
  const bool same = blocked_ && slice == slice_;
  if (!same) {
    slice_ = slice;
    blocked_ = std::make_shared<const Region>(blocked_for_branches(slice, settings_));
  }
  avoided_ = avoided(height, same);
  height_ = height;
  return avoided_;
}

SharedRegion TreeReach::avoided(Length height, bool same) const {
  if (!avoided_) return blocked_;                     // on the bed
  if (same && avoided_ == blocked_) return avoided_;  // its inset lies within it
  const Length planes = Length::from_units((height + height_).units() / 2);
  const Length step = branch_step(planes, settings_);
  const Length tolerance =
      std::max(Length::from_units(1), Length::from_mm(step.mm() * kStepTolerance));
  const Length inset = std::max(step - tolerance * 2 - kBooleanSlack, Length());
  const Region left = offset(*avoided_, inset, tolerance);
  if (subtract(left, *blocked_).empty()) return blocked_;
  return std::make_shared<const Region>(simplified(unite(left, *blocked_), tolerance));
}

}  // namespace core
