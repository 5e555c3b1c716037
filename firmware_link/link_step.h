// One turn of the loop between a session and a port.
#pragma once

#include "firmware_link/byte_port.h"  // BytePort
#include "firmware_link/session.h"    // Session

namespace firmware_link {

// Writes what fits, waits up to timeout_ms for answers, lets the session's timers run. Faults the
// session when the port is lost. `now` is the time at the call.
void step(Session& session, BytePort& port, Instant now, int timeout_ms);

}  // namespace firmware_link
