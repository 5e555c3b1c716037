// A virtual controller within a scenario: it has the same functions, wires that damage bytes, and a
// mishap that happens at a certain line.
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
  // The mishap happens at one of `within_lines` lines after the host's first mishap_after lines.
  // REQUIRES: the scenario outlives this; within_lines > 0.
  HostileController(const Scenario& scenario, std::uint64_t seed,
                    const VirtualControllerOptions& options, std::size_t within_lines, Instant now);

  // As in VirtualController. An unplugged host can't send or receive.
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
  bool mute_controller_ = false;  // from the start: the device is no controller
  Instant chatter_next_{};
};

}  // namespace firmware_link
