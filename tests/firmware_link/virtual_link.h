// A session and a virtual controller on two ends of a wire that damages what it carries, in
// simulated time.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/session.h"
#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/wire/line_codec.h"
#include "tests/support/own_lines.h"

namespace link_test {

using firmware_link::Command;
using firmware_link::Duration;
using firmware_link::Instant;
using firmware_link::Move;
using firmware_link::Session;
using firmware_link::SessionOptions;
using firmware_link::SessionState;
using firmware_link::Verbatim;
using firmware_link::VirtualController;
using firmware_link::VirtualControllerOptions;

// What a wire does to bytes. Damages keep a distance, because Marlin's checksum, an exclusive or,
// does not see two flips of the same bit in one line.
struct Damage {
  double lose = 0;  // probabilities for each byte
  double flip = 0;
  double duplicate = 0;
  double lose_line_end = 0;  // for each \n
  double lose_line = 0;      // for each line
  double duplicate_line = 0;
  std::size_t distance = 100;  // bytes
};

class Wire {
 public:
  Wire(const Damage& damage, std::uint64_t seed) : damage_(damage), random_(seed) {}

  [[nodiscard]] std::string carry(const std::string& bytes) {
    std::string out;
    for (const char c : bytes) {
      line_.push_back(c);
      carry_byte(c, out);
      if (c == '\n') end_line(out);
    }
    return out;
  }

  [[nodiscard]] int damages() const { return damages_; }

 private:
  bool happens(double probability) {
    if (since_ < damage_.distance || probability <= 0) return false;
    if (std::uniform_real_distribution<double>(0, 1)(random_) >= probability) return false;
    since_ = 0;
    ++damages_;
    return true;
  }

  void carry_byte(char c, std::string& out) {
    ++since_;
    if (swallowing_) return;
    if (line_.size() == 1 && happens(damage_.lose_line)) {
      swallowing_ = true;
      return;
    }
    if (happens(damage_.lose) || (c == '\n' && happens(damage_.lose_line_end))) return;
    if (happens(damage_.flip)) c = static_cast<char>(c ^ (1 << random_() % 7));
    out.push_back(c);
    if (happens(damage_.duplicate)) out.push_back(c);
  }

  void end_line(std::string& out) {
    if (!swallowing_ && happens(damage_.duplicate_line)) out += line_;
    swallowing_ = false;
    line_.clear();
  }

  Damage damage_;
  std::mt19937_64 random_;
  std::size_t since_ = 1000;
  int damages_ = 0;
  bool swallowing_ = false;
  std::string line_;
};

struct Executed {
  bool numbered;
  bool known;
  std::string text;
};

class VirtualLink {
 public:
  VirtualLink(VirtualControllerOptions options, const SessionOptions& session_options,
              const Damage& down = {}, const Damage& up = {}, std::uint64_t seed = 1)
      : down_(down, seed), up_(up, seed + 1000), session_options_(session_options) {
    options.extrude_celsius_min = 0;
    options.executed = [this](const firmware_link::ExecutedCommand& command) {
      executed.push_back({command.number.has_value(), command.known, std::string(command.text)});
    };
    controller = std::make_unique<VirtualController>(options, now);
    session = std::make_unique<Session>(std::make_unique<firmware_link::MarlinDialect>(),
                                        session_options_, now);
  }

  // Streams all commands and finishes; ends when the session has, or at the limit of simulated
  // time. Returns true when it ended by itself.
  bool run(const std::vector<Command>& commands, Duration limit) {
    const Instant end = now + limit;
    std::size_t next = 0;
    while (now < end) {
      while (session->can_take() && next < commands.size()) session->take(commands[next++], now);
      if (next == commands.size() && session->state() == SessionState::kStreaming) {
        session->finish(now);
      }
      turn();
      if (ended()) return true;
    }
    return false;
  }

  // One exchange of bytes, then time goes on.
  void turn() {
    std::string bytes;
    for (const std::byte b : session->output()) bytes.push_back(static_cast<char>(b));
    session->written(bytes.size(), now);
    to_controller(down_.carry(bytes));
    controller->advance(now);
    std::array<std::byte, 256> buffer;
    std::string answers;
    while (const std::size_t count = controller->output(buffer)) {
      for (std::size_t i = 0; i < count; ++i) answers.push_back(static_cast<char>(buffer[i]));
    }
    answers = up_.carry(answers);
    heard += answers;
    if (heard.size() > 4000) heard.erase(0, heard.size() - 2000);
    session->input(std::as_bytes(std::span(answers.data(), answers.size())), now);
    session->tick(now);
    now += std::chrono::milliseconds(5);
  }

  void to_controller(const std::string& bytes) {
    const auto span = std::as_bytes(std::span(bytes.data(), bytes.size()));
    (void)controller->input(span, now);
  }

  // What was accepted is executed behind the last byte too.
  void let_controller_work() {
    while (controller->owes_answer() && !controller->state().halted) {
      const auto next = controller->next_event();
      if (!next) break;
      now = std::max(now, *next);
      controller->advance(now);
    }
  }

  [[nodiscard]] bool ended() const {
    return session->state() == SessionState::kFinished ||
           session->state() == SessionState::kStopped || session->state() == SessionState::kFaulted;
  }

  // Numbered commands, without the link's own.
  [[nodiscard]] std::vector<std::string> printed() const {
    std::vector<std::string> texts;
    for (const Executed& one : executed) {
      if (one.numbered && !test::is_own_line(one.text)) texts.push_back(one.text);
    }
    return texts;
  }

  [[nodiscard]] int damages() const { return down_.damages() + up_.damages(); }

  Instant now{};
  std::vector<Executed> executed;
  std::string heard;
  std::unique_ptr<VirtualController> controller;
  std::unique_ptr<Session> session;

 private:
  Wire down_;
  Wire up_;
  SessionOptions session_options_;
};

inline std::vector<std::string> texts_of(const std::vector<Command>& commands) {
  std::vector<std::string> texts;
  for (const Command& command : commands) {
    firmware_link::TextBuffer buffer;
    texts.emplace_back(firmware_link::encode(command, buffer));
  }
  return texts;
}

// Short extruding moves, no two the same, with relative filament as all of rind's.
inline std::vector<Command> moves(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Command> commands;
  commands.emplace_back(std::get<Verbatim>(firmware_link::verbatim_from("M83")));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    Move move;
    move.extruding = true;
    move.x_um = 20'000 + static_cast<std::int64_t>(random() % 160'000);
    move.y_um = 20'000 + static_cast<std::int64_t>(i);
    if (random() % 2 == 0) move.e_10nm = static_cast<std::int64_t>(random() % 50'000);
    if (i == 0 || random() % 8 == 0) move.f_mm_min = 12'000;
    commands.emplace_back(move);
  }
  return commands;
}

}  // namespace link_test
