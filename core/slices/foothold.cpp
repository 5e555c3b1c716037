#include "core/slices/foothold.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "core/regions/convex_hull.h"  // breadth_of
#include "core/trigonometry.h"         // hypotenuse
#include "core/units.h"                // kUnitsPerMm

namespace core {

Foot foot_of(const Ring& hull, double area_mm2) {
  const Box box = box_of(hull);
  const auto middle = [](std::int64_t a, std::int64_t b) {
    return static_cast<std::int32_t>((a + b) / 2);
  };
  Foot foot;
  foot.at = {middle(box.min.x, box.max.x), middle(box.min.y, box.max.y)};
  foot.breadth_mm = breadth_of(hull).least_mm;
  foot.area_mm2 = area_mm2;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point a = hull[i], b = hull[i + 1 < hull.size() ? i + 1 : 0];
    foot.outline_mm +=
        hypotenuse(static_cast<double>(b.x) - a.x, static_cast<double>(b.y) - a.y) / kUnitsPerMm;
  }
  return foot;
}

Foot with_brim(Foot foot, double brim_mm) {
  foot.breadth_mm += 2 * brim_mm;
  foot.area_mm2 += brim_mm * (foot.outline_mm + std::numbers::pi * brim_mm);
  foot.outline_mm += 2 * std::numbers::pi * brim_mm;
  return foot;
}

double slenderness(const Foot& foot, double height_mm) {
  return height_mm / std::max(foot.breadth_mm, kRoadBreadth_mm);
}

bool may_come_loose(const Foot& foot, double height_mm) {
  if (slenderness(foot, height_mm) < kSlendernessTold) return false;
  return kNozzlePushNewtons * height_mm > kBedHoldMpa * foot.area_mm2 * foot.breadth_mm / 6;
}

std::optional<int> brim_that_holds_mm(const Foot& foot, double height_mm) {
  for (int brim_mm = 0; brim_mm <= kBrimAdvisedMax_mm; ++brim_mm) {
    if (!may_come_loose(with_brim(foot, brim_mm), height_mm)) return brim_mm;
  }
  return std::nullopt;
}

}  // namespace core
