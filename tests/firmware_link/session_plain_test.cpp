// The session with a controller of the other kind: one `ok` for each line, no numbers, nothing ever
// repeated, long silence normal.
#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <string>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session.h"

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

struct ByHand {
  Instant now{};
  Session session{std::make_unique<MarlinDialect>(), without_polls(), Instant{}};

  static SessionOptions without_polls() {
    SessionOptions options;
    options.temperature_interval = Duration(0);
    return options;
  }

  ByHand() {
    pass(3s);
    CHECK(output() == "\nN0M110*3\n");
    say("ok\n");  // to the empty line
    CHECK(output() == "N1M115*7\n");
    say("ok\nok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:?\n");
    CHECK(session.dialect_name() == "Klipper");
    CHECK(session.state() == SessionState::kConnecting);
    pass(300ms);
    CHECK(output() == "STATUS\n");
    say("// Klipper state: Ready\nok\n");
    CHECK(session.state() == SessionState::kStreaming);
    CHECK(session.firmware_name() == "Klipper");
  }
  void say(const std::string& text) {
    session.input(std::as_bytes(std::span(text.data(), text.size())), now);
  }
  void pass(Duration duration) {
    for (const Instant end = now + duration; now < end; now += 50ms) session.tick(now);
  }
  std::string output() {
    const auto span = session.output();
    std::string text(reinterpret_cast<const char*>(span.data()), span.size());
    session.written(span.size(), now);
    return text;
  }
  void take(std::int64_t x_um) {
    Move move;
    move.x_um = x_um;
    session.take(move, now);
  }
};

}  // namespace

TEST_CASE("lines go as they are, one ok each, and long silence is borne") {
  ByHand hand;
  for (int i = 1; i <= 5; ++i) hand.take(std::int64_t{1000} * i);
  CHECK_FALSE(hand.session.can_take());
  CHECK(hand.output() == "G0X1\nG0X2\nG0X3\nG0X4\n");
  hand.pass(800s);
  CHECK(hand.output().empty());
  hand.say("ok\n");
  CHECK(hand.output() == "G0X5\n");
  hand.say("ok\nok\nok\nok\n");
  hand.session.finish(hand.now);
  CHECK(hand.session.state() == SessionState::kFinished);
  CHECK(hand.session.statistics().commands_acknowledged == 5);
}

TEST_CASE("nothing is ever repeated") {
  ByHand hand;
  hand.take(1000);
  (void)hand.output();
  hand.say("Resend: 1\n");
  hand.pass(1s);
  CHECK(hand.output().empty());
  hand.pass(901s);
  CHECK(hand.output().empty());
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.reason() == "the controller has not answered for 900 s");
}

TEST_CASE("a stop drops what has not left, and waits for what has") {
  ByHand hand;
  for (int i = 1; i <= 5; ++i) hand.take(std::int64_t{1000} * i);
  (void)hand.output();
  const Command off = SetFan{};
  hand.session.stop_now({&off, 1}, hand.now);
  CHECK(hand.output().empty());
  hand.say("ok\n");
  CHECK(hand.output() == "M107\n");
  hand.say("ok\nok\nok\n");
  CHECK(hand.session.state() == SessionState::kStopping);
  hand.say("ok\n");
  CHECK(hand.session.state() == SessionState::kStopped);
  CHECK(hand.session.statistics().commands_acknowledged == 4);
}

TEST_CASE("an alarm ends the print at once") {
  ByHand hand;
  hand.take(1000);
  hand.say("!! Move out of range: 999.000 0.000 0.500 [0.000]\nok\n");
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.reason().find("Move out of range") != std::string::npos);
}
