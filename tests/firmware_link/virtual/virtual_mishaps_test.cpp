#include "firmware_link/virtual/virtual_mishaps.h"

#include <doctest/doctest.h>

#include <chrono>

using namespace firmware_link;
using namespace std::chrono_literals;

TEST_CASE("a delay is for the next command with its word, once") {
  VirtualMishaps mishaps;
  mishaps.delay_next(2s, "G28");
  CHECK(mishaps.starts("G1") == 0s);
  CHECK(mishaps.starts("G28") == 2s);
  CHECK(mishaps.starts("G28") == 0s);
  mishaps.delay_next(3s, "");
  CHECK(mishaps.starts("M105") == 3s);
  mishaps.delay_next(3s, "");
  mishaps.forget_delay();
  CHECK(mishaps.starts("M105") == 0s);
}

TEST_CASE("an answer is lost to the next command with its word, once") {
  VirtualMishaps mishaps;
  mishaps.lose_answer("M105", "o\n");
  CHECK(mishaps.starts("G1") == 0s);
  CHECK_FALSE(mishaps.ends().has_value());
  CHECK(mishaps.starts("M105") == 0s);
  CHECK(mishaps.ends() == "o\n");
  CHECK(mishaps.starts("M105") == 0s);
  CHECK_FALSE(mishaps.ends().has_value());
}
