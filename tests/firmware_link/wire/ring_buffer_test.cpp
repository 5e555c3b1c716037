#include "firmware_link/wire/ring_buffer.h"

#include <doctest/doctest.h>

#include <deque>
#include <random>
#include <string>

using firmware_link::RingBuffer;

TEST_CASE("a ring does what a deque does, up to its capacity") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  RingBuffer<std::string, 5> ring;
  std::deque<std::string> expected;
  for (int i = 0; i < 2000; ++i) {
    if (random() % 2 == 0 && !ring.full()) {
      ring.push(std::to_string(i));
      expected.push_back(std::to_string(i));
    } else if (!ring.empty()) {
      CHECK(ring.pop() == expected.front());
      expected.pop_front();
    }
    if (random() % 100 == 0) {
      ring.clear();
      expected.clear();
    }
    REQUIRE(ring.size() == expected.size());
    CHECK(ring.room() == 5 - expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) CHECK(ring[k] == expected[k]);
    if (ring.empty()) continue;
    CHECK(ring.front() == expected.front());
    CHECK(ring.back() == expected.back());
  }
}
