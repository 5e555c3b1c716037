// The virtual controller as a BytePort: what `--port virtual` prints to.
//
// Its time runs `speed` times as fast as the clock it is given. At speed 0 it runs as fast as
// possible: whenever a reader waits and the controller owes an answer, simulated time jumps to the
// controller's next event, so that heating, homing and a full planner take no time at all.
//
// All calls from one thread, the one that runs the link; controller() too, unless that thread has
// ended.
#pragma once

#include <functional>

#include "firmware_link/ports/byte_port.h"             // BytePort
#include "firmware_link/virtual/virtual_controller.h"  // VirtualController
#include "firmware_link/wire/instant.h"                // Instant

namespace firmware_link {

// Where the port gets its time from, because this room has no clock.
struct PortClock {
  std::function<Instant()> now;
  std::function<void(Duration)> sleep;
};

class VirtualPort final : public BytePort {
 public:
  // REQUIRES: both functions of the clock set; speed >= 0, where 0 is as fast as possible.
  VirtualPort(const VirtualControllerOptions& options, PortClock clock, double speed);

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override;
  [[nodiscard]] std::size_t read(std::span<std::byte> into, int timeout_ms) override;
  [[nodiscard]] PortState state() const override { return PortState::kOpen; }

  // ENSURES: the controller has lived until now (at speed 0: until nothing more happens).
  [[nodiscard]] VirtualController& controller();

  // Simulated time.
  [[nodiscard]] Instant simulated_now();

 private:
  PortClock clock_;
  double speed_;
  Instant origin_;
  Instant simulated_;
  VirtualController controller_;
};

}  // namespace firmware_link
