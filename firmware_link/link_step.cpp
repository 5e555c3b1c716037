#include "firmware_link/link_step.h"

#include <array>

namespace firmware_link {

void step(Session& session, BytePort& port, Instant now, int timeout_ms) {
  const std::size_t written = port.write(session.output());
  session.written(written, now);
  std::array<std::byte, 1024> bytes;
  const std::size_t count = port.read(bytes, timeout_ms);
  session.input(std::span(bytes).first(count), now);
  session.tick(now);
  if (port.state() == PortState::kLost) session.port_lost("the port was lost: unplugged?");
}

}  // namespace firmware_link
