#include "core/ring_buffer.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <utility>

using core::RingBuffer;

TEST_CASE("an empty ring gives nothing") {
  RingBuffer<int> ring(3);
  CHECK(ring.empty());
  CHECK_FALSE(ring.full());
  CHECK_EQ(ring.pop(), std::nullopt);
}

TEST_CASE("a ring without places is empty and full") {
  RingBuffer<int> ring(0);
  CHECK(ring.empty());
  CHECK(ring.full());
  CHECK_EQ(ring.pop(), std::nullopt);
}

TEST_CASE("a ring agrees with a deque, for every capacity and any order of calls") {
  for (std::size_t capacity = 1; capacity <= 9; ++capacity) {
    CAPTURE(capacity);
    std::mt19937 random(static_cast<unsigned>(capacity));
    RingBuffer<int> ring(capacity);
    std::deque<int> expected;
    for (int step = 0; step < 2'000; ++step) {
      if (random() % 2 == 0 && !ring.full()) {
        ring.push(step);
        expected.push_back(step);
      } else if (const std::optional<int> oldest = ring.pop()) {
        REQUIRE_FALSE(expected.empty());
        REQUIRE_EQ(*oldest, expected.front());
        expected.pop_front();
      }
      REQUIRE_EQ(ring.size(), expected.size());
      REQUIRE_EQ(ring.full(), expected.size() == capacity);
      for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE_EQ(ring[i], expected[i]);
    }
  }
}

TEST_CASE("what has been taken out is no longer held") {
  RingBuffer<std::shared_ptr<int>> ring(2);
  auto value = std::make_shared<int>(7);
  ring.push(value);
  CHECK_EQ(value.use_count(), 2);
  CHECK_EQ(*ring.pop().value(), 7);
  CHECK_EQ(value.use_count(), 1);
}

TEST_CASE("values that can only be moved pass through") {
  RingBuffer<std::unique_ptr<int>> ring(1);
  ring.push(std::make_unique<int>(5));
  std::optional<std::unique_ptr<int>> taken = ring.pop();
  REQUIRE(taken.has_value());
  CHECK_EQ(**taken, 5);
}
