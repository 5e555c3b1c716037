// A real serial device, over libserialport: any baud, 250000 included; 8 data bits, no parity, one
// stop bit, no flow control, DTR on, which resets most 8-bit boards.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "firmware_link/ports/byte_port.h"  // BytePort
#include "firmware_link/ports/ports.h"      // PortDescription, PortError

namespace firmware_link {

class SerialPort final : public BytePort {
 public:
  // REQUIRES: baud > 0.
  [[nodiscard]] static std::variant<std::unique_ptr<BytePort>, PortError> open(
      const std::string& path, int baud);

  [[nodiscard]] static std::vector<PortDescription> list();

  ~SerialPort() override;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override;
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int timeout_ms) override;
  [[nodiscard]] PortState state() const override { return state_; }
  [[nodiscard]] bool reset_device() override;

 private:
  struct Device;  // libserialport's
  explicit SerialPort(std::unique_ptr<Device> device);

  std::unique_ptr<Device> device_;
  PortState state_ = PortState::kOpen;
};

}  // namespace firmware_link
