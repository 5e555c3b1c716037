// Watches one heater through the temperatures that a controller reports. Most firmwares have such a
// watch of their own and halt; this one is slower than theirs, for those that have none.
//
//     target    ──────────────────────────
//                          ____reached____
//                      ___/               \___  fell: more than `fall` below for `fall_time`
//     celsius  ___ ___/
//                 └── stuck: not `rise` warmer within `rise_time`, while well below the target
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "firmware_link/wire/instant.h"  // Instant

namespace firmware_link {

struct HeaterWatchLimits {
  double rise_celsius = 2;
  Duration rise_time{};
  double fall_celsius = 20;
  Duration fall_time{};
  // No rise is asked for within this of the target: there a heater only holds.
  double near_celsius = 8;
};

inline constexpr Duration kUnheardMax = std::chrono::seconds(15);

class HeaterWatch {
 public:
  // `name` as in "the nozzle". REQUIRES: it outlives the watch.
  HeaterWatch(const char* name, const HeaterWatchLimits& limits) : name_(name), limits_(limits) {}

  // A report came. Returns a sentence when the heater does not do what it was told. A time in which
  // nothing was heard (the controller was silent, or the host stood still) counts for kUnheardMax
  // at most.
  [[nodiscard]] std::optional<std::string> heard(double celsius, double target, Instant now);

  // Forgets what was seen: another target was told, or nothing was heard for long.
  void restart() { since_.reset(), reached_ = false, low_since_.reset(); }

 private:
  const char* name_;
  HeaterWatchLimits limits_;
  double target_ = 0;
  double base_celsius_ = 0;       // the warmth that the next rise is counted from
  std::optional<Instant> since_;  // when it was
  bool reached_ = false;
  std::optional<Instant> low_since_;
  std::optional<Instant> heard_at_;
};

[[nodiscard]] HeaterWatchLimits nozzle_watch_limits();
[[nodiscard]] HeaterWatchLimits bed_watch_limits();

}  // namespace firmware_link
