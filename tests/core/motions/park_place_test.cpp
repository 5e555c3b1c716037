#include "core/motions/park_place.h"

#include <doctest/doctest.h>

using core::Length;
using core::Point;

TEST_CASE("the nozzle is parked where the user says, or near the bed's corner, never off the bed") {
  core::Settings settings;
  settings.bed_x = Length::from_mm(200);
  settings.bed_y = Length::from_mm(6);
  CHECK_EQ(core::park_place(settings), Point{50'000, 30'000});
  settings.park_x = Length::from_mm(0);
  CHECK_EQ(core::park_place(settings), Point{0, 30'000});
  settings.park_x = Length::from_mm(150);
  settings.park_y = Length::from_mm(6);
  CHECK_EQ(core::park_place(settings), Point{1'500'000, 60'000});
  // The controller's axis may be shorter than the bed was taken to be.
  settings.bed_x = Length::from_mm(120);
  CHECK_EQ(core::park_place(settings), Point{1'200'000, 60'000});
}
