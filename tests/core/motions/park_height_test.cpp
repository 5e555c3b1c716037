#include "core/motions/park_height.h"

#include <doctest/doctest.h>

using core::Length;

TEST_CASE("a nozzle is lifted by park_lift, not over the axis and not down") {
  core::Settings settings;
  settings.park_lift = Length::from_mm(10);
  CHECK_EQ(core::park_height(Length::from_mm(3), settings), Length::from_mm(13));
  settings.axis_z = Length::from_mm(8);
  CHECK_EQ(core::park_height(Length::from_mm(3), settings), Length::from_mm(8));
  CHECK_EQ(core::park_height(Length::from_mm(9), settings), Length::from_mm(9));
}
