// Plug point: where bytes go. A serial device, a pseudo-terminal, a virtual controller.
#pragma once

#include <cstddef>
#include <span>

namespace firmware_link {

// kLost is final: the device has gone or the other side hung up.
enum class PortState { kOpen, kLost };

class BytePort {
 public:
  virtual ~BytePort() = default;

  // Takes as many bytes as fit without waiting and returns how many; 0 when full or lost.
  [[nodiscard]] virtual std::size_t write(std::span<const std::byte> bytes) = 0;

  // Waits up to timeout_ms for the first byte, then takes what is there; returns how many bytes
  // were put into `into`; 0 when none came in time or the port is lost.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> into, int timeout_ms) = 0;

  [[nodiscard]] virtual PortState state() const = 0;

  // Pulls the modem line (DTR) that resets most boards: the last resort when a controller does not
  // listen. False where there is no such line.
  [[nodiscard]] virtual bool reset_device() { return false; }
};

}  // namespace firmware_link
