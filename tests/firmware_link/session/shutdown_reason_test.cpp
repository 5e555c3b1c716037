#include "firmware_link/session/shutdown_reason.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("a shutdown's reason is waited for, longer behind a line in flight") {
  ShutdownReason reason;
  CHECK_FALSE(reason.awaited());
  CHECK(reason.shut_down("Klipper state: Shutdown", Instant(1s)));
  CHECK_FALSE(reason.shut_down("Printer is shutdown", Instant(2s)));
  CHECK(reason.awaited());
  CHECK(reason.is_shut_down());
  CHECK(reason.words() == "Klipper state: Shutdown");
  CHECK_FALSE(reason.over(false, Instant(2s)));
  CHECK(reason.over(false, Instant(2001ms)));
  CHECK_FALSE(reason.over(true, Instant(4s)));
  CHECK(reason.over(true, Instant(4001ms)));
  reason.bridge(1s, Instant(5s));
  CHECK_FALSE(reason.over(true, Instant(5s)));
}

TEST_CASE("a position that is lost is waited for likewise, unless it has shut down") {
  ShutdownReason reason;
  CHECK(reason.position_lost("Must home axis first: 1 2 3", Instant(1s)));
  CHECK_FALSE(reason.position_lost("Must home axis first: 4 5 6", Instant(2s)));
  CHECK(reason.is_lost());
  CHECK_FALSE(reason.is_shut_down());
  CHECK(reason.words() == "Must home axis first: 1 2 3");
  CHECK_FALSE(reason.over(true, Instant(2s)));
  CHECK(reason.over(true, Instant(2001ms)));
  CHECK(reason.shut_down("Klipper state: Shutdown", Instant(2001ms)));
  CHECK_FALSE(reason.over(false, Instant(2500ms)));
}
