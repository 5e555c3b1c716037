#include "core/offsets/compensation.h"

#include <doctest/doctest.h>

#include <cmath>

using core::Length;
using core::Region;
using core::Settings;
using core::Slice;

namespace {

// A square of 20 mm with a square hole of 8 mm, and a rib of 0.6 mm beside it.
Region plate() {
  return Region::from_clean_rings(
      {{{0, 0}, {200'000, 0}, {200'000, 200'000}, {0, 200'000}},
       {{60'000, 60'000}, {60'000, 140'000}, {140'000, 140'000}, {140'000, 60'000}},
       {{300'000, 0}, {306'000, 0}, {306'000, 200'000}, {300'000, 200'000}}});
}

Slice slice_of(core::LayerIndex index) {
  Slice slice;
  slice.index = index;
  slice.region = plate();
  return slice;
}

constexpr double kSquare = 20 * 20, kHole = 8 * 8, kRib = 0.6 * 20, kPi = 3.14159265358979;

double grown_mm2(double side_a, double side_b, double by) {
  if (by < 0) return (side_a + 2 * by) * (side_b + 2 * by);
  return side_a * side_b + 2 * (side_a + side_b) * by + kPi * by * by;
}

}  // namespace

TEST_CASE("without compensation a slice stays as it is") {
  const Settings settings;
  CHECK_FALSE(compensates(settings));
  CHECK(compensated(slice_of(0), settings) == plate());
}

TEST_CASE("contours and holes move as far as asked, each by its own length") {
  for (const double contours : {-0.1, 0.0, 0.15}) {
    for (const double holes : {-0.1, 0.0, 0.15}) {
      CAPTURE(contours);
      CAPTURE(holes);
      Settings settings;
      settings.contour_compensation = Length::from_mm(contours);
      settings.hole_compensation = Length::from_mm(holes);
      const double expected =
          grown_mm2(20, 20, contours) + grown_mm2(0.6, 20, contours) - grown_mm2(8, 8, -holes);
      CHECK_EQ(compensated(slice_of(3), settings).area_mm2(),
               doctest::Approx(expected).epsilon(1e-4));
    }
  }
}

TEST_CASE("an elephant's foot is taken off the first layer alone, and not off ribs") {
  Settings settings;
  settings.elephant_foot_compensation = Length::from_mm(0.2);
  CHECK(compensated(slice_of(1), settings) == plate());
  const double expected = grown_mm2(20, 20, -0.2) - grown_mm2(8, 8, 0.2) + kRib;
  CHECK_EQ(compensated(slice_of(0), settings).area_mm2(), doctest::Approx(expected).epsilon(1e-3));
  CHECK_EQ(plate().area_mm2(), doctest::Approx(kSquare - kHole + kRib));
}

TEST_CASE("what grows together is one") {
  Settings settings;
  settings.contour_compensation = Length::from_mm(0.6);
  settings.hole_compensation = Length::from_mm(0.2);
  Slice slice;
  slice.region =
      Region::from_clean_rings({{{0, 0}, {10'000, 0}, {10'000, 10'000}, {0, 10'000}},
                                {{20'000, 0}, {30'000, 0}, {30'000, 10'000}, {20'000, 10'000}}});
  CHECK_EQ(compensated(slice, settings).rings().size(), 1);
}
