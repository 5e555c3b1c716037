// A virtual controller at the other end of a scenario: the same calls, but wires that damage and a
// mishap that waits for its line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware_link/virtual/virtual_controller.h"  // VirtualController
#include "tools/faults/damaged_wire.h"                 // DamagedWire
#include "tools/faults/scenario.h"                     // Scenario

namespace firmware_link {

class HostileController {
 public:
  // The mishap comes with one of the within_lines lines behind the first mishap_after that a host
  // sends. REQUIRES: the scenario outlives it; within_lines > 0.
  HostileController(const Scenario& scenario, std::uint64_t seed,
                    const VirtualControllerOptions& options, std::size_t within_lines, Instant now);

  // As VirtualController's. A host that is unplugged gets nothing through.
  [[nodiscard]] std::size_t input(std::span<const std::byte> bytes, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::size_t output(std::span<std::byte> into, Instant now);
  [[nodiscard]] std::optional<Instant> next_event() const;
  [[nodiscard]] bool owes_answer() const;

  // Whether the port is there.
  [[nodiscard]] bool plugged(Instant now) const {
    return !unplugged_until_ || now >= *unplugged_until_;
  }

  [[nodiscard]] bool mishap_happened() const { return happened_; }
  [[nodiscard]] std::int64_t damages() const { return down_.damages() + up_.damages(); }
  [[nodiscard]] VirtualController& controller() { return controller_; }

 private:
  void happen(Instant now);
  void chatter(Instant now);
  void reset_unheard(Instant now);
  [[nodiscard]] std::string_view instead();
  void pass_down(Instant now);

  const Scenario& scenario_;
  SplitMix random_;
  DamagedWire down_;
  DamagedWire up_;
  VirtualController controller_;
  std::size_t lines_until_mishap_;
  std::optional<Instant> unplugged_until_;
  bool happened_ = false;
  bool mute_ = false;
  bool mute_controller_ = false;  // from the beginning: the device is none
  Instant chatter_next_{};
};

}  // namespace firmware_link
