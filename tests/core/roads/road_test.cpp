#include "core/roads/road.h"

#include <doctest/doctest.h>

#include <numbers>

#include "core/offsets/slice_offsets.h"

using namespace core;

TEST_CASE("a bead is a rectangle with round sides, an ellipse where it is narrower than high") {
  const Length h = Length::from_mm(0.2);
  CHECK(bead_area_mm2(Length::from_mm(0.45), h) ==
        doctest::Approx(0.2 * 0.25 + std::numbers::pi * 0.1 * 0.1));
  CHECK(bead_area_mm2(h, h) == doctest::Approx(std::numbers::pi * 0.1 * 0.1));
  CHECK(bead_area_mm2(Length::from_mm(0.1), h) == doctest::Approx(std::numbers::pi * 0.05 * 0.1));
}

TEST_CASE("beads at perimeter_spacing fill a layer without a void, or just touch") {
  Settings settings;
  const Length h = settings.layer_height, w = settings.road_width;
  settings.road_overlap = 1;
  CHECK(perimeter_spacing(settings, h).mm() * h.mm() ==
        doctest::Approx(bead_area_mm2(w, h)).epsilon(1e-3));
  CHECK_LT(perimeter_spacing(settings, h), w);
  settings.road_overlap = 0;
  CHECK_EQ(perimeter_spacing(settings, h), w);
}
