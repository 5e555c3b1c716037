#include "host/printing/port_clock.h"

#include <cmath>
#include <thread>

#include "host/system/stage_clock.h"

namespace host {

firmware_link::Instant link_now() {
  return firmware_link::Instant(firmware_link::Duration(std::llround(steady_seconds() * 1e6)));
}

firmware_link::PortClock steady_port_clock() {
  return {link_now,
          [](firmware_link::Duration duration) { std::this_thread::sleep_for(duration); }};
}

}  // namespace host
