#include "firmware_link/session/send_window.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <deque>
#include <random>
#include <string>

using namespace firmware_link;

TEST_CASE("lines go, are acknowledged, come back") {
  SendWindow window;
  for (const char* text : {"A", "B", "C"}) {
    window.push(text, true);
    CHECK(window.next_text() == text);
    window.sent(20);
  }
  CHECK(window.lines_in_flight() == 3);
  CHECK(window.bytes_in_flight() == 60);
  CHECK(window.acknowledge_one());
  CHECK(window.bytes_in_flight() == 40);
  window.restart(1);
  CHECK(window.lines_in_flight() == 0);
  CHECK(window.next_text() == "B");
  window.sent(20);
  // Back behind what was acknowledged: that was false.
  CHECK(window.can_restart(0));
  window.restart(0);
  CHECK(window.acknowledged() == 0);
  CHECK(window.next_text() == "A");
  // And forward again, to what the controller turns out to have.
  CHECK(window.can_restart(3));
  CHECK_FALSE(window.can_restart(4));
  window.restart(3);
  window.acknowledge_before(3);
  CHECK(window.lines_in_flight() == 0);
  CHECK(window.bytes_in_flight() == 0);
  CHECK_FALSE(window.acknowledge_one());
  CHECK(window.all_sent());
}

TEST_CASE("what was dropped cannot come back, what was forgotten neither") {
  SendWindow window;
  window.push("A", true);
  window.sent(10);
  window.push("B", true);
  window.drop_never_sent();
  CHECK(window.all_sent());
  CHECK(window.end() == 1);
  window.push("C", true);
  CHECK(window.next_text() == "C");
  window.sent(10);
  window.restart(1);
  window.drop_unsent();
  CHECK(window.end() == 1);
  CHECK_FALSE(window.can_restart(2));
  CHECK(window.acknowledge_one());
  window.forget_acknowledged();
  CHECK_FALSE(window.can_restart(0));
}

TEST_CASE("the history holds as many lines as it says, and agrees with a simple model") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  SendWindow window;
  std::deque<std::string> all;  // every text, for ever: the model may grow
  for (int step = 0; step < 200'000; ++step) {
    switch (random() % 4) {
      case 0:
      case 1:
        if (window.all_sent()) {
          all.push_back(std::to_string(random() % 1'000'000));
          window.push(all.back(), true);
        }
        if (window.lines_in_flight() < kWindowLinesMax) window.sent(1 + random() % 30);
        break;
      case 2:
        (void)window.acknowledge_one();
        break;
      default:
        if (random() % 8 == 0) {
          const std::int64_t to =
              window.acknowledged() + static_cast<std::int64_t>(random() % 8) - 4;
          if (window.can_restart(to)) {
            window.restart(to);
            if (window.lines_in_flight() > kWindowLinesMax) window.acknowledge_before(to);
          }
        }
    }
    REQUIRE(window.end() == static_cast<std::int64_t>(all.size()));
    REQUIRE(window.end() - window.oldest() <= static_cast<std::int64_t>(kHistoryLinesMax));
    REQUIRE(window.oldest() <= window.acknowledged());
    REQUIRE(window.acknowledged() <= window.next_to_send());
    REQUIRE(window.next_to_send() <= window.end());
    REQUIRE((window.bytes_in_flight() == 0) == (window.lines_in_flight() == 0));
    if (!window.all_sent()) {
      REQUIRE(window.next_text() == all[static_cast<std::size_t>(window.next_to_send())]);
    }
  }
  CHECK(window.oldest() > 1000);
}

TEST_CASE("what a line costs stays with it, also where a question goes before it") {
  SendWindow window;
  window.push("G28", true, kWaitsForPlanner);
  CHECK_FALSE(window.lone_line_in_flight());
  window.sent(4);
  CHECK(window.lone_line_in_flight());
  LineEffort move;
  move.nominal = Duration(1'500);
  move.blocks = 3;
  window.push("G1X1", true, move);
  window.push_ahead("M105");
  CHECK(window.effort(1).nominal == Duration(0));
  CHECK(window.effort(2).nominal == Duration(1'500));
  CHECK(window.effort(2).blocks == 3);
  CHECK(window.acknowledge_one());
  CHECK_FALSE(window.lone_line_in_flight());
  CHECK(window.effort(0).empties_planner);
}

TEST_CASE("line numbers start at 1, and again at 1 when they are restarted") {
  SendWindow window;
  CHECK(window.number_of(0) == 1);
  for (int i = 0; i < 3; ++i) {
    window.push("M105", false);
    window.sent(6);
  }
  CHECK(window.number_of(window.next_to_send()) == 4);
  window.restart_numbers();
  CHECK(window.number_of(window.next_to_send()) == 1);
  CHECK(window.sequence_of(1) == window.next_to_send());
}
