#include "firmware_link/session/life_signs.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("each answer proves what it can") {
  const Instant start{};
  LifeSigns signs(start);
  signs.bytes_heard(start + 1s);
  CHECK(signs.byte() == start + 1s);
  CHECK(signs.sense() == start);
  signs.heard(read_reply("garbage"), Meaning::kNoise, start + 2s);
  CHECK(signs.line() == start + 2s);
  CHECK(signs.sense() == start);
  signs.heard(read_reply(" T:20.0 /0.0"), Meaning::kAlive, start + 3s);
  CHECK(signs.line() == start + 2s);
  CHECK(signs.sense() == start + 3s);
  CHECK(signs.progress() == start);
  signs.heard(read_reply("echo:busy: processing"), Meaning::kWorking, start + 4s);
  CHECK(signs.progress() == start + 4s);
  signs.heard(read_reply("ok"), Meaning::kAcknowledge, start + 5s);
  CHECK(signs.progress() == start + 5s);
}

TEST_CASE("a host that stood still moves all that was heard, never past now") {
  const Instant start{};
  LifeSigns signs(start);
  CHECK(signs.turn(start + 1s) == 0s);
  signs.expect_answer(start + 1s);
  CHECK(signs.turn(start + 3s) == 0s);
  CHECK(signs.turn(start + 103s) == 100s);
  CHECK(signs.progress() == start + 101s);
  CHECK(signs.turn(start + 90s) == 0s);  // an older time changes nothing
  signs.expect_progress(start + 105s);
  CHECK(signs.turn(start + 106s) == 3s);
  CHECK(signs.progress() == start + 106s);
}
