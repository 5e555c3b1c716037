// A session and a hostile controller in simulated time, which jumps where nothing happens.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/session.h"
#include "firmware_link/wire/line_codec.h"
#include "tests/support/own_lines.h"
#include "tools/faults/hostile_controller.h"

namespace link_test {

using namespace firmware_link;

class ScenarioRun {
 public:
  ScenarioRun(const Scenario& scenario, std::uint64_t seed, std::size_t within_lines,
              VirtualControllerOptions options = {})
      : scenario_(scenario) {
    options.extrude_celsius_min = 0;
    options.klipper.homed = true;
    options.executed = [this](const ExecutedCommand& command) { note(command); };
    controller = std::make_unique<HostileController>(scenario, seed, options, within_lines, now);
    SessionOptions wanted;
    wanted.pack = scenario.meatpack;
    session = std::make_unique<Session>(std::make_unique<MarlinDialect>(), wanted, now);
  }

  // Streams all commands and finishes; true when it ended within so much simulated time.
  bool run(const std::vector<Command>& commands, Duration limit) {
    const Instant end = now + limit;
    std::size_t next = 0;
    Duration pause = kShort;
    while (now < end) {
      while (session->can_take() && next < commands.size()) {
        if (next % 10 == 9) session->check_position(now);
        if (session->can_take()) session->take(commands[next++], now);
      }
      stand_still();
      stop_in_homing(next);
      if (next == commands.size() && session->state() == SessionState::kStreaming &&
          session->can_take()) {
        session->finish(now);
      }
      const bool moved = turn();
      if (ended()) return true;
      pause = moved ? kShort : std::min(pause * 2, kLong);
      Instant then = now + pause;
      if (const auto event = controller->next_event(); event && *event > now) {
        then = std::min(then, *event);
      }
      now = std::max(then, now + kShort);
    }
    return false;
  }

  [[nodiscard]] bool ended() const {
    return session->state() == SessionState::kFinished ||
           session->state() == SessionState::kStopped || session->state() == SessionState::kFaulted;
  }

  // What was accepted is executed behind the last byte too.
  void let_controller_work() {
    // One that waits for heat that never comes is left alone.
    const bool cold = session->fault_kind() == FaultKind::kHeater;
    for (int i = 0; i < 100 && !cold && controller->owes_answer(); ++i) {
      std::array<std::byte, 512> bytes;
      while (controller->output(bytes, now) > 0) {
      }
      now += std::chrono::seconds(30);
      controller->advance(now);
    }
  }

  Instant now{};
  std::unique_ptr<HostileController> controller;
  std::unique_ptr<Session> session;
  std::vector<std::string> printed;  // the print's own commands, as they were started
  std::vector<std::string> strays;   // known ones that came without a number
  int turns = 0;

 private:
  static constexpr Duration kShort = std::chrono::milliseconds(2);
  static constexpr Duration kLong = std::chrono::seconds(1);

  // The host's clock jumps ahead; the controller's does not.
  void stand_still() {
    if (scenario_.mishap != Mishap::kHostStands || !controller->mishap_happened() || stood_) return;
    stood_ = true;
    now += std::chrono::seconds(70 + turns % 200);
  }

  // A homing among the commands, and a stop in it.
  void stop_in_homing(std::size_t next) {
    if (scenario_.mishap != Mishap::kStopHoming || next < 8) return;
    if (!homing_since_ && session->can_take()) {
      session->take(std::get<Verbatim>(verbatim_from("G28")), now);
      homing_since_ = now;
    }
    if (homing_since_ && now - *homing_since_ > std::chrono::seconds(4)) {
      const Command off = SetFan{};
      session->stop_now({&off, 1}, now);
    }
  }

  bool stood_ = false;
  std::optional<Instant> homing_since_;

  // One exchange of bytes; false when there was none.
  bool turn() {
    ++turns;
    bool moved = false;
    if (const auto output = session->output(); !output.empty()) {
      const std::size_t count = controller->input(output, now);
      session->written(count, now);
      moved = count > 0;
    }
    controller->advance(now);
    std::array<std::byte, 512> bytes;
    while (const std::size_t count = controller->output(bytes, now)) {
      session->input(std::span(bytes).first(count), now);
      moved = true;
    }
    session->tick(now);
    if (!controller->plugged(now)) session->port_lost("the port was lost: unplugged?");
    return moved;
  }

  // A question that ran together with the line before it is the link's own, and lost.
  static std::string without_question(std::string text) {
    for (const char* question : {"M105", "M114"}) {
      const std::size_t at = text.find(question, 1);
      if (at == std::string::npos) continue;
      text.resize(at);
      while (!text.empty() && text.back() == ' ') text.pop_back();
      SpelledBuffer buffer;
      text = std::string(spelled_out(std::string(text), buffer));
    }
    return text;
  }

  void note(const ExecutedCommand& command) {
    std::string text(command.text);
    text = without_question(text);
    if (test::is_own_line(text) || text.substr(0, 4) == "G1 E") return;
    const bool numbers =
        scenario_.dialect == VirtualDialect::kMarlin || scenario_.dialect == VirtualDialect::kPrusa;
    if (command.number || !numbers) {
      printed.push_back(text);
    } else if (command.known) {
      strays.push_back(text);
    }
  }

  const Scenario& scenario_;
};

}  // namespace link_test
