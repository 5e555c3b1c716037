#include "firmware_link/virtual/virtual_line_numbers.h"

#include <doctest/doctest.h>

#include <string>

#include "firmware_link/wire/line_codec.h"

using namespace firmware_link;
using Verdict = VirtualLineNumbers::Verdict;

namespace {

std::string numbered(int number, const char* text) {
  LineBuffer buffer;
  return std::string(number_line(number, text, buffer));
}

}  // namespace

TEST_CASE("the next number with a right checksum is accepted, no other") {
  VirtualLineNumbers numbers;
  CHECK(numbers.check(numbered(1, "M105"), true) == Verdict::kAccepted);
  CHECK(numbers.last() == 1);
  CHECK(numbers.check(numbered(3, "M105"), true) == Verdict::kNumber);
  CHECK(numbers.check("N2 M105", true) == Verdict::kNoChecksum);
  CHECK(numbers.check("N2 M105*1", true) == Verdict::kChecksum);
  CHECK(numbers.last() == 1);
  CHECK(words_of(Verdict::kChecksum) == "checksum mismatch");
}

TEST_CASE("the last two numbers are met with silence, where the firmware does so") {
  VirtualLineNumbers numbers;
  numbers.set_last(7);
  for (const int number : {6, 7}) {
    CHECK(numbers.check(numbered(number, "M105"), true) == Verdict::kSilent);
    CHECK(numbers.check(numbered(number, "M105"), false) == Verdict::kNumber);
  }
  CHECK(numbers.check(numbered(5, "M105"), true) == Verdict::kNumber);
}

TEST_CASE("any number is accepted with M110, its second one before its own") {
  VirtualLineNumbers numbers;
  CHECK(numbers.check(numbered(500, "M110"), true) == Verdict::kAccepted);
  CHECK(numbers.last() == 500);
  CHECK(numbers.check(numbered(3, "M110 N41"), true) == Verdict::kAccepted);
  CHECK(numbers.last() == 41);
}
