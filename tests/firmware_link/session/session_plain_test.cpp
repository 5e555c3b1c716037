// The session with a controller of the other kind: one `ok` for each line, no numbers, nothing ever
// repeated, long silence normal.
#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "tests/firmware_link/session/session_by_hand.h"

using namespace firmware_link;
using namespace link_test;
using namespace std::chrono_literals;

TEST_CASE("lines go as they are, one ok each, and long silence is borne") {
  KlipperByHand hand;
  for (int i = 1; i <= 5; ++i) hand.take(std::int64_t{1000} * i);
  CHECK_FALSE(hand.session.can_take());
  CHECK(hand.output() == "G0X1\nG0X2\nG0X3\nG0X4\n");
  hand.pass(800s);
  CHECK(hand.output() == "M105\nM105\nM105\nM105\n");
  hand.say("ok\n");
  CHECK(hand.output().empty());
  hand.say("ok\nok\nok\n");
  const std::string warm = "ok B:20.0 /0.0 T0:20.0 /0.0\n";
  hand.say(warm + warm + warm + warm);
  CHECK(hand.output() == "G0X5\n");
  hand.say("ok\n");
  hand.session.finish(hand.now);
  CHECK(hand.session.state() == SessionState::kFinished);
  CHECK(hand.session.statistics().commands_acknowledged == 5);
}

TEST_CASE("the answer to a question names what was answered before it") {
  KlipperByHand hand;
  for (int i = 1; i <= 3; ++i) hand.take(std::int64_t{1000} * i);
  CHECK(hand.output() == "G0X1\nG0X2\nG0X3\n");
  hand.say("ok\n");
  hand.pass(1200ms);  // its planner is empty: nothing keeps it from answering
  CHECK(hand.output() == "M105\n");
  hand.say("ok B:20.0 /0.0 T0:20.0 /0.0\n");
  CHECK(hand.session.statistics().commands_acknowledged == 3);
  CHECK(hand.session.statistics().lines_in_flight == 1);
  // Two answers are missing: lost, or the lines were.
  CHECK(hand.output() == "M114\n");
  SUBCASE("the answers") {
    hand.say("X:3.000 Y:0.000 Z:0.000 E:0.000\nok\n");
    hand.session.finish(hand.now);
    CHECK(hand.session.state() == SessionState::kFinished);
  }
  SUBCASE("the lines") {
    hand.say("X:1.000 Y:0.000 Z:0.000 E:0.000\nok\n");
    CHECK(hand.output() == "M114\n");
    hand.say("X:1.000 Y:0.000 Z:0.000 E:0.000\nok\n");
    CHECK(hand.session.fault_kind() == FaultKind::kPosition);
  }
}

TEST_CASE("a question's answer that comes late names nothing that was sent behind it") {
  KlipperByHand hand;
  const std::string warm = "ok B:20.0 /0.0 T0:20.0 /0.0\n";
  hand.take(1000);
  hand.pass(6s);
  CHECK(hand.output() == "G0X1\nM105\nM105\nM105\n");
  hand.say("ok\n" + warm);
  CHECK(hand.session.statistics().lines_in_flight == 0);
  hand.take(2000);
  hand.say(warm + warm);
  CHECK(hand.output() == "G0X2\n");
  CHECK(hand.session.statistics().lines_in_flight == 1);
  CHECK(hand.session.statistics().commands_acknowledged == 1);
}

TEST_CASE("a macro may be silent for an hour, and what is waited for is told") {
  KlipperByHand hand;
  hand.session.take(std::get<Verbatim>(verbatim_from("PRINT_START BED=60")), hand.now);
  hand.pass(3000s);
  CHECK(hand.session.state() == SessionState::kStreaming);
  bool told = false;
  while (const auto event = hand.session.next_event()) {
    told = told ||
           (event->kind == SessionEvent::Kind::kWaits && event->text == "a macro (PRINT_START)");
  }
  CHECK(told);
  hand.pass(700s);
  CHECK(hand.session.fault_kind() == FaultKind::kSilence);
}

TEST_CASE("a command that was never sent and is not known is a damaged line") {
  KlipperByHand hand;
  hand.take(1000);
  SUBCASE("another word") {
    hand.say("// Unknown command:\"E0\"\nok\n");
    CHECK(hand.session.fault_kind() == FaultKind::kPosition);
  }
  SUBCASE("a word of its user's") {
    hand.say("ok\n");
    hand.session.take(std::get<Verbatim>(verbatim_from("LINE_PURGE")), hand.now);
    hand.say("// Unknown command:\"LINE_PURGE\"\nok\n");
    CHECK(hand.session.state() == SessionState::kStreaming);
    CHECK(hand.session.statistics().warnings == 1);
  }
}

TEST_CASE("nothing is ever repeated") {
  KlipperByHand hand;
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
  KlipperByHand hand;
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
  KlipperByHand hand;
  hand.take(1000);
  hand.say("!! Move out of range: 999.000 0.000 0.500 [0.000]\nok\n");
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.reason().find("Move out of range") != std::string::npos);
}
