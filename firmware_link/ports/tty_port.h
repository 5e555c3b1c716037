// A pseudo-terminal, such as Klipper and every simulator offer, over POSIX termios: libserialport
// refuses them, because they have no entry in /sys/class/tty and no modem lines.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "firmware_link/ports/byte_port.h"  // BytePort
#include "firmware_link/ports/ports.h"      // PortError

namespace firmware_link {

class TtyPort final : public BytePort {
 public:
  // Opens a terminal by its path, raw: no echo, no translated bytes.
  [[nodiscard]] static std::variant<std::unique_ptr<BytePort>, PortError> open(
      const std::string& path);

  ~TtyPort() override;
  TtyPort(const TtyPort&) = delete;
  TtyPort& operator=(const TtyPort&) = delete;

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override;
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int timeout_ms) override;
  [[nodiscard]] PortState state() const override { return state_; }

 private:
  explicit TtyPort(int file) : file_(file) {}

  int file_;
  PortState state_ = PortState::kOpen;
};

}  // namespace firmware_link
