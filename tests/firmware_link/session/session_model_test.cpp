// A model check of session and send_window: short prints over a wire that may lose, double or delay
// any line either way, in every order, up to a number of faults. Each command is executed exactly
// once and in order, or the session stops with a reason; simulated time is bounded.
//
//     line events, both ways, as they come    0 1 2 3 4 5 …
//     one run                                 . L . . D .      L lost, D doubled, T late
//     all runs                                every choice of places and kinds
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/session.h"
#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/wire/line_codec.h"
#include "tests/support/own_lines.h"

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

enum class Fault { kLost, kDoubled, kLate };
constexpr std::array kFaults = {Fault::kLost, Fault::kDoubled, Fault::kLate};

// Later than the session's patience.
constexpr Duration kLate = 8s;

struct Planned {
  std::size_t event = 0;
  Fault fault = Fault::kLost;
};

// A wire for whole lines; what is late holds up what is behind it.
struct Wire {
  std::string line;
  std::vector<std::pair<Instant, std::string>> held;
  Instant free_at{};
};

class Model {
 public:
  Model(const std::vector<Planned>& plan, std::size_t commands, std::int32_t line_number_max,
        bool from_greeting)
      : plan_(plan), counting_(from_greeting) {
    VirtualControllerOptions options;
    options.extrude_celsius_min = 0;
    options.executed = [this](const ExecutedCommand& command) {
      const std::string text(command.text);
      if (test::is_own_line(text) || text.substr(0, 4) == "G1 E") return;
      if (command.number) executed.push_back(text);
    };
    controller_ = std::make_unique<VirtualController>(options, now_);
    SessionOptions session_options;
    session_options.temperature_interval = Duration(0);
    session_options.line_number_max = line_number_max;
    session = std::make_unique<Session>(std::make_unique<MarlinDialect>(), session_options, now_);
    for (std::size_t i = 0; i < commands; ++i) {
      Move move;
      move.extruding = true;
      move.x_um = static_cast<std::int64_t>(1000 * (i + 1));
      if (i % 2 == 1) move.e_10nm = 5'000;
      commands_.emplace_back(move);
      TextBuffer buffer;
      texts.emplace_back(encode(move, buffer));
    }
  }

  // True when it ended by itself.
  bool run(Duration limit) {
    Duration pause = 10ms;
    while (now_ < Instant(limit)) {
      bool moved = false;
      if (session->state() == SessionState::kStreaming) counting_ = true;
      while (session->can_take() && next_ < commands_.size()) {
        session->take(commands_[next_++], now_);
      }
      if (session->can_take()) session->finish(now_);
      const auto output = session->output();
      if (!output.empty()) {
        const std::string bytes(reinterpret_cast<const char*>(output.data()), output.size());
        session->written(output.size(), now_);
        carry(bytes, down_);
        moved = true;
      }
      for (const std::string& line : arrived(down_)) {
        (void)controller_->input(std::as_bytes(std::span(line.data(), line.size())), now_);
      }
      controller_->advance(now_);
      std::array<std::byte, 512> buffer;
      while (const std::size_t count = controller_->output(buffer)) {
        carry(std::string(reinterpret_cast<const char*>(buffer.data()), count), up_);
        moved = true;
      }
      for (const std::string& line : arrived(up_)) {
        session->input(std::as_bytes(std::span(line.data(), line.size())), now_);
      }
      session->tick(now_);
      if (session->state() == SessionState::kFinished ||
          session->state() == SessionState::kFaulted) {
        return true;
      }
      pause = moved ? 10ms : std::min<Duration>(pause * 2, 500ms);
      now_ += pause;
    }
    return false;
  }

  std::vector<std::string> texts;
  std::vector<std::string> executed;
  std::unique_ptr<Session> session;

 private:
  void carry(const std::string& bytes, Wire& wire) {
    for (const char c : bytes) {
      wire.line.push_back(c);
      if (c != '\n') continue;
      const std::string line = std::exchange(wire.line, {});
      if (line == "\n" || !counting_) {
        wire.held.emplace_back(wire.free_at, line);
        continue;
      }
      const auto planned = std::find_if(plan_.begin(), plan_.end(),
                                        [&](const Planned& p) { return p.event == events_; });
      ++events_;
      if (planned != plan_.end()) {
        if (planned->fault == Fault::kLost) continue;
        if (planned->fault == Fault::kLate) wire.free_at = std::max(wire.free_at, now_) + kLate;
        if (planned->fault == Fault::kDoubled) wire.held.emplace_back(wire.free_at, line);
      }
      wire.held.emplace_back(wire.free_at, line);
    }
  }

  std::vector<std::string> arrived(Wire& wire) const {
    std::vector<std::string> lines;
    while (!wire.held.empty() && wire.held.front().first <= now_) {
      lines.push_back(std::move(wire.held.front().second));
      wire.held.erase(wire.held.begin());
    }
    return lines;
  }

  std::vector<Planned> plan_;
  Instant now_{};
  Wire down_;
  Wire up_;
  std::size_t events_ = 0;
  bool counting_;
  std::vector<Command> commands_;
  std::size_t next_ = 0;
  std::unique_ptr<VirtualController> controller_;
};

struct Shape {
  std::size_t commands = 3;
  std::size_t depth = 20;  // line events among which faults are placed
  std::size_t faults = 2;
  std::int32_t line_number_max = kLineNumberMax;
  bool from_greeting = false;
};

struct Counts {
  int runs = 0;
  int finished = 0;
};

std::string text_of(const std::vector<Planned>& plan) {
  std::string text;
  for (const Planned& planned : plan) {
    text += std::to_string(planned.event) + "LDT"[static_cast<std::size_t>(planned.fault)] + ' ';
  }
  return text;
}

void check_plan(const Shape& shape, const std::vector<Planned>& plan, Counts& counts) {
  Model model(plan, shape.commands, shape.line_number_max, shape.from_greeting);
  const bool ended = model.run(1h);
  ++counts.runs;
  const bool finished = model.session->state() == SessionState::kFinished;
  counts.finished += finished ? 1 : 0;
  const bool right =
      finished ? model.executed == model.texts
               : !model.session->reason().empty() && model.executed.size() <= model.texts.size() &&
                     std::equal(model.executed.begin(), model.executed.end(), model.texts.begin());
  if (ended && right) return;
  const std::string faults = text_of(plan);
  CAPTURE(faults);
  CAPTURE(model.session->reason());
  CAPTURE(model.executed.size());
  CHECK(ended);
  CHECK(right);
}

// Every plan of up to `shape.faults` faults, places rising.
void check_all(const Shape& shape, std::vector<Planned>& plan, std::size_t from, Counts& counts) {
  check_plan(shape, plan, counts);
  if (plan.size() == shape.faults) return;
  for (std::size_t event = from; event < shape.depth; ++event) {
    for (const Fault fault : kFaults) {
      plan.push_back({event, fault});
      check_all(shape, plan, event + 1, counts);
      plan.pop_back();
    }
  }
}

void check_shape(const Shape& shape, double finished_share) {
  std::vector<Planned> plan;
  Counts counts;
  check_all(shape, plan, 0, counts);
  MESSAGE(counts.runs << " orders, " << counts.finished << " finished");
  CHECK(counts.finished > counts.runs * finished_share);
}

}  // namespace

TEST_CASE("three commands, three faults among the first sixteen lines") {
  check_shape({3, 16, 3}, 0.99);
}

TEST_CASE("seven commands, two faults among the first forty lines: the window is full") {
  check_shape({7, 40, 2}, 0.99);
}

TEST_CASE("two faults from the very first word on, greeting and all") {
  check_shape({2, 30, 2, kLineNumberMax, true}, 0.9);
}

TEST_CASE("numbers that run out between faults") { check_shape({7, 40, 2, 5}, 0.9); }
