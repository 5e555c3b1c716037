#include "host/settings/regular_expression.h"

#include <doctest/doctest.h>

#include <regex>
#include <string>

#include "tests/support/random_regions.h"

namespace {

bool matches(const std::string& pattern, const std::string& text) {
  const auto found = host::matches_whole(pattern, text);
  if (!found.ok()) FAIL(found.error().message);
  return found.value();
}

std::string random_pattern(test::Random& random, int depth) {
  std::string pattern;
  const int count = static_cast<int>(random.between(1.0, 4.0));
  for (int i = 0; i < count; ++i) {
    const int kind = static_cast<int>(random.between(0.0, 8.0));
    std::string one(1, "abc.ab"[static_cast<std::size_t>(random.between(0.0, 6.0))]);
    if (kind == 6) one = "[a-b]";
    if (kind == 7 && depth < 3) {
      one = "(" + random_pattern(random, depth + 1) + "|" + random_pattern(random, depth + 1) + ")";
    }
    const int times = static_cast<int>(random.between(0.0, 6.0));
    pattern += one + (times < 3 ? std::string(1, "*+?"[times]) : "");
  }
  return pattern;
}

}  // namespace

TEST_CASE("patterns match as the standard library says") {
  const unsigned seed = 5;
  CAPTURE(seed);
  test::Random random(seed);
  int found = 0;
  for (int i = 0; i < 1'500; ++i) {
    const std::string pattern = random_pattern(random, 0);
    const std::regex expected(pattern);
    for (int j = 0; j < 4; ++j) {
      std::string text;
      const int length = static_cast<int>(random.between(0.0, 6.0));
      for (int k = 0; k < length; ++k)
        text += "abcd"[static_cast<std::size_t>(random.between(0.0, 4.0))];
      CAPTURE(pattern);
      CAPTURE(text);
      const bool match = matches(pattern, text);
      CHECK_EQ(match, std::regex_match(text, expected));
      found += match ? 1 : 0;
    }
  }
  CHECK_GT(found, 300);
}

TEST_CASE("what PrusaSlicer's conditions have") {
  CHECK(matches(".*(DETAIL @MK3|QUALITY @MK3|@0.25 nozzle MK3).*", "0.15mm QUALITY @MK3"));
  CHECK_FALSE(matches(".*(DETAIL @MK3|QUALITY @MK3).*", "0.15mm SPEED @MK3"));
  CHECK(matches(".*PRINTER_MODEL_MK3[^A-Z].*", "a\nPRINTER_MODEL_MK3\nb"));
  CHECK_FALSE(matches("MINI", "a MINI b"));
  CHECK(matches("^\\d+\\.\\d$", "12.5"));
  CHECK(matches("[]a-]+", "]-a"));
  CHECK(matches("", ""));
  // A pattern that would take ages by backtracking.
  CHECK_FALSE(matches("(a*)*(a*)*(a*)*b", std::string(2'000, 'a')));
  for (const char* bad : {"(", ")", "[a", "a{2}", "*", "\\"}) {
    CAPTURE(bad);
    CHECK_FALSE(host::matches_whole(bad, "a").ok());
  }
  CHECK_FALSE(host::matches_whole(std::string(host::kPatternBytesMax + 1, 'a'), "a").ok());
  CHECK_FALSE(host::matches_whole(std::string(100, '('), "a").ok());
}
