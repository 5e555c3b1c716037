// What controllers tell of how far their axes go.
#include "firmware_link/wire/travel_limits.h"

#include <doctest/doctest.h>

#include "firmware_link/wire/capabilities.h"

using firmware_link::travel_limits_in;
using firmware_link::TravelLimits;

TEST_CASE("limits are read in all the ways in which Marlin tells them") {
  const TravelLimits ender{{0, 0, 0}, {220, 220, 250}};
  CHECK(travel_limits_in("Min:  X0.00 Y0.00 Z0.00   Max:  X220.00 Y220.00 Z250.00") == ender);
  CHECK(travel_limits_in("Soft endstops: ON  Min:  X0.00 Y0.00 Z0.00   "
                         "Max:  X220.00 Y220.00 Z250.00") == ender);
  CHECK(travel_limits_in("Soft endstops: On   Min: X0.00 Y0.00 Z0.00  "
                         "Max: X220.00 Y220.00 Z250.00") == ender);
  CHECK(travel_limits_in("Min: X:0.00 Y:0.00 Z:0.00 Max: X:220.00 Y:220.00 Z:250.00") == ender);
  CHECK(travel_limits_in("area:{full:{min:{x:0.0000,y:0.0000,z:0.0000},max:{x:220.0000,y:220.0000,"
                         "z:250.0000}},work:{min:{x:0,y:0,z:0},max:{x:200,y:200,z:250}}}") ==
        ender);
  const TravelLimits delta{{-125, -125, 0}, {125, 125, 320}};
  CHECK(travel_limits_in("Min: X-125.00 Y-125.00 Z0.00 Max: X125.00 Y125.00 Z320.00") == delta);
}

TEST_CASE("other lines, and damaged ones, tell nothing") {
  for (const char* line :
       {"", "Min:", "X:0.00 Y:0.00 Z:5.00 E:0.00 Count X:0 Y:0 Z:2000", "Cap:ARCS:1",
        "Min: X0.00 Y0.00 Max: X220.00 Y220.00", "Min: X0.00 Y0.00 Z0.00 Max: X2?0.00",
        "Min: X0.00 Y0.00 Z0.00 Max: X0.00 Y220.00 Z250.00", "area:{full:{min:{x:1",
        "Min: Xnan Y0.00 Z0.00 Max: X220.00 Y220.00 Z250.00"}) {
    CAPTURE(line);
    CHECK_FALSE(travel_limits_in(line).has_value());
  }
}

TEST_CASE("limits are believed when they were told twice the same") {
  firmware_link::Capabilities controller;
  firmware_link::note_travel("Min: X0.00 Y0.00 Z0.00 Max: X20.00 Y200.00 Z200.00", controller);
  CHECK_FALSE(controller.travel.has_value());  // a digit may be missing
  firmware_link::note_travel("Min: X0.00 Y0.00 Z0.00 Max: X200.00 Y200.00 Z200.00", controller);
  CHECK_FALSE(controller.travel.has_value());
  firmware_link::note_travel("ok", controller);
  firmware_link::note_travel("Min: X0.00 Y0.00 Z0.00 Max: X200.00 Y200.00 Z200.00", controller);
  REQUIRE(controller.travel.has_value());
  CHECK_EQ(controller.travel->max_mm[0], 200);
}
