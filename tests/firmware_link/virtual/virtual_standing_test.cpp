#include "firmware_link/virtual/virtual_standing.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("the longest time that a nozzle stands on what it has laid, while it is not cooled") {
  VirtualStanding standing;
  standing.look(false, Instant(1s));
  standing.look(false, Instant(9s));
  CHECK(standing.longest() == 0s);
  standing.laid();
  standing.look(false, Instant(10s));
  standing.look(false, Instant(13s));
  CHECK(standing.longest() == 3s);
  standing.look(true, Instant(14s));
  standing.look(false, Instant(20s));
  standing.look(false, Instant(22s));
  CHECK(standing.longest() == 3s);
  standing.cooled();
  standing.look(false, Instant(100s));
  CHECK(standing.longest() == 3s);
}
