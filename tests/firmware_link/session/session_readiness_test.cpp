// What Klipper says when it is not ready, shuts down, is restarted or was there before us; and how
// long a stop, a host that stood still and a complaint are borne. By hand, word for word.
#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <vector>

#include "tests/firmware_link/session/session_by_hand.h"

using namespace firmware_link;
using namespace link_test;
using namespace std::chrono_literals;

namespace {

const std::string kStartup =
    "// Printer is not ready\n// The klippy host software is attempting to connect.  Please\n"
    "// retry in a few moments.\n// Klipper state: Not ready\n!! Printer is not ready\nok\n";
const std::string kLost =
    "// Lost communication with MCU 'mcu'\n// Once the underlying issue is corrected, use the\n"
    "// \"FIRMWARE_RESTART\" command to reset the firmware, reload the\n"
    "// config, and restart the host software.\n// Printer is shutdown\n"
    "!! Lost communication with MCU 'mcu'\nok\n";

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("Klipper that starts is waited for, and it is said why") {
  SessionByHand hand;
  hand.greet_klipper(
      "// Printer is not ready\n// retry in a few moments.\n!! Printer is not ready\nok\n");
  for (int i = 0; i < 5; ++i) {
    hand.say(kStartup);
    CHECK(hand.output().empty());
    hand.pass(1100ms);
    CHECK(hand.output() == "STATUS\n");
  }
  CHECK(hand.session.state() == SessionState::kConnecting);
  CHECK(hand.told(SessionEvent::Kind::kNotReady) ==
        std::vector<std::string>{"Printer is not ready"});
  hand.say("// Klipper state: Ready\n// Klipper state: Ready\nok\n");
  CHECK(hand.session.state() == SessionState::kStreaming);
}

TEST_CASE("Klipper that does not become ready, or is shut down, ends the wait with its reason") {
  SessionByHand hand;
  hand.greet_klipper();
  SUBCASE("starts for ever") {
    for (int i = 0; i < 130 && hand.session.state() == SessionState::kConnecting; ++i) {
      hand.say(kStartup);
      hand.pass(1s);
      (void)hand.output();
    }
    CHECK(holds(hand.session.reason(), "Printer is not ready"));
    CHECK(hand.now < Instant(130s));
  }
  SUBCASE("never answers the question") {
    hand.pass(121s);
    CHECK(holds(hand.session.reason(), "did not answer whether it is ready"));
  }
  SUBCASE("shut down") {
    hand.say(kLost);
    CHECK(holds(hand.session.reason(), "\"Lost communication with MCU 'mcu'\""));
  }
  SUBCASE("an error of its configuration") {
    hand.say(
        "// Option 'x' is not valid in section 'y'\n// Printer is halted\n"
        "!! Option 'x' is not valid in section 'y'\nok\n");
    CHECK(holds(hand.session.reason(), "Option 'x' is not valid"));
  }
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(holds(hand.session.reason(), "FIRMWARE_RESTART"));
  CHECK(hand.output().empty());
  hand.stop();
  CHECK(hand.output().empty());
}

TEST_CASE("a shutdown's reason is waited for, and asked for where nothing is in flight") {
  SessionByHand hand;
  hand.open_klipper();
  bool in_flight = false;
  std::string reason = "Lost communication with MCU 'mcu'";
  SUBCASE("to a line in flight") { in_flight = true; }
  SUBCASE("to our question") {}
  SUBCASE("never") { reason = "Klipper state: Shutdown"; }
  if (in_flight) {
    hand.take(1000);
    CHECK(hand.output() == "G0X1\n");
  }
  hand.say("// Klipper state: Shutdown\n");
  CHECK(hand.output() == "\nSTATUS\n");
  CHECK_FALSE(hand.session.can_take());
  hand.pass(300ms);
  CHECK(hand.session.state() == SessionState::kStreaming);
  if (reason[0] == 'L') {
    hand.say(kLost);
  } else {
    hand.pass(900ms);
  }
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.fault_kind() == FaultKind::kHalted);
  CHECK(holds(hand.session.reason(), reason));
  CHECK(holds(hand.session.reason(), "FIRMWARE_RESTART"));
  hand.stop();
  CHECK(hand.output().empty());
}

TEST_CASE("what others ask Klipper, and its notes, are no fault") {
  SessionByHand hand;
  hand.open_klipper();
  hand.take(1000);
  (void)hand.output();
  hand.say(
      "// Klipper state: Ready\n// probe at 10.000,10.000 is z=0.100\n// Shutdown at 22:00\n"
      "echo: printer halted by nobody\n// action:notification hello\n");
  CHECK(hand.session.state() == SessionState::kStreaming);
  hand.say("// Klipper state: Disconnect\n");
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.fault_kind() == FaultKind::kReset);
}

TEST_CASE("a restart is told from a place that was lost") {
  SessionByHand hand;
  hand.open_klipper();
  hand.take(1000);
  hand.take(2000);
  (void)hand.output();
  hand.say("!! Must home axis first: 1.000 2.000 0.200 [3.000]\nok\n");
  CHECK_FALSE(hand.session.can_take());
  hand.pass(200ms);
  CHECK(hand.output().empty());
  CHECK(hand.session.state() == SessionState::kStreaming);
  SUBCASE("restarted") {
    hand.say(
        "!! Must home axis first: 2.000 2.000 0.200 [3.000]\nok\n"
        "// Klipper state: Disconnect\n");
    CHECK(hand.session.fault_kind() == FaultKind::kReset);
  }
  SUBCASE("not") {
    hand.pass(1s);
    CHECK(hand.session.fault_kind() == FaultKind::kAlarm);
    CHECK(holds(hand.session.reason(), "Must home axis first: 1.000"));
  }
}

TEST_CASE("to resume, Klipper is asked where it is, what it knows and whether it is homed") {
  SessionOptions options;
  options.ask_found_line = true;
  SessionByHand hand(options);
  hand.pass(3s);
  (void)hand.output();
  hand.say("ok\nok\n");  // numbers nothing
  hand.pass(300ms);
  (void)hand.output();
  hand.say("ok\nok\n");
  (void)hand.output();
  hand.say("ok FIRMWARE_NAME:Klipper FIRMWARE_VERSION:v0.13\n");
  hand.pass(300ms);
  CHECK(hand.output() == "STATUS\n");
  hand.say("// Klipper state: Ready\nok\n");
  CHECK(hand.output() == "M114\n");
  hand.say("X:10.500 Y:20.000 Z:5.200 E:123.456\nok\n");
  CHECK(hand.output() == "HELP\n");
  const bool forces = true;
  hand.say("// Available extended commands:\n// FIRMWARE_RESTART: Restart firmware\n");
  if (forces) hand.say("// SET_KINEMATIC_POSITION: Force a low-level kinematic position\n");
  hand.say("ok\n");
  CHECK(hand.output() == "G90\n");
  hand.say("ok\n");
  CHECK(hand.output() == "G1 Z5.201 F60\n");
  bool homed = false;
  SUBCASE("homed") {
    homed = true;
    hand.say("ok\n");
  }
  SUBCASE("not homed") { hand.say("!! Must home axis first: 10.500 20.000 5.201 [0.000]\nok\n"); }
  CHECK(hand.session.state() == SessionState::kStreaming);
  CHECK(hand.session.found_homed() == homed);
  REQUIRE(hand.session.found_position().has_value());
  CHECK(hand.session.found_position()->z_mm == 5.2);
  CHECK(hand.session.capabilities().sets_position);
}

TEST_CASE("a paused Klipper is kept awake, and nothing moves") {
  SessionOptions options;
  SessionByHand hand(options);
  hand.open_klipper();
  hand.session.hold(true, hand.now);
  int kept = 0;
  for (int i = 0; i < 600; ++i) {
    hand.pass(1s);
    const std::string sent = hand.output();
    if (sent.empty()) continue;
    CHECK(sent == "G4 P1\n");
    ++kept;
    hand.say("ok\n");
  }
  CHECK(kept > 20);
  hand.session.hold(false, hand.now);
  hand.pass(60s);
  CHECK(hand.output().empty());
}

TEST_CASE("a stop behind a long homing waits for it, on Marlin and on Klipper") {
  SessionByHand hand;
  bool marlin = true;
  bool busy = false;
  SUBCASE("Marlin, silent") {}
  SUBCASE("Marlin, busy lines") { busy = true; }
  SUBCASE("Klipper") { marlin = false; }
  if (marlin) {
    hand.open_marlin();
  } else {
    hand.open_klipper();
  }
  hand.take("G28");
  CHECK(holds(hand.output(), "G28"));
  if (busy) hand.say("echo:busy: processing\n");
  hand.stop();
  if (marlin) CHECK(holds(hand.output(), "N99999999M105*55\n"));
  for (int i = 0; i < 60; ++i) {
    hand.pass(2s);
    if (busy) hand.say("echo:busy: processing\n");
  }
  CHECK(hand.session.state() == SessionState::kStopping);
  CHECK(hand.told(SessionEvent::Kind::kStopWaits) == std::vector<std::string>{"G28"});
  if (marlin) {
    hand.say("ok\nError:Line Number is not Last Line Number+1, Last Line: 2\nResend: 3\nok\n");
  } else {
    hand.say("ok\nok B:20.0 /0.0 T0:20.0 /0.0\n");  // to the question behind it, too
  }
  hand.pass(200ms);
  CHECK(holds(hand.output(), "M107"));
  hand.say("ok\n");
  if (marlin) {
    hand.pass(200ms);
    CHECK(holds(hand.output(), "N99999999M105*55\n"));
    hand.say("Error:Line Number is not Last Line Number+1, Last Line: 3\nResend: 4\nok\n");
    hand.pass(200ms);
  }
  CHECK(hand.session.state() == SessionState::kStopped);
}

TEST_CASE("a host that stood still holds nothing against the controller") {
  SessionByHand hand;
  hand.open_marlin();
  hand.take(1000);
  (void)hand.output();
  for (int i = 0; i < 10; ++i) {
    hand.now += 300s;
    hand.session.tick(hand.now);
    CHECK(hand.output().empty());
  }
  hand.say("ok\n");
  CHECK(hand.session.state() == SessionState::kStreaming);
  CHECK(hand.session.statistics().commands_acknowledged == 1);
  CHECK(hand.session.statistics().resyncs == 0);
}

TEST_CASE("a controller with any line ends connects") {
  for (const std::string end : {"\n", "\r\n", "\n\r", "\r"}) {
    SessionByHand hand;
    hand.open_marlin(end);
  }
}

TEST_CASE("complaints about what was mended are counted, not told") {
  SessionByHand hand;
  hand.open_marlin();
  hand.take(1000);
  hand.take(2000);
  (void)hand.output();
  // Its "Last Line:" was damaged on the way, and the tail of a cut line ran.
  hand.say("Error:checksum mismatch, Last Lin 1\nResend: 2\nok\n");
  hand.say("echo:Unknown command: \"54 E0.27\"\nok\n");
  hand.pass(200ms);
  CHECK(hand.told(SessionEvent::Kind::kWarning).empty());
  CHECK(hand.session.statistics().fragments == 2);
  for (int i = 0; i < 8; ++i) {
    if (hand.output().empty()) break;
    hand.say("X:2.00 Y:0.00 Z:0.00 E:0.00 Count X:160\nok\n");
  }
  REQUIRE(hand.session.can_take());
  hand.take("M556 S1");
  CHECK(holds(hand.output(), "M556"));
  hand.say("echo:Unknown command: \"M556 S1\"\nok\n");
  hand.say("Error:volume.init failed\nok\n");
  const std::vector<std::string> told = hand.told(SessionEvent::Kind::kWarning);
  REQUIRE(told.size() == 2);
  CHECK(told[0] == "\"M556 S1\"");
  CHECK(told[1] == "volume.init failed");
}

TEST_CASE("one that does not count lines is not asked for ever") {
  SessionByHand hand;
  hand.open_marlin();
  hand.take(1000);
  (void)hand.output();
  hand.say("ok\n");
  hand.session.finish(hand.now);
  for (int i = 0; i < 30 && hand.session.state() == SessionState::kFinishing; ++i) {
    hand.pass(2s);
    if (!hand.output().empty()) hand.say("ok\nok T:20.0 /0.0\n");
  }
  CHECK(hand.session.state() == SessionState::kFaulted);
  CHECK(hand.session.reason().find("does not count lines") != std::string::npos);
}
