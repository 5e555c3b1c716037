#include "host/printing/feed_throttle.h"

#include <doctest/doctest.h>

TEST_CASE("the feed sinks with what is ahead, and rises by steps") {
  host::FeedThrottle throttle;
  CHECK_EQ(throttle.percent(0, 0.5, true), 100);  // the queue has not been filled yet
  CHECK_EQ(throttle.percent(1, 10, true), 100);
  CHECK_EQ(throttle.percent(2, 3, true), 75);
  CHECK_EQ(throttle.percent(2.5, 1, true), 75);  // not yet
  CHECK_EQ(throttle.percent(3.1, 2, true), 50);
  CHECK_EQ(throttle.percent(4.2, 0, true), host::FeedThrottle::kSlowest_percent);
  CHECK_EQ(throttle.percent(5.3, 9, true), 55);
  CHECK_EQ(throttle.percent(6.4, 9, true), 85);
  CHECK_EQ(throttle.percent(7.5, 9, true), 100);
  CHECK_EQ(throttle.percent(8.6, 0.1, false), 100);  // the end is no famine
}
