#include "firmware_link/virtual/virtual_klipper_state.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("it is ready at once, later, or never") {
  VirtualKlipperState state;
  SUBCASE("at once") {
    state.start("", 0s, Instant{});
    CHECK(state.ready());
    CHECK(state.message() == "Printer is ready");
  }
  SUBCASE("later") {
    state.start("", 3s, Instant{});
    CHECK(state.starting());
    CHECK(state.next(true, 600s) == Instant(3s));
    CHECK(state.message().find("Printer is not ready\n") == 0);
    CHECK_FALSE(state.found(Instant(2s)));
    CHECK(state.found(Instant(3s)));
    CHECK(state.ready());
    CHECK_FALSE(state.found(Instant(4s)));
  }
  SUBCASE("never") {
    state.start("Option 'x' is not valid", 3s, Instant{});
    CHECK_FALSE(state.becomes_ready());
    CHECK_FALSE(state.ready());
    CHECK(state.message().find("Option 'x' is not valid\n\nOnce") == 0);
  }
}

TEST_CASE("a shutdown has a reason, and happens once") {
  VirtualKlipperState state;
  bool was_ready = false;
  CHECK(state.shut_down("Lost communication with MCU 'mcu'\nmore", &was_ready));
  CHECK(was_ready);
  CHECK_FALSE(state.ready());
  CHECK(state.message().find("Lost communication with MCU 'mcu'\nOnce") == 0);
  CHECK_FALSE(state.shut_down("another", &was_ready));
  state.start("", 1s, Instant{});
  CHECK(state.shut_down("echo:M112 Shutdown\n", &was_ready));
  CHECK_FALSE(was_ready);
  CHECK(state.message().find("Shutdown due to M112 command") == 0);
}

TEST_CASE("it falls idle once when nothing moves for long, after a command that needs motors") {
  VirtualKlipperState state;
  CHECK_FALSE(state.falls_idle(false, 600s, Instant(1h)));
  state.wake();
  CHECK_FALSE(state.falls_idle(true, 600s, Instant(1h)));
  CHECK_FALSE(state.next(true, 600s).has_value());
  CHECK(state.next(false, 600s) == Instant(1h + 600s));
  CHECK_FALSE(state.falls_idle(false, 600s, Instant(1h + 599s)));
  CHECK(state.falls_idle(false, 600s, Instant(1h + 600s)));
  CHECK_FALSE(state.falls_idle(false, 600s, Instant(2h)));
}
