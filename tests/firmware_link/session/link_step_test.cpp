#include "firmware_link/session/link_step.h"

#include <doctest/doctest.h>

#include <span>
#include <string>

#include "tests/firmware_link/virtual_link.h"

using namespace firmware_link;
using namespace link_test;

namespace {

class ScriptedPort final : public BytePort {
 public:
  explicit ScriptedPort(bool resets) : resets_(resets) {}
  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override {
    for (const std::byte b : bytes) written += static_cast<char>(b);
    return bytes.size();
  }
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int) override {
    const std::size_t count = std::min(into.size(), answer.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(answer[i]);
    answer.erase(0, count);
    return count;
  }
  [[nodiscard]] PortState state() const override { return port_state; }
  [[nodiscard]] bool reset_device() override {
    ++reset_asked;
    return resets_;
  }
  std::string written;
  std::string answer;
  PortState port_state = PortState::kOpen;
  int reset_asked = 0;

 private:
  bool resets_;
};

}  // namespace

TEST_CASE("a step writes what waits, hears what came, and lets time pass") {
  Session session(std::make_unique<MarlinDialect>(), {}, Instant{});
  ScriptedPort port(false);
  port.answer = "start\n";
  step(session, port, Instant{}, 0);
  for (Instant now{}; now < Instant(std::chrono::seconds(1));
       now += std::chrono::milliseconds(50)) {
    step(session, port, now, 0);
  }
  CHECK(port.written == "\nN0M110*3\n");
  CHECK(session.statistics().bytes_sent == 10);
  port.port_state = PortState::kLost;
  step(session, port, Instant(std::chrono::seconds(2)), 0);
  CHECK(session.fault_kind() == FaultKind::kPortLost);
}

TEST_CASE("an emergency stop is told, and where nobody listens for it the board is reset") {
  for (const bool listens : {true, false}) {
    for (const bool resets : {true, false}) {
      CAPTURE(listens);
      CAPTURE(resets);
      VirtualControllerOptions options;
      options.emergency_parser = listens;
      VirtualLink link(options, {});
      while (link.session->state() == SessionState::kConnecting) link.turn();
      ScriptedPort port(resets);
      const Halt halted = halt(*link.session, port, 0, 5);
      CHECK(port.written == "\nM112\n");
      CHECK(port.reset_asked == (listens ? 0 : 1));
      CHECK(halted == (listens ? Halt::kTold : resets ? Halt::kReset : Halt::kMaybe));
    }
  }
}

TEST_CASE("the emergency bytes stop a controller at once when it listens for them") {
  VirtualControllerOptions options;
  options.emergency_parser = true;
  VirtualLink link(options, {});
  const auto bytes = emergency_stop_bytes();
  link.to_controller("G28\n");
  (void)link.controller->input(bytes, link.now);
  CHECK(link.controller->state().halted);
}
