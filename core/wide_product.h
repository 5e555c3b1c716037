// Exact arithmetic on products of two 64-bit numbers, on machines with 128-bit integers and
// without.
//
// SOURCE: multiplication and division digit by digit, with 32-bit and 1-bit digits.
#pragma once

#include <cstdint>

namespace core {

// Below 0 where a · b < c · d, 0 where they are equal, above 0 otherwise.
// REQUIRES: no argument is -2^63.
[[nodiscard]] int compare_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d);

// way · part / whole, rounded to nearest, halves up.
// REQUIRES: 0 <= part <= whole, 0 < whole < 2^62, |way| < 2^62.
[[nodiscard]] std::int64_t rounded_share(std::int64_t way, std::int64_t part, std::int64_t whole);

// The same without 128-bit integers, whether the machine has them or not: for the test that holds
// both against each other.
[[nodiscard]] int compare_products_narrow(std::int64_t a, std::int64_t b, std::int64_t c,
                                          std::int64_t d);
[[nodiscard]] std::int64_t rounded_share_narrow(std::int64_t way, std::int64_t part,
                                                std::int64_t whole);

}  // namespace core
