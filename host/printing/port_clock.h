// The real time, as ports in firmware_link take it.
#pragma once

#include "firmware_link/virtual/virtual_port.h"  // PortClock
#include "firmware_link/wire/instant.h"          // Instant

namespace host {

// steady_seconds() as the link counts it.
[[nodiscard]] firmware_link::Instant link_now();

[[nodiscard]] firmware_link::PortClock steady_port_clock();

}  // namespace host
