// A session talked to by hand, word for word, in simulated time.
#pragma once

#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/session.h"

namespace link_test {

struct SessionByHand {
  firmware_link::Instant now{};
  firmware_link::Session session;

  // Nobody asks for temperatures here.
  explicit SessionByHand(firmware_link::SessionOptions options = {})
      : session(std::make_unique<firmware_link::MarlinDialect>(), quiet(std::move(options)), now) {}

  static firmware_link::SessionOptions quiet(firmware_link::SessionOptions options) {
    options.temperature_interval = firmware_link::Duration(0);
    return options;
  }

  // Streaming, to a Marlin. `end`: how its lines end.
  void open_marlin(const std::string& end = "\n") {
    say("start" + end);
    pass(std::chrono::milliseconds(300));
    CHECK(output() == "\nN0M110*3\n");
    say("Line: 0" + end + "ok" + end);
    CHECK(output() == "N1M115*7\n");
    say("FIRMWARE_NAME:Marlin 2.1 (x) SOURCE_CODE_URL:y" + end + "Cap:EEPROM:0" + end + "ok" + end);
    CHECK(session.state() == firmware_link::SessionState::kStreaming);
  }

  // Up to the question whether it is ready. It answers the empty line before the greeting, too.
  void greet_klipper(const std::string& to_empty_line = "ok\n") {
    pass(std::chrono::seconds(3));
    CHECK(output() == "\nN0M110*3\n");
    say(to_empty_line);
    CHECK(output() == "N1M115*7\n");
    say("ok\nok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:?\n");
    CHECK(session.dialect_name() == "Klipper");
    CHECK(session.state() == firmware_link::SessionState::kConnecting);
    pass(std::chrono::milliseconds(300));
    CHECK(output() == "STATUS\n");
  }
  void open_klipper() {
    greet_klipper();
    say("// Klipper state: Ready\nok\n");
    CHECK(session.state() == firmware_link::SessionState::kStreaming);
    CHECK(session.firmware_name() == "Klipper");
  }

  void say(const std::string& text) {
    session.input(std::as_bytes(std::span(text.data(), text.size())), now);
  }

  void pass(firmware_link::Duration duration) {
    for (const firmware_link::Instant end = now + duration; now < end;
         now += std::chrono::milliseconds(10)) {
      session.tick(now);
    }
  }

  // All that is to be written, and writes it.
  std::string output() {
    const auto bytes = session.output();
    std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    session.written(bytes.size(), now);
    return text;
  }

  void take(std::int64_t x_um) {
    firmware_link::Move move;
    move.x_um = x_um;
    session.take(move, now);
  }
  void take(const std::string& line) {
    session.take(std::get<firmware_link::Verbatim>(firmware_link::verbatim_from(line)), now);
  }

  // With M107 as its safe sequence.
  void stop() {
    const firmware_link::Command off = firmware_link::SetFan{};
    session.stop_now({&off, 1}, now);
  }

  // The texts of all events of that kind; the others are dropped.
  std::vector<std::string> told(firmware_link::SessionEvent::Kind kind) {
    std::vector<std::string> texts;
    while (const auto event = session.next_event()) {
      if (event->kind == kind) texts.push_back(event->text);
    }
    return texts;
  }
};

struct MarlinByHand : SessionByHand {
  explicit MarlinByHand(firmware_link::SessionOptions options = {})
      : SessionByHand(std::move(options)) {
    open_marlin();
  }
};

struct KlipperByHand : SessionByHand {
  KlipperByHand() { open_klipper(); }
};

}  // namespace link_test
