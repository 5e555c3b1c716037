#include "firmware_link/virtual/virtual_heater.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("it warms at its rate up to the target, and cools towards the room") {
  VirtualHeater heater(25, 4, Instant{});
  CHECK(heater.power() == 0);
  heater.set_target(65);
  CHECK(heater.power() == 127);
  heater.advance(Instant(5s));
  CHECK(heater.celsius() == doctest::Approx(45));
  heater.advance(Instant(100s));
  CHECK(heater.celsius() == 65);
  CHECK(heater.power() == 48);
  heater.set_target(0);
  CHECK(heater.power() == 0);
  heater.advance(Instant(300s));
  CHECK(heater.celsius() == doctest::Approx(25 + 40 * 0.36788).epsilon(0.001));
}

TEST_CASE("a broken one gets no warmer, whatever is asked of it") {
  VirtualHeater heater(25, 4, Instant{});
  heater.set_target(65);
  heater.advance(Instant(5s));
  heater.break_down();
  heater.advance(Instant(1005s));
  CHECK(heater.celsius() < 26);
}
