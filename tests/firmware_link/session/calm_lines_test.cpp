#include "firmware_link/session/calm_lines.h"

#include <doctest/doctest.h>

using firmware_link::CalmLines;

namespace {

// How many lines go alone from now on, at most 10,000.
int lone_lines(CalmLines& calm) {
  int count = 0;
  for (; calm.alone() && count < 10'000; ++count) calm.line_went_well();
  return count;
}

}  // namespace

TEST_CASE("a refused line makes eight go alone, one refused again soon twice as many") {
  CalmLines calm;
  CHECK_FALSE(calm.alone());
  calm.refused(5);
  CHECK(lone_lines(calm) == 8);
  calm.refused(5 + 31);
  CHECK(lone_lines(calm) == 16);
  calm.refused(36 + 64);  // no longer soon
  CHECK(lone_lines(calm) == 8);
}

TEST_CASE("the number of lone lines has a bound") {
  CalmLines calm;
  for (int i = 0; i < 30; ++i) calm.refused(i);
  CHECK(lone_lines(calm) == 4096);
}

TEST_CASE("another dialect's rules end it") {
  CalmLines calm;
  calm.refused(1);
  calm.forget();
  CHECK_FALSE(calm.alone());
}
