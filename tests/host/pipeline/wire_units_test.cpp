#include "host/pipeline/wire_units.h"

#include <doctest/doctest.h>

TEST_CASE("lengths go to the nearest µm, halves away from zero") {
  CHECK_EQ(host::um_of(14), 1);
  CHECK_EQ(host::um_of(15), 2);
  CHECK_EQ(host::um_of(-14), -1);
  CHECK_EQ(host::um_of(-15), -2);
  CHECK_EQ(host::um_of(0), 0);
}

TEST_CASE("filament, feed, temperature and fan are rounded, and stay in the link's range") {
  CHECK_EQ(host::filament_10nm(1.000004), 100'000);
  CHECK_EQ(host::filament_10nm(-1.000006), -100'001);
  CHECK_EQ(host::feed_mm_min(40), 2'400);
  CHECK_EQ(host::feed_mm_min(0.001), 1);
  CHECK_EQ(host::feed_mm_min(1e9), firmware_link::kFeedMmMinMax);
  CHECK_EQ(host::celsius_tenths(209.96), 2'100);
  CHECK_EQ(host::celsius_tenths(-1), 0);
  CHECK_EQ(host::celsius_tenths(5'000), 9'999);
  CHECK_EQ(host::fan_power(0.5), 128);
  CHECK_EQ(host::fan_power(1.5), 255);
}
