// A controller behind a network: tcp://host:port, as RepRapFirmware, ESP bridges and ser2net offer.
// The same bytes go there as to a serial device; what guards them (numbers, checksums, answers) is
// the session's, and TCP's own repeats come on top.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "firmware_link/ports/byte_port.h"  // BytePort
#include "firmware_link/ports/ports.h"      // PortError

namespace firmware_link {

// How long a connection may take to come about.
inline constexpr int kConnectLimit_ms = 5000;

class TcpPort final : public BytePort {
 public:
  // True for a path that starts with tcp://.
  [[nodiscard]] static bool names_one(std::string_view path);

  // Connects; names and addresses of IPv4 and IPv6 are taken ("tcp://[::1]:23"). Small writes leave
  // at once (TCP_NODELAY): an answer waits for each window.
  // COSTS: waits up to kConnectLimit_ms for each address of the name.
  [[nodiscard]] static std::variant<std::unique_ptr<BytePort>, PortError> open(
      const std::string& path);

  ~TcpPort() override;
  TcpPort(const TcpPort&) = delete;
  TcpPort& operator=(const TcpPort&) = delete;

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override;
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int timeout_ms) override;
  [[nodiscard]] PortState state() const override { return state_; }

 private:
  explicit TcpPort(int file) : file_(file) {}

  int file_;
  PortState state_ = PortState::kOpen;
};

}  // namespace firmware_link
