#include "core/walls/sliding_fold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/limits.h"

namespace {

constexpr std::size_t kWindowMax = core::kWindowLayersMax;

struct Minimum {
  int operator()(int a, int b) const { return std::min(a, b); }
};
struct GreatestDivisor {
  std::uint64_t operator()(std::uint64_t a, std::uint64_t b) const { return std::gcd(a, b); }
};
struct BitAnd {
  std::uint64_t operator()(std::uint64_t a, std::uint64_t b) const { return a & b; }
};
// Strings as sorted sets of letters.
struct CommonLetters {
  std::string operator()(const std::string& a, const std::string& b) const {
    std::string common;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    return common;
  }
};
// The rectangular band: idempotent, associative, and anything but commutative.
using Ends = std::pair<int, int>;
struct FirstAndLast {
  Ends operator()(const Ends& a, const Ends& b) const { return {a.first, b.second}; }
};

// Counts every call, to be held against what the fold says about itself.
template <typename Combine>
struct Counting {
  Combine combine{};
  int* calls = nullptr;
  template <typename Value>
  Value operator()(const Value& a, const Value& b) const {
    ++*calls;
    return combine(a, b);
  }
};

template <typename Combine, typename Value>
void check_against_brute_force(std::size_t window, const std::vector<Value>& values) {
  CAPTURE(window);
  int calls = 0;
  core::SlidingFold<Value, Counting<Combine>> fold(window, Counting<Combine>{{}, &calls});
  const int cost_max = static_cast<int>(std::ceil(std::log2(static_cast<double>(window))));
  REQUIRE_LE(cost_max, core::kFoldCostMax);
  int worst = 0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    CAPTURE(n);
    calls = 0;
    const std::optional<Value> folded = fold.push(values[n]);
    REQUIRE_EQ(folded.has_value(), n + 1 >= window);
    REQUIRE_EQ(calls, fold.operations());
    REQUIRE_LE(calls, cost_max);
    worst = std::max(worst, calls);
    REQUIRE_EQ(fold.partials_held(), std::min(n + 1, window - 1));
    if (!folded.has_value()) continue;
    Value expected = values[n + 1 - window];
    for (std::size_t i = n + 2 - window; i <= n; ++i) expected = Combine()(expected, values[i]);
    REQUIRE(*folded == expected);
  }
  // The bound is met: the test has seen full windows.
  REQUIRE_EQ(worst, cost_max);
}

template <typename Combine, typename MakeValue>
void check_every_window(std::uint32_t seed, MakeValue make_value) {
  CAPTURE(seed);
  for (std::size_t window = 1; window <= kWindowMax; ++window) {
    std::mt19937 random(seed + static_cast<std::uint32_t>(window));
    std::vector<decltype(make_value(random))> values;
    for (std::size_t n = 0; n < 2 * window + 40; ++n) values.push_back(make_value(random));
    check_against_brute_force<Combine>(window, values);
  }
}

}  // namespace

TEST_CASE("the smallest of the window") {
  check_every_window<Minimum>(1, [](auto& random) { return static_cast<int>(random() % 1'000); });
}

TEST_CASE("the greatest common divisor of the window") {
  check_every_window<GreatestDivisor>(2, [](auto& random) {
    std::uint64_t value = 1;
    for (const unsigned prime : {2u, 2u, 2u, 3u, 3u, 5u, 7u, 11u, 13u}) {
      if (random() % 64 != 0) value *= prime;
    }
    return value;
  });
}

TEST_CASE("the bits that the whole window shares") {
  check_every_window<BitAnd>(3, [](auto& random) {
    std::uint64_t value = ~std::uint64_t{0};
    for (int drops = 0; drops < 2; ++drops) value &= ~(std::uint64_t{1} << (random() % 64));
    return value;
  });
}

TEST_CASE("the letters that the whole window shares") {
  check_every_window<CommonLetters>(4, [](auto& random) {
    std::string letters;
    for (char letter = 'a'; letter <= 'z'; ++letter) {
      if (random() % 32 != 0) letters += letter;
    }
    return letters;
  });
}

TEST_CASE("older values stand on the left") {
  int count = 0;
  check_every_window<FirstAndLast>(5, [&count](auto& /*random*/) {
    ++count;
    return Ends{count, count};
  });
}

TEST_CASE("what left the window is forgotten") {
  core::SlidingFold<std::uint64_t, BitAnd> fold(5);
  std::optional<std::uint64_t> last = fold.push(0);
  for (int i = 0; i < 4; ++i) last = fold.push(7);
  CHECK_EQ(last, 0);
  CHECK_EQ(fold.push(7), 7);
}
