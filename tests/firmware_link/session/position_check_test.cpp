#include "firmware_link/session/position_check.h"

#include <doctest/doctest.h>

using namespace firmware_link;
using Outcome = PositionCheck::Outcome;

namespace {

struct Bench {
  PositionCheck check;
  std::int64_t line = 0;

  Bench() {
    check.watch().gave_filament_reset();
    Move move;
    move.x_um = 10'000;
    move.e_10nm = 100'000;
    check.watch().gave(move);
  }

  // Asks, and acknowledges the question with this answer.
  PositionCheck::Result ask(const char* answer) {
    check.asked(++line, false);
    if (answer != nullptr) check.told(read_reply(answer).position);
    CHECK(check.settle(line).outcome == Outcome::kNone);
    return check.settle(line + 1);
  }
};

constexpr const char* kRight = "X:10.00 Y:0.00 Z:0.00 E:1.00 Count";
constexpr const char* kElsewhere = "X:11.00 Y:0.00 Z:0.00 E:1.00 Count";
constexpr const char* kMoreFilament = "X:10.00 Y:0.00 Z:0.00 E:1.20 Count";

}  // namespace

TEST_CASE("an account that agrees settles it") {
  Bench bench;
  CHECK(bench.ask(kElsewhere).outcome == Outcome::kAskAgain);
  CHECK(bench.check.confirming());
  const auto result = bench.ask(kRight);
  CHECK(result.outcome == Outcome::kAgrees);
  CHECK(result.told);
  CHECK_FALSE(bench.check.confirming());
  CHECK_FALSE(bench.check.in_flight().has_value());
}

TEST_CASE("a difference is believed when it is told twice in a row") {
  Bench bench;
  SUBCASE("position") {
    CHECK(bench.ask(kElsewhere).outcome == Outcome::kAskAgain);
    const auto result = bench.ask(kElsewhere);
    CHECK(result.outcome == Outcome::kPositionDiffers);
    CHECK(result.words == "at X11.00 Y0.00 Z0.00, not X10.00");
  }
  SUBCASE("filament") {
    CHECK(bench.ask(kMoreFilament).outcome == Outcome::kAskAgain);
    const auto result = bench.ask(kMoreFilament);
    CHECK(result.outcome == Outcome::kFilamentDiffers);
    CHECK(result.excess_10nm == 20'000);
  }
  SUBCASE("not when another answer, or none, comes between") {
    CHECK(bench.ask(kElsewhere).outcome == Outcome::kAskAgain);
    CHECK(bench.ask(kMoreFilament).outcome == Outcome::kAskAgain);
    CHECK(bench.ask(kElsewhere).outcome == Outcome::kAskAgain);
    CHECK_FALSE(bench.ask(nullptr).told);
    CHECK(bench.ask(kElsewhere).outcome == Outcome::kAskAgain);
  }
}

TEST_CASE("answers that differ each time are given up after eight") {
  Bench bench;
  for (int i = 0; i < 7; ++i) {
    CHECK(bench.ask(i % 2 == 0 ? kElsewhere : kMoreFilament).outcome == Outcome::kAskAgain);
  }
  CHECK(bench.ask(kMoreFilament).outcome == Outcome::kUnconfirmed);
  CHECK_FALSE(bench.check.confirming());
}

TEST_CASE("a question moves back behind another line; a repeated one has no answer yet") {
  Bench bench;
  bench.check.asked(5, false);
  bench.check.moved_back(4);
  CHECK(bench.check.in_flight() == 5);
  bench.check.moved_back(5);
  CHECK(bench.check.in_flight() == 6);
  bench.check.told(read_reply(kRight).position);
  bench.check.repeated_from(7);
  bench.check.repeated_from(6);
  CHECK_FALSE(bench.check.settle(7).told);
}

TEST_CASE("heights are not compared where their user may shift them") {
  Bench bench;
  Move move;
  move.z_um = 200;
  bench.check.watch().gave(move);
  bench.check.asked(1, true);
  bench.check.told(read_reply("X:10.00 Y:0.00 Z:0.30 E:1.00").position);
  CHECK(bench.check.settle(2).outcome == Outcome::kAgrees);
}

TEST_CASE("the count of filament gets coarse after 100 mm, and a stop forgets all doubts") {
  Bench bench;
  CHECK_FALSE(bench.check.count_is_coarse());
  Move move;
  move.e_10nm = 10'000'000;
  bench.check.watch().gave(move);
  CHECK(bench.check.count_is_coarse());
  CHECK(bench.ask(kElsewhere).outcome == Outcome::kAskAgain);
  bench.check.asked(9, false);
  bench.check.drop();
  CHECK_FALSE(bench.check.confirming());
  CHECK_FALSE(bench.check.in_flight().has_value());
}
