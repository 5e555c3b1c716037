// Areas that overlap, parted: at every point the last one that changes a setting holds.
#include "core/slices/changed_areas.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/booleans/boolean.h"

using core::AreaChange;
using core::ChangedArea;
using core::ChangedAreas;
using core::LaidValue;
using core::Point;
using core::Region;

namespace {

Region box(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
  return Region::from_clean_rings({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}});
}

AreaChange holding_at(const ChangedAreas& areas, Point point) {
  AreaChange change;
  for (const ChangedArea& area : areas) {
    if (!area.region.contains(point)) continue;
    if (area.change.density) change.density = area.change.density;
    if (area.change.perimeters) change.perimeters = area.change.perimeters;
    const auto which = LaidValue::kLooseSpeed;
    if (area.change.value(which)) change.value(which) = area.change.value(which);
  }
  return change;
}

}  // namespace

TEST_CASE("random boxes: parts don't overlap, and each has what holds there") {
  const unsigned seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto integer = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    ChangedAreas areas;
    for (int i = 0, count = integer(1, 6); i < count; ++i) {
      const int x = 2 * integer(0, 20), y = 2 * integer(0, 20);
      ChangedArea area;
      area.region = box(x, y, x + 2 * integer(1, 20), y + 2 * integer(1, 20));
      if (integer(0, 1) == 0) area.change.density = integer(0, 2) / 2.0;
      if (integer(0, 1) == 0) area.change.perimeters = integer(1, 3);
      if (integer(0, 1) == 0) area.change.value(LaidValue::kLooseSpeed) = integer(10, 12);
      areas.push_back(std::move(area));
    }
    const ChangedAreas parts = parted(areas);
    // Corners are even, so these points are on no contour.
    for (int i = 0; i < 200; ++i) {
      const Point point{2 * integer(-1, 41) + 1, 2 * integer(-1, 41) + 1};
      int parts_here = 0;
      AreaChange found;
      for (const ChangedArea& part : parts) {
        if (!part.region.contains(point)) continue;
        ++parts_here;
        found = part.change;
      }
      CHECK_LE(parts_here, 1);
      CHECK(found == holding_at(areas, point));
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(parts[i].change == parts[k].change);
    }
  }
}

TEST_CASE("one area is as it was") {
  const ChangedAreas one{{{0.5, {}}, box(0, 0, 10, 10)}};
  CHECK(core::parted(one) == one);
  CHECK(core::parted({}).empty());
}
