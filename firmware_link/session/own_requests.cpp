#include "firmware_link/session/own_requests.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "firmware_link/wire/check.h"
#include "firmware_link/wire/line_codec.h"  // write_fixed

namespace firmware_link {
namespace {

// How long nothing may be heard before temperatures are asked for, to see that it lives.
constexpr Duration kIdlePoll = std::chrono::seconds(10);

}  // namespace

std::string filament_text(std::int64_t length_10nm) {
  char text[32];
  return std::string(text, write_fixed(text, length_10nm, 5));
}

void OwnRequests::report_temperatures(Duration interval) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(interval).count();
  report_interval_s_ = std::clamp<std::int64_t>(seconds, 1, 60);
}

void OwnRequests::tick(const Sight& sight, Instant now) {
  if (sight.keep_awake.count() > 0 && holding_ && !sight.in_flight &&
      now - awake_ >= sight.keep_awake) {
    awake_ = now;
    stay_awake_ = true;
  }
  const Duration interval = sight.temperature_interval;
  if (interval.count() <= 0) return;
  const bool polls = !sight.reports_by_itself && now - polled_ >= interval;
  const bool idle = !sight.in_flight && now - std::max(sight.heard, polled_) >= kIdlePoll;
  if (!polls && !idle) return;
  polled_ = now;
  ask_temperatures_ = true;
}

bool OwnRequests::due(bool position_in_flight) const {
  return feed_percent_ || flow_percent_ || filament_10nm_ || reset_filament_ || ask_temperatures_ ||
         report_interval_s_ || stay_awake_ || (ask_position_ && !position_in_flight);
}

OwnRequests::Line OwnRequests::take(bool position_in_flight, bool count_is_new) {
  using Kind = Line::Kind;
  LINK_CHECK(due(position_in_flight));
  if (feed_percent_) {
    return {Kind::kPlain, "M220 S" + std::to_string(*std::exchange(feed_percent_, {})), {}};
  }
  if (flow_percent_) {
    return {Kind::kPlain, "M221 S" + std::to_string(*std::exchange(flow_percent_, {})), {}};
  }
  if (filament_10nm_) {
    return {Kind::kPlain, "G1 E" + filament_text(*std::exchange(filament_10nm_, {})), {}};
  }
  if (reset_filament_) {
    // Nothing goes behind it: the tail of a line cut there would run before the count starts.
    reset_filament_ = false;
    ask_position_ = true;
    return {Kind::kFilamentReset, "G92 E0", kGoesAlone};
  }
  if (ask_position_ && !position_in_flight) {
    // Where the count has just started, its `ok` is also the sign that the G92 before it was not
    // itself such a tail.
    ask_position_ = false;
    return {Kind::kPosition, "M114", count_is_new ? kGoesAlone : LineEffort{}};
  }
  if (report_interval_s_) {
    return {Kind::kPlain, "M155 S" + std::to_string(*std::exchange(report_interval_s_, {})), {}};
  }
  if (stay_awake_) {
    // Waits for a millisecond, and moves nothing.
    stay_awake_ = false;
    return {Kind::kPlain, "G4 P1", kWaitsForPlanner};
  }
  ask_temperatures_ = false;
  return {Kind::kPlain, "M105", {}};
}

void OwnRequests::drop() {
  feed_percent_.reset();
  flow_percent_.reset();
  filament_10nm_.reset();
  report_interval_s_.reset();
  reset_filament_ = ask_position_ = stay_awake_ = ask_temperatures_ = false;
}

}  // namespace firmware_link
