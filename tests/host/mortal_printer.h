// A virtual printer that outlives its hosts, and of which is known what it has really laid: moves
// that its planner lost in a reset, or that were still to come, do not count. Its wire can be cut
// with bytes on it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "firmware_link/ports/byte_port.h"
#include "firmware_link/virtual/virtual_controller.h"
#include "host/printing/port_clock.h"
#include "tests/support/laid_roads.h"

namespace print_test {

class MortalPrinter {
 public:
  explicit MortalPrinter(firmware_link::VirtualControllerOptions options) {
    options.executed = [this](const firmware_link::ExecutedCommand& command) {
      commands.emplace_back(command.text);
    };
    options.moved = [this](std::int64_t command) {
      moved_ = static_cast<std::size_t>(command) + 1;
    };
    now_ = host::link_now();
    controller_ = std::make_unique<firmware_link::VirtualController>(options, now_);
  }

  // All that were begun, since it was made.
  std::vector<std::string> commands;

  // Its power went, or its button was pressed: what waits in the planner is lost.
  void reset() {
    live_on(0);
    settle();
    controller_->reset(now_);
    traced_ = moved_ = commands.size();
  }

  // Time passes with nobody there.
  void live_on(int ms) {
    now_ += std::chrono::milliseconds(ms);
    controller_->advance(now_);
  }

  // Until nothing more moves.
  void come_to_rest() {
    while (controller_->moving() || controller_->owes_answer()) {
      const auto next = controller_->next_event();
      if (!next) break;
      now_ = std::max(now_, *next);
      controller_->advance(now_);
    }
  }

  // What was laid by moves that have ended.
  [[nodiscard]] std::vector<test::LaidPiece> laid() {
    settle();
    return tracer_.laid();
  }
  // How high the nozzle is, as a person would see it.
  [[nodiscard]] std::int64_t nozzle_z_um() {
    settle();
    return std::llround(tracer_.height() * 1'000);
  }

  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) {
    return controller_->input(bytes, now_);
  }
  // As VirtualPort at speed 0: whenever an answer is owed, time jumps to it.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) {
    while (true) {
      controller_->advance(now_);
      if (const std::size_t count = controller_->output(into); count > 0) return count;
      if (!controller_->owes_answer()) return 0;
      const auto next = controller_->next_event();
      if (!next) return 0;
      now_ = std::max(now_, *next);
    }
  }

 private:
  // What has moved is traced; in a reset the rest of what was begun falls away.
  void settle() {
    for (; traced_ < moved_; ++traced_) tracer_.execute(commands[traced_]);
  }

  std::unique_ptr<firmware_link::VirtualController> controller_;
  firmware_link::Instant now_;
  test::RoadTracer tracer_;
  std::size_t moved_ = 0;   // commands before it have ended
  std::size_t traced_ = 0;  // or have fallen away
};

}  // namespace print_test
