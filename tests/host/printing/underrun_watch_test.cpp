#include "host/printing/underrun_watch.h"

#include <doctest/doctest.h>

using host::UnderrunWatch;
using Action = host::UnderrunWatch::Action;

namespace {

// In mid-print, with nothing to lay.
UnderrunWatch::Sight underrun() {
  UnderrunWatch::Sight sight;
  sight.streaming = true;
  sight.road_given = true;
  sight.more_to_come = true;
  sight.printing = true;
  return sight;
}

}  // namespace

TEST_CASE("the nozzle leaves when nothing was there to lay for long enough, not before") {
  UnderrunWatch watch(0.3);
  CHECK(watch.look(10, underrun()) == Action::kNone);
  CHECK(watch.look(10.2, underrun()) == Action::kNone);
  UnderrunWatch::Sight fed = underrun();
  fed.command_waits = true;
  CHECK(watch.look(10.25, fed) == Action::kNone);  // the time starts again
  CHECK(watch.look(10.4, underrun()) == Action::kNone);
  CHECK(watch.look(10.6, underrun()) == Action::kNone);
  CHECK(watch.look(10.75, underrun()) == Action::kPark);
}

TEST_CASE("it stays where leaving would be of no use") {
  for (int reason = 0; reason < 6; ++reason) {
    CAPTURE(reason);
    UnderrunWatch watch(reason == 0 ? 0 : 0.3);
    UnderrunWatch::Sight sight = underrun();
    if (reason == 1) sight.road_given = false;
    if (reason == 2) sight.all_given = true;
    if (reason == 3) sight.more_to_come = false;
    if (reason == 4) sight.printing = false;
    if (reason == 5) sight.planner_blocks = 2;
    for (const double now_s : {10.0, 11.0, 12.0}) CHECK(watch.look(now_s, sight) == Action::kNone);
  }
}

TEST_CASE("it comes back when enough has gathered, or all that will come") {
  UnderrunWatch watch(0.3);
  UnderrunWatch::Sight sight = underrun();
  sight.printing = false;
  sight.parked = true;
  sight.ahead_s = host::FeedThrottle::kAmple_s - 0.1;
  CHECK(watch.look(10, sight) == Action::kNone);
  sight.queue_half_full = true;
  CHECK(watch.look(11, sight) == Action::kComeBack);
  sight.queue_half_full = false;
  sight.ahead_s = host::FeedThrottle::kAmple_s;
  CHECK(watch.look(12, sight) == Action::kComeBack);
  sight.ahead_s = 0;
  sight.more_to_come = false;
  CHECK(watch.look(13, sight) == Action::kComeBack);
}

TEST_CASE("the feed sinks while little is ahead") {
  UnderrunWatch watch(0.3);
  UnderrunWatch::Sight sight = underrun();
  sight.command_waits = true;
  sight.ahead_s = 10;
  CHECK(watch.look(1, sight) == Action::kNone);
  CHECK_EQ(watch.feed_percent(), 100);
  sight.ahead_s = 2;
  CHECK(watch.look(3, sight) == Action::kNone);
  CHECK_EQ(watch.feed_percent(), 50);
  sight.streaming = false;
  sight.ahead_s = 1;
  CHECK(watch.look(5, sight) == Action::kNone);
  CHECK_EQ(watch.feed_percent(), 50);
}
