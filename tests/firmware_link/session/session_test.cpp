#include "firmware_link/session/session.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>

#include "tests/firmware_link/session/session_by_hand.h"
#include "tests/firmware_link/virtual_link.h"

using namespace firmware_link;
using namespace link_test;
using namespace std::chrono_literals;

TEST_CASE("a clean wire: every command once and in order, window kept, nothing repeated") {
  VirtualControllerOptions options;
  options.baud = 250000;
  options.command_cost = 1ms;
  VirtualLink link(options, {});
  const auto commands = moves(300, 5);
  REQUIRE(link.run(commands, 600s));
  CHECK(link.session->state() == SessionState::kFinished);
  CHECK(link.printed() == texts_of(commands));
  const SessionStatistics statistics = link.session->statistics();
  CHECK(statistics.commands_sent == 300);
  CHECK(statistics.commands_acknowledged == 300);
  CHECK(statistics.lines_repeated == 0);
  CHECK(statistics.resyncs == 0);
  CHECK(statistics.lines_in_flight_max == kWindowLinesMax);
  CHECK(statistics.bytes_in_flight_max <= kWindowBytesMax);
  CHECK(link.controller->totals().receive_bytes_lost == 0);
  CHECK(link.session->firmware_name() == "Marlin bugfix-2.1.x (Oct 12 2024 00:00:00)");
}

TEST_CASE("a mute controller is a fault with a reason, in bounded time") {
  Session session(std::make_unique<MarlinDialect>(), {}, Instant{});
  Instant now{};
  for (; session.state() == SessionState::kConnecting && now < Instant(60s); now += 20ms) {
    session.tick(now);
    session.written(session.output().size(), now);
  }
  CHECK(session.state() == SessionState::kFaulted);
  CHECK(session.reason().find("no answer from the controller") == 0);
}

TEST_CASE("long handlers keep the session waiting, not failing") {
  VirtualLink link({}, {});
  std::vector<Command> commands;
  commands.emplace_back(std::get<Verbatim>(verbatim_from("G28")));
  commands.emplace_back(SetTemperature{Heater::kBed, 600, true});
  commands.emplace_back(SetTemperature{Heater::kNozzle, 2150, true});
  commands.emplace_back(std::get<Verbatim>(verbatim_from("G4 S30")));
  REQUIRE(link.run(commands, 300s));
  CHECK(link.session->state() == SessionState::kFinished);
  CHECK(link.printed() == texts_of(commands));
  CHECK(link.session->statistics().resyncs == 0);
  CHECK(*link.session->statistics().temperatures.nozzle_target_celsius == doctest::Approx(215));
}

TEST_CASE("a Resend is obeyed inside the history, its ok is no acknowledgement") {
  MarlinByHand hand;
  hand.take(1000);
  hand.take(2000);
  hand.take(3000);
  CHECK(hand.output() == "N2G0X1*98\nN3G0X2*96\nN4G0X3*102\n");
  hand.say("ok\nError:checksum mismatch, Last Line: 2\nResend: 3\nok\n");
  CHECK(hand.session.statistics().commands_acknowledged == 1);
  CHECK(hand.session.statistics().lines_in_flight == 0);
  CHECK(hand.output().empty());
  hand.pass(80ms);
  CHECK(hand.output().empty());
  hand.pass(100ms);
  // One line only until all is calm again.
  CHECK(hand.output() == "N3G0X2*96\n");
  hand.say("ok\n");
  CHECK(hand.output() == "N4G0X3*102\n");
  CHECK(hand.session.statistics().resends == 1);
  CHECK(hand.session.statistics().lines_repeated == 2);
}

TEST_CASE("a Resend for what is forgotten or was never sent changes nothing") {
  MarlinByHand hand;
  hand.take(1000);
  (void)hand.output();
  for (const char* number : {"7", "99999999", "123456789012345678901234567890", "-4", "x", ""}) {
    CAPTURE(number);
    hand.say(std::string("Resend: ") + number + "\nok\n");
  }
  CHECK(hand.session.statistics().resends_ignored == 6);
  CHECK(hand.session.statistics().lines_in_flight == 1);
  hand.pass(200ms);
  CHECK(hand.output().empty());
  hand.say("ok\n");
  CHECK(hand.session.statistics().commands_acknowledged == 1);
}

TEST_CASE("a garbled Resend far back, and the true one behind it, leave nothing in flight") {
  MarlinByHand hand;
  for (int i = 0; i < 40; ++i) {
    hand.take(1000 + i);
    (void)hand.output();
    hand.say("ok\n");
  }
  hand.say("Resend: 36\nok\n");
  CHECK(hand.session.statistics().commands_acknowledged == 34);
  hand.say("Resend: 42\nok\n");
  CHECK(hand.session.statistics().lines_in_flight == 0);
  CHECK(hand.session.statistics().commands_acknowledged == 40);
}

TEST_CASE("an account that cannot be true, three times in a row, is a counter that has jumped") {
  MarlinByHand hand;
  for (int i = 0; i < 40; ++i) {
    hand.take(1000 + i);
    (void)hand.output();
    hand.say("ok\n");
  }
  hand.take(2000);
  (void)hand.output();
  for (int i = 0; i < 3; ++i) {
    CHECK(hand.session.state() == SessionState::kStreaming);
    hand.say("Error:Line Number is not Last Line Number+1, Last Line: 14\nResend: 15\nok\n");
    hand.pass(2s);
  }
  CHECK(hand.session.fault_kind() == FaultKind::kRefusals);
  CHECK(hand.session.reason() ==
        "the controller says that it has had 14 lines of 42: it was reset, or counts wrong");
}

TEST_CASE("a false ok is uncovered by the Resend that follows it") {
  MarlinByHand hand;
  hand.take(1000);
  (void)hand.output();
  hand.say("echo:Unknown command: \"n2 G0 X1*103\"\nok\n");
  hand.take(2000);
  CHECK(hand.output() == "N3G0X2*96\n");
  hand.say("Error:Line Number is not Last Line Number+1, Last Line: 1\nResend: 2\nok\n");
  CHECK(hand.session.statistics().commands_acknowledged == 0);
  hand.pass(200ms);
  CHECK(hand.output() == "N2G0X1*98\n");
  // Nobody sent what it complained of: it is counted, and not told.
  CHECK(hand.session.statistics().fragments == 1);
  CHECK(hand.session.statistics().warnings == 0);
}

TEST_CASE("silence is met by a forced mismatch, and its answer settles what was lost") {
  MarlinByHand hand;
  hand.take(1000);
  (void)hand.output();
  SUBCASE("the ok was lost") {
    hand.pass(1500ms);  // its planner is empty: nothing keeps it from answering
    CHECK(hand.output() == "\nN99999999M105*55\n");
    hand.say("Error:Line Number is not Last Line Number+1, Last Line: 2\nResend: 3\nok\n");
    hand.pass(200ms);
    CHECK(hand.output().empty());
    CHECK(hand.session.statistics().commands_acknowledged == 1);
    CHECK(hand.session.statistics().lines_repeated == 0);
  }
  SUBCASE("the line was lost") {
    hand.pass(1500ms);  // its planner is empty: nothing keeps it from answering
    CHECK(hand.output() == "\nN99999999M105*55\n");
    hand.say("Error:Line Number is not Last Line Number+1, Last Line: 1\nResend: 2\nok\n");
    hand.pass(200ms);
    CHECK(hand.output() == "N2G0X1*98\n");
  }
  SUBCASE("busy lines are no silence") {
    for (int i = 0; i < 20; ++i) {
      hand.say("echo:busy: processing\n");
      hand.pass(2s);
    }
    CHECK(hand.output().empty());
  }
  SUBCASE("temperatures alone hide a lost ok, so it is asked for; they are believed for minutes") {
    const auto talk = [&](int seconds) {
      for (int i = 0; i < seconds; ++i) {
        hand.pass(1s);
        hand.say(" T:199.00 /200.00 B:20.00 /0.00 @:127 B@:0\n");
      }
    };
    talk(90);
    const std::string asked = "\nN99999999M105*55\n";
    CHECK(hand.output() == asked + asked + asked + asked + asked);
    CHECK(hand.session.state() == SessionState::kStreaming);
    talk(600);
    CHECK(hand.session.fault_kind() == FaultKind::kSilence);
  }
  SUBCASE("no answer at all is a fault") {
    hand.pass(60s);
    CHECK(hand.session.state() == SessionState::kFaulted);
    CHECK(hand.session.reason() == "the controller has not answered for 30 s");
  }
}

TEST_CASE("a line that is refused again and again is a fault with the controller's words") {
  MarlinByHand hand;
  hand.take(1000);
  int sent = 0;
  for (; hand.session.state() == SessionState::kStreaming && sent < 50; ++sent) {
    CHECK(hand.output() == "N2G0X1*98\n");
    hand.say("Error:checksum mismatch, Last Line: 1\nResend: 2\nok\n");
    hand.pass(200ms);
  }
  CHECK(sent == 11);
  CHECK(hand.session.reason() ==
        "the controller refused line 2 11 times: \"checksum mismatch, Last Line: 1\"");
}

TEST_CASE("a reset and a kill in mid-print are faults") {
  MarlinByHand hand;
  hand.take(1000);
  (void)hand.output();
  SUBCASE("reset") {
    hand.say("start\n");
    CHECK(hand.session.reason().find("was reset in mid-print") != std::string::npos);
  }
  SUBCASE("kill") {
    hand.say("Error:Heating failed, system stopped! Heater_ID: 0\n");
    CHECK(hand.session.reason() ==
          "the controller stopped: \"Heating failed, system stopped! Heater_ID: 0\"");
  }
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK_FALSE(hand.session.can_take());
  // A controller that has reset or halted has its heaters off; nothing is sent to it.
  const Command off = SetTemperature{};
  hand.session.stop_now({&off, 1}, hand.now);
  CHECK(hand.output().empty());
}

TEST_CASE("other errors are warnings") {
  MarlinByHand hand;
  hand.take(1000);
  hand.say("Error:G2/G3 bad parameters\nok\n");
  CHECK(hand.session.state() == SessionState::kStreaming);
  CHECK(hand.session.statistics().warnings == 1);
  CHECK(hand.told(SessionEvent::Kind::kWarning) ==
        std::vector<std::string>{"G2/G3 bad parameters"});
}

TEST_CASE("ADVANCED_OK's number acknowledges all up to it, so that a lost ok costs nothing") {
  MarlinByHand hand;
  for (int i = 1; i <= 3; ++i) hand.take(std::int64_t{1000} * i);
  (void)hand.output();
  hand.say("ok N4 P12 B3\n");
  CHECK(hand.session.statistics().commands_acknowledged == 3);
  hand.say("ok N3 P12 B3\n");
  CHECK(hand.session.statistics().stray_acknowledgements == 1);
}

TEST_CASE("a stop drops what has not been accepted and turns the heaters off") {
  VirtualControllerOptions options;
  options.baud = 115200;
  VirtualLink link(options, {});
  const auto commands = moves(400, 9);
  std::size_t next = 0;
  while (next < 200) {
    while (link.session->can_take() && next < 200) link.session->take(commands[next++], link.now);
    link.turn();
  }
  const std::vector<Command> safe = {SetTemperature{Heater::kNozzle, 0, false},
                                     SetTemperature{Heater::kBed, 0, false}, SetFan{}};
  link.session->stop_now(safe, link.now);
  CHECK_FALSE(link.session->can_take());
  const Instant asked = link.now;
  while (!link.ended() && link.now < asked + 60s) link.turn();
  CHECK(link.session->state() == SessionState::kStopped);
  auto printed = link.printed();
  REQUIRE(printed.size() > 3);
  const std::vector<std::string> last(printed.end() - 3, printed.end());
  CHECK(last == std::vector<std::string>{"M104 S0", "M140 S0", "M107"});
  const auto all = texts_of(commands);
  printed.resize(printed.size() - 3);
  CHECK(printed == std::vector<std::string>(
                       all.begin(), all.begin() + static_cast<std::ptrdiff_t>(printed.size())));
  CHECK(static_cast<std::int64_t>(printed.size()) ==
        link.session->statistics().commands_acknowledged);
}

TEST_CASE("a stop of a session that has lost its controller still tries, unnumbered") {
  MarlinByHand hand;
  hand.take(1000);
  (void)hand.output();
  hand.pass(60s);
  REQUIRE(hand.session.state() == SessionState::kFaulted);
  const Command off[] = {SetTemperature{Heater::kNozzle, 0, false}, SetFan{}};
  hand.session.stop_now(off, hand.now);
  CHECK(hand.output() == "\nM104 S0\nM107\nM105\n");
}

TEST_CASE("a stop that nobody acknowledges ends by its own limit") {
  MarlinByHand hand;
  hand.take(1000);
  (void)hand.output();
  const Command off = SetTemperature{};
  hand.session.stop_now({&off, 1}, hand.now);
  for (int i = 0; i < 620; ++i) {
    if (i == 590) CHECK(hand.session.state() == SessionState::kStopping);
    hand.say("echo:busy: processing\n");
    hand.pass(1s);
  }
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.reason().find("did not acknowledge the stop") != std::string::npos);
}

TEST_CASE("a Resend soon after another makes the narrow window last twice as long") {
  MarlinByHand hand;
  std::int64_t line = 1;  // accepted last
  // Lines that go well one at a time until two are in flight.
  const auto narrow_lines = [&] {
    (void)hand.output();
    hand.say("Error:checksum mismatch, Last Line: " + std::to_string(line) +
             "\nResend: " + std::to_string(line + 1) + "\nok\n");
    hand.pass(200ms);
    int lines = 0;
    for (; lines < 100; ++lines) {
      while (hand.session.can_take()) hand.take(1000);
      if (hand.session.statistics().lines_in_flight > 1) break;
      // Each refused line may be followed by a question of the link's own.
      hand.say(hand.output().find("M114") == std::string::npos ? "ok\n" : "X:1.00 E:0.00\nok\n");
      ++line;
    }
    return lines;
  };
  hand.take(1000);
  CHECK(narrow_lines() == 8);
  CHECK(narrow_lines() == 16);
  CHECK(narrow_lines() == 32);
}

TEST_CASE("line numbers start again when they run out") {
  SessionOptions options;
  options.line_number_max = 50;
  VirtualLink link({}, options);
  const auto commands = moves(333, 3);
  REQUIRE(link.run(commands, 600s));
  CHECK(link.session->state() == SessionState::kFinished);
  CHECK(link.printed() == texts_of(commands));
  CHECK(link.controller->state().last_line <= 50);
}
