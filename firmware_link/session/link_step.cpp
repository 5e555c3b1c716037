#include "firmware_link/session/link_step.h"

#include <array>

namespace firmware_link {
namespace {

// What cannot come out of a damaged line, and stops at once any garbage before it.
constexpr std::string_view kEmergencyStop = "\nM112\n";

}  // namespace

void step(Session& session, BytePort& port, Instant now, int timeout_ms) {
  const std::size_t written = port.write(session.output());
  session.written(written, now);
  std::array<std::byte, 1024> bytes;
  const std::size_t count = port.read(bytes, timeout_ms);
  session.input(std::span(bytes).first(count), now);
  session.tick(now);
  if (port.state() == PortState::kLost) session.port_lost("the port was lost: unplugged?");
}

std::span<const std::byte> emergency_stop_bytes() {
  return std::as_bytes(std::span(kEmergencyStop.data(), kEmergencyStop.size()));
}

Halt halt(const Session& session, BytePort& port, int wait_ms, int attempts) {
  // A controller that unpacks lines sees no M112 in plain characters.
  std::array<char, 16> stop{};
  std::size_t size = 0;
  if (session.may_unpack()) size += kMeatPackReset.copy(stop.data(), kMeatPackReset.size());
  for (const std::byte byte : emergency_stop_bytes()) stop[size++] = static_cast<char>(byte);
  auto bytes = std::as_bytes(std::span(stop).first(size));
  for (int i = 0; i < attempts && !bytes.empty() && port.state() == PortState::kOpen; ++i) {
    bytes = bytes.subspan(port.write(bytes));
    // Reading is what lets bytes that are on their way move on.
    std::array<std::byte, 256> answer;
    (void)port.read(answer, wait_ms);
  }
  const bool listens = session.capabilities().emergency_parser;
  if (bytes.empty() && listens) return Halt::kTold;
  if (port.state() == PortState::kOpen && port.reset_device()) return Halt::kReset;
  return bytes.empty() ? Halt::kMaybe : Halt::kNotSent;
}

}  // namespace firmware_link
