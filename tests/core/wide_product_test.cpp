// Products of two 64-bit numbers: without 128-bit integers as with them, and as worked by hand.
#include "core/wide_product.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <random>

namespace {

constexpr std::int64_t kLargest = INT64_MAX;
constexpr std::int64_t kSeed = 20261127;

// Of any size: numbers near 0 and near the bounds come as often as those between.
std::int64_t any_size(std::mt19937_64& random, int bits_max) {
  const auto bits = static_cast<int>(random() % static_cast<unsigned>(bits_max));
  const auto magnitude = static_cast<std::int64_t>(random() & ((std::uint64_t{2} << bits) - 1));
  return random() % 2 == 0 ? magnitude : -magnitude;
}

}  // namespace

TEST_CASE("products are compared exactly at the ends of their range") {
  for (const auto compare : {core::compare_products, core::compare_products_narrow}) {
    CHECK_EQ(compare(kLargest, kLargest, kLargest, kLargest - 1), 1);
    CHECK_EQ(compare(kLargest, kLargest - 1, kLargest, kLargest), -1);
    CHECK_EQ(compare(-kLargest, kLargest, kLargest, -kLargest), 0);
    CHECK_EQ(compare(-kLargest, kLargest, kLargest, 1 - kLargest), -1);
    CHECK_EQ(compare(kLargest - 1, kLargest + 0, kLargest - 2, kLargest), 1);
    CHECK_EQ(compare(0, kLargest, 5, 0), 0);
    CHECK_EQ(compare(0, 0, -1, 1), 1);
    CHECK_EQ(compare(6, 35, 14, 15), 0);
  }
}

TEST_CASE("a share is rounded to nearest, halves up") {
  for (const auto share : {core::rounded_share, core::rounded_share_narrow}) {
    CHECK_EQ(share(1, 1, 2), 1);
    CHECK_EQ(share(-1, 1, 2), 0);
    CHECK_EQ(share(-3, 1, 2), -1);
    CHECK_EQ(share(3, 1, 2), 2);
    CHECK_EQ(share(10, 1, 3), 3);
    CHECK_EQ(share(-10, 2, 3), -7);
    CHECK_EQ(share(7, 0, 3), 0);
    const std::int64_t whole = (std::int64_t{1} << 62) - 1;
    CHECK_EQ(share(whole, whole, whole), whole);
    CHECK_EQ(share(-whole, whole, whole), -whole);
    CHECK_EQ(share(whole, whole - 1, whole), whole - 1);
  }
}

TEST_CASE("both ways to reckon agree on random numbers") {
  std::mt19937_64 random(kSeed);
  INFO("seed ", kSeed);
  for (int i = 0; i < 200'000; ++i) {
    const std::int64_t a = any_size(random, 63), b = any_size(random, 63);
    const std::int64_t c = random() % 4 == 0 ? b : any_size(random, 63);
    const std::int64_t d = random() % 4 == 0 ? a : any_size(random, 63);
    REQUIRE_EQ(core::compare_products(a, b, c, d), core::compare_products_narrow(a, b, c, d));
    const std::int64_t whole = 1 + (any_size(random, 61) & (kLargest >> 2));
    const auto part = static_cast<std::int64_t>(random() % (static_cast<std::uint64_t>(whole) + 1));
    const std::int64_t way = any_size(random, 61);
    REQUIRE_EQ(core::rounded_share(way, part, whole), core::rounded_share_narrow(way, part, whole));
  }
}
