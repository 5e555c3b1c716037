#include "firmware_link/session/heater_watch.h"

#include <doctest/doctest.h>

#include <chrono>
#include <optional>
#include <string>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("a heater that does not rise is found, one that rises slowly is not") {
  const HeaterWatchLimits limits = nozzle_watch_limits();
  HeaterWatch watch("the nozzle", limits);
  Instant now{};
  double celsius = 25;
  bool slow = false;
  SUBCASE("slow") { slow = true; }
  SUBCASE("dead") {}
  std::optional<std::string> complaint;
  for (; now < Instant(limits.rise_time * 3) && !complaint; now += 1s) {
    complaint = watch.heard(celsius, 210, now);
    if (slow) celsius += 0.05;
  }
  CHECK(complaint.has_value() != slow);
  if (complaint) {
    CHECK(now > Instant(limits.rise_time));
    CHECK(*complaint ==
          "the nozzle does not get warmer: 25.0 C where 210.0 C was asked for, over 61 s");
  }
}

TEST_CASE("a heater that loses its heat is found; a new target is no loss") {
  HeaterWatch watch("the bed", bed_watch_limits());
  Instant now{};
  const auto pass = [&](double celsius, double target, Duration time) {
    std::optional<std::string> complaint;
    for (const Instant end = now + time; now < end && !complaint; now += 1s) {
      complaint = watch.heard(celsius, target, now);
    }
    return complaint;
  };
  CHECK_FALSE(pass(60, 60, 10s));
  CHECK_FALSE(pass(50, 60, 600s));   // a draught
  CHECK_FALSE(pass(40, 60, 100s));   // a big one
  CHECK_FALSE(pass(58, 60, 10s));    // and it is over
  CHECK_FALSE(pass(58, 100, 200s));  // more is asked for
  CHECK_FALSE(pass(58, 0, 600s));    // off
  CHECK_FALSE(pass(60, 60, 10s));
  const auto complaint = pass(40, 60, 600s);
  REQUIRE(complaint.has_value());
  CHECK(complaint->find("the bed has lost its heat: 40.0 C") == 0);
}

TEST_CASE("time in which nothing was heard counts for little") {
  HeaterWatch watch("the nozzle", nozzle_watch_limits());
  CHECK_FALSE(watch.heard(25, 210, Instant(1s)));
  CHECK_FALSE(watch.heard(25.5, 210, Instant(76s)));   // the host stood still
  CHECK_FALSE(watch.heard(26, 210, Instant(3'000s)));  // and again
  CHECK_FALSE(watch.heard(26.1, 210, Instant(3'010s)));
  CHECK_FALSE(watch.heard(209, 210, Instant(3'100s)));  // reached
  CHECK_FALSE(watch.heard(150, 210, Instant(3'110s)));
  CHECK_FALSE(watch.heard(150, 210, Instant(9'000s)));
  // One that reports seldom is still found out.
  std::optional<std::string> complaint;
  Instant now(9'000s);
  for (; !complaint && now < Instant(9'400s); now += 30s) complaint = watch.heard(150, 210, now);
  CHECK(complaint.has_value());
}
