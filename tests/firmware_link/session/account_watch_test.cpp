#include "firmware_link/session/account_watch.h"

#include <doctest/doctest.h>

#include <string>

using firmware_link::AccountWatch;

namespace {

// Both lines of an account; true when the count of lines is taken to have jumped.
bool account(AccountWatch& watch, int last, int asked) {
  watch.refused("Line Number is not Last Line Number+1, Last Line: " + std::to_string(last));
  return watch.impossible(asked);
}

}  // namespace

TEST_CASE("the same impossible account three times in a row is believed") {
  AccountWatch watch;
  CHECK_FALSE(account(watch, 14, 15));
  CHECK(watch.ask_again());
  CHECK_FALSE(account(watch, 14, 15));
  CHECK(account(watch, 14, 15));
}

TEST_CASE("what differs, or a possible account between, starts the count again") {
  AccountWatch watch;
  CHECK_FALSE(account(watch, 14, 15));
  CHECK_FALSE(account(watch, 14, 15));
  SUBCASE("another number") { CHECK_FALSE(account(watch, 24, 25)); }
  SUBCASE("a possible account") { watch.possible(); }
  CHECK_FALSE(account(watch, 14, 15));
  CHECK_FALSE(account(watch, 14, 15));
  CHECK(account(watch, 14, 15));
}

TEST_CASE("an account whose two lines differ, or that has one line only, is damaged") {
  AccountWatch watch;
  for (int i = 0; i < 10; ++i) {
    CHECK_FALSE(account(watch, 14, 16));
    CHECK_FALSE(watch.impossible(17));
    CHECK_FALSE(watch.ask_again());
  }
  watch.refused("checksum mismatch");
  CHECK_FALSE(watch.impossible(15));
}

TEST_CASE("it is not asked again for ever") {
  AccountWatch watch;
  int asked = 0;
  for (int i = 0; i < 50; ++i) {
    CHECK_FALSE(account(watch, 100 + i, 101 + i));
    asked += watch.ask_again() ? 1 : 0;
  }
  CHECK(asked == 8);
}
