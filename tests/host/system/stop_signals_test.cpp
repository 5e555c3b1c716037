// In a process of its own: signals stay counted.
#include "host/system/stop_signals.h"

#include <doctest/doctest.h>
#include <signal.h>

TEST_CASE("only a second Ctrl-C is more urgent than a safe end") {
  host::watch_stop_signals();
  host::set_at_stake(true);
  CHECK_EQ(host::stop_urgency(), 0);
  for (const int signal : {SIGHUP, SIGHUP, SIGTERM, SIGTERM, SIGINT, SIGHUP, SIGTERM}) {
    REQUIRE_EQ(::raise(signal), 0);
    CHECK_EQ(host::stop_urgency(), 1);
  }
  CHECK_EQ(host::stop_signal_count(), 7);
  REQUIRE_EQ(::raise(SIGINT), 0);
  CHECK_EQ(host::stop_urgency(), 2);
  CHECK_EQ(host::pause_signal_count(), 0);
}
