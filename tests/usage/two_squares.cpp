// Unites two squares that overlap, and prints what they cover together.
#include <cstdint>
#include <cstdio>

#include "core/booleans/boolean.h"
#include "core/regions/region.h"
#include "core/units.h"

namespace {

core::Region square(double left_mm, double side_mm) {
  const auto at = [](double mm) {
    return static_cast<std::int32_t>(core::Length::from_mm(mm).units());
  };
  const std::int32_t left = at(left_mm), right = at(left_mm + side_mm), top = at(side_mm);
  return core::Region::from_clean_rings({{{left, 0}, {right, 0}, {right, top}, {left, top}}});
}

}  // namespace

int main() {
  const core::Region both = core::unite(square(0, 10), square(5, 10));
  std::printf("%.1f mm2\n", both.area_mm2());
}
