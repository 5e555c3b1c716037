// One turn of the loop between a session and a port; the emergency stop.
#pragma once

#include <cstddef>
#include <span>

#include "firmware_link/ports/byte_port.h"  // BytePort
#include "firmware_link/session/session.h"  // Session
#include "firmware_link/wire/instant.h"     // Instant

namespace firmware_link {

// Writes what waits, waits up to timeout_ms for answers, and lets the session's timers run.
void step(Session& session, BytePort& port, Instant now, int timeout_ms);

// Bytes that stop a controller at once if its EMERGENCY_PARSER is on, otherwise at the end of the
// running command: end of line, M112, end of line. They go past the session, as halt() does it.
[[nodiscard]] std::span<const std::byte> emergency_stop_bytes();

// What an emergency stop could do.
enum class Halt {
  kTold,     // M112 has left; a controller with EMERGENCY_PARSER has stopped by now
  kReset,    // M112 has left, and the board was reset, because it may not have listened
  kMaybe,    // M112 has left, and nothing more can be done: it acts when its turn comes
  kNotSent,  // the port took nothing
};

// Stops the controller at once, past the session: M112 straight to the port, and where the
// controller does not listen for it (no EMERGENCY_PARSER) a reset by DTR too. Never M410, which
// kills a homing Marlin halfway. COSTS: at most `attempts` writes, each followed by a read of at
// most wait_ms.
[[nodiscard]] Halt halt(const Session& session, BytePort& port, int wait_ms, int attempts);

}  // namespace firmware_link
