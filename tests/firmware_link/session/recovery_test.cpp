#include "firmware_link/session/recovery.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("the ok of a refused line is skipped, unless something else came before it") {
  const Instant now{};
  Recovery recovery(now);
  CHECK_FALSE(recovery.skips_ok(now));
  recovery.refused("checksum mismatch, Last Line: 1", now);
  CHECK(recovery.skips_ok(now));
  CHECK_FALSE(recovery.skips_ok(now));
  recovery.resend_heard(true, now);
  recovery.other_heard();
  CHECK_FALSE(recovery.skips_ok(now));
  recovery.resend_heard(false, now);
  CHECK_FALSE(recovery.skips_ok(now));
}

TEST_CASE("quiet is counted from the last answer and from the last byte that left") {
  Instant now{};
  Recovery recovery(now);
  CHECK(recovery.in_step());
  recovery.resend_heard(true, now);
  recovery.wait_for_quiet();
  CHECK_FALSE(recovery.in_step());
  now += 90ms;
  (void)recovery.skips_ok(now);
  now += 90ms;
  CHECK_FALSE(recovery.quiet_over(100ms, true, now));
  recovery.bytes_left(now);
  now += 99ms;
  CHECK_FALSE(recovery.quiet_over(100ms, true, now));
  now += 1ms;
  CHECK_FALSE(recovery.quiet_over(100ms, false, now));
  CHECK(recovery.quiet_over(100ms, true, now));
  CHECK(recovery.in_step());
  CHECK_FALSE(recovery.quiet_over(100ms, true, now));
}

TEST_CASE("a forced mismatch is answered by a request, and too many without one end it") {
  Recovery recovery(Instant{});
  CHECK(recovery.asks());
  CHECK(recovery.asked());
  CHECK_FALSE(recovery.in_step());
  recovery.account_told(true);
  recovery.answered();
  CHECK(recovery.in_step());
  CHECK(recovery.confirmed());
  recovery.line_sent();
  CHECK_FALSE(recovery.confirmed());
  int asked = 0;
  while (recovery.asks()) ++asked;
  CHECK(asked == 16);
  recovery.account_told(false);
  CHECK(recovery.asks());
}

TEST_CASE("resynchronisations in a row end with an ok or an account of all lines") {
  Recovery recovery(Instant{});
  recovery.resynchronises();
  recovery.resynchronises();
  CHECK(recovery.resynchronisations_in_a_row() == 2);
  SUBCASE("an ok") { recovery.ok_heard(); }
  SUBCASE("a sign of work") { recovery.work_seen(); }
  SUBCASE("an account") { recovery.account_told(true); }
  CHECK(recovery.resynchronisations_in_a_row() == 0);
  CHECK(recovery.asks());
  recovery.resynchronises();
  recovery.resynchronises();
  recovery.ok_heard();
  CHECK(recovery.resynchronisations_in_a_row() == 1);  // the one that waits for its answer
}

TEST_CASE("a line may be refused so many times, a later line starts the count again") {
  Recovery recovery(Instant{});
  for (int i = 0; i < 10; ++i) CHECK(recovery.repeats(7, 10));
  CHECK(recovery.one_line_at_a_time());
  CHECK(recovery.repeats(8, 10));
  for (int i = 0; i < 9; ++i) CHECK(recovery.repeats(7, 10));
  CHECK_FALSE(recovery.repeats(7, 10));
  CHECK(recovery.repeats_of_a_line() == 11);
  recovery.numbers_restarted();
  CHECK(recovery.repeats(0, 10));
}

TEST_CASE("a doubted request is ignored, asked for again, or shows that the count has jumped") {
  const Instant now{};
  Recovery recovery(now);
  CHECK(recovery.doubt(std::nullopt) == Recovery::Doubt::kIgnore);
  CHECK(recovery.doubt(99) == Recovery::Doubt::kIgnore);
  recovery.refused("…, Last Line: 98", now);
  CHECK(recovery.doubt(99) == Recovery::Doubt::kAskAgain);
  recovery.wait_for_quiet();
  recovery.refused("…, Last Line: 98", now);
  CHECK(recovery.doubt(99) == Recovery::Doubt::kIgnore);
  recovery.refused("…, Last Line: 98", now);
  CHECK(recovery.doubt(99) == Recovery::Doubt::kCounterJumped);
}

TEST_CASE("frequent requests are told once, when enough lines were sent to say so") {
  Recovery recovery(Instant{});
  CHECK_FALSE(recovery.tells_frequent(99, 0.5));
  CHECK_FALSE(recovery.tells_frequent(100, 0.09));
  CHECK(recovery.tells_frequent(100, 0.1));
  CHECK_FALSE(recovery.tells_frequent(1000, 0.5));
}
