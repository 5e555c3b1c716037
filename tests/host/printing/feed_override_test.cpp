#include "host/printing/feed_override.h"

#include <doctest/doctest.h>

TEST_CASE("the controller is told the feed when it changes, and only then") {
  host::FeedOverride feed;
  CHECK_FALSE(feed.feed_to_tell().has_value());
  feed.change_feed(2);
  CHECK_EQ(feed.feed_to_tell(), 120);
  CHECK_FALSE(feed.feed_to_tell().has_value());
  CHECK_EQ(feed.told_feed(), 120);
  feed.set_throttle(50);
  CHECK_EQ(feed.feed_to_tell(), 60);
  CHECK_EQ(feed.requested_feed(), 120);
  feed.start_session();
  CHECK_EQ(feed.told_feed(), 100);
  CHECK_EQ(feed.feed_to_tell(), 60);
}

TEST_CASE("feed and flow stay within their limits") {
  host::FeedOverride feed;
  feed.change_feed(1'000);
  feed.change_flow(-1'000);
  CHECK_EQ(feed.requested_feed(), host::kFeedPercentMax);
  CHECK_EQ(feed.requested_flow(), host::kFeedPercentMin);
  CHECK_EQ(feed.feed_to_tell(), host::kFeedPercentMax);
  feed.change_feed(-1'000);
  feed.set_throttle(25);
  CHECK_EQ(feed.feed_to_tell(), host::kFeedPercentMin);
}
