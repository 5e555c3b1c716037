#include "firmware_link/session/own_requests.h"

#include <doctest/doctest.h>

#include <chrono>
#include <string>
#include <vector>

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

std::vector<std::string> all_due(OwnRequests& requests) {
  std::vector<std::string> texts;
  while (requests.due(false)) texts.push_back(requests.take(false, false).text);
  return texts;
}

}  // namespace

TEST_CASE("each request is said once, the most pressing first, and the last of a kind counts") {
  OwnRequests requests;
  CHECK_FALSE(requests.due(false));
  requests.report_temperatures(2s);
  requests.ask_position();
  requests.correct_filament(-12'300);
  requests.set_flow_percent(95);
  requests.set_feed_percent(50);
  requests.set_feed_percent(80);
  CHECK(all_due(requests) ==
        std::vector<std::string>{"M220 S80", "M221 S95", "G1 E-0.123", "M114", "M155 S2"});
}

TEST_CASE("where the count of filament starts, both lines go alone") {
  OwnRequests requests;
  requests.reset_filament();
  const auto reset = requests.take(false, false);
  CHECK(reset.kind == OwnRequests::Line::Kind::kFilamentReset);
  CHECK(reset.text == "G92 E0");
  CHECK(reset.effort.goes_alone);
  const auto question = requests.take(false, true);
  CHECK(question.kind == OwnRequests::Line::Kind::kPosition);
  CHECK(question.effort.goes_alone);
  requests.ask_position();
  CHECK_FALSE(requests.take(false, false).effort.goes_alone);
}

TEST_CASE("one question for the position is in flight at a time") {
  OwnRequests requests;
  requests.ask_position();
  CHECK_FALSE(requests.due(true));
  requests.set_feed_percent(70);
  CHECK(requests.take(true, false).text == "M220 S70");
  CHECK_FALSE(requests.due(true));
  CHECK(requests.due(false));
  requests.drop();
  CHECK_FALSE(requests.due(false));
}

TEST_CASE("temperatures are asked for by the interval, or when nothing was heard for long") {
  Instant now{};
  OwnRequests requests;
  requests.start(now);
  OwnRequests::Sight sight;
  sight.temperature_interval = 2s;
  std::vector<int> asked_at_s;
  for (int second = 1; second <= 30; ++second) {
    now += 1s;
    if (second == 12) sight.heard = now;
    requests.tick(sight, now);
    if (all_due(requests) == std::vector<std::string>{"M105"}) asked_at_s.push_back(second);
    sight.reports_by_itself = second >= 5;
  }
  CHECK(asked_at_s == std::vector<int>{2, 4, 22});
  sight.temperature_interval = 0s;
  requests.tick(sight, now + 1h);
  CHECK_FALSE(requests.due(false));
}

TEST_CASE("a paused print is kept awake while nothing is in flight") {
  Instant now{};
  OwnRequests requests;
  OwnRequests::Sight sight;
  sight.keep_awake = 20s;
  int kept = 0;
  for (int second = 0; second < 100; ++second) {
    now += 1s;
    requests.hold(second >= 10);
    sight.in_flight = second >= 60 && second < 90;
    requests.tick(sight, now);
    for (const std::string& text : all_due(requests)) kept += text == "G4 P1" ? 1 : 0;
  }
  CHECK(kept == 4);
}
