#include "host/printing/bounded_queue.h"

#include <doctest/doctest.h>

#include <atomic>
#include <string>
#include <thread>

using host::BoundedQueue;

TEST_CASE("items leave in the order they came, and all of them") {
  constexpr int kItems = 50'000;
  BoundedQueue<int> queue({64, 1'000});
  std::thread geometry([&] {
    for (int i = 0; i < kItems; ++i) REQUIRE(queue.push(i, 10));
    queue.finish();
  });
  int next = 0;
  std::size_t items_most = 0, bytes_most = 0;
  while (!queue.drained()) {
    const auto level = queue.level();
    items_most = std::max(items_most, level.items);
    bytes_most = std::max(bytes_most, level.bytes);
    const auto item = queue.try_pop();
    if (!item) {
      std::this_thread::yield();
      continue;
    }
    REQUIRE_EQ(*item, next);
    ++next;
  }
  geometry.join();
  CHECK_EQ(next, kItems);
  CHECK_LE(items_most, 64);
  CHECK_LE(bytes_most, 1'000);
}

TEST_CASE("a full queue makes the filling side wait, by items and by bytes") {
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{50}}) {
    CAPTURE(bytes);
    BoundedQueue<int> queue({4, 100});
    const int room = bytes == 1 ? 4 : 2;
    std::atomic<int> pushed = 0;
    std::thread geometry([&] {
      for (int i = 0; i < room + 1; ++i) {
        if (queue.push(i, bytes)) ++pushed;
      }
    });
    while (queue.level().items < static_cast<std::size_t>(room)) std::this_thread::yield();
    // Whatever the scheduler does, no more than the room can have gone in.
    CHECK_LE(pushed.load(), room);
    CHECK_EQ(queue.level().items, static_cast<std::size_t>(room));
    CHECK_EQ(queue.try_pop(), 0);
    geometry.join();
    CHECK_EQ(pushed.load(), room + 1);
  }
}

TEST_CASE("an item larger than the whole queue goes through alone") {
  BoundedQueue<std::string> queue({4, 10});
  REQUIRE(queue.push("long", 1'000));
  CHECK_EQ(queue.level().bytes, 1'000);
  CHECK_EQ(queue.try_pop(), "long");
  CHECK_EQ(queue.level().bytes, 0);
}

TEST_CASE("closing wakes the side that waits and drops what was queued") {
  BoundedQueue<int> queue({1, 100});
  REQUIRE(queue.push(1, 1));
  std::atomic<bool> refused = false;
  std::thread geometry([&] { refused = !queue.push(2, 1); });
  queue.close();
  geometry.join();
  CHECK(refused.load());
  CHECK(queue.drained());
  CHECK_FALSE(queue.try_pop().has_value());
  CHECK_FALSE(queue.push(3, 1));
}

TEST_CASE("finished is not drained while something is left") {
  BoundedQueue<int> queue({4, 100});
  REQUIRE(queue.push(1, 1));
  queue.finish();
  CHECK_FALSE(queue.drained());
  CHECK_EQ(queue.try_pop(), 1);
  CHECK(queue.drained());
}
