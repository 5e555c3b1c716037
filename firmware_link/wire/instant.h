// Time as the link knows it: a monotonic count that its callers pass in. Nothing in this room but
// the ports on real devices ever looks at a clock.
#pragma once

#include <chrono>

namespace firmware_link {

using Duration = std::chrono::microseconds;

// A clock without a now(): only its type is used, so that an Instant is made on purpose, for
// example from std::chrono::steady_clock's time_since_epoch().
struct LinkClock {
  using duration = Duration;
  using rep = Duration::rep;
  using period = Duration::period;
  using time_point = std::chrono::time_point<LinkClock, Duration>;
  static constexpr bool is_steady = true;
};

using Instant = LinkClock::time_point;

}  // namespace firmware_link
