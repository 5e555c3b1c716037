#include "core/wide_product.h"

#include <compare>

namespace core {
namespace {

struct Wide {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
  friend auto operator<=>(const Wide&, const Wide&) = default;
};

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

int sign_of_product(std::int64_t a, std::int64_t b) {
  if (a == 0 || b == 0) return 0;
  return (a < 0) == (b < 0) ? 1 : -1;
}

Wide product(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kDigit = 0xFFFFFFFF;
  const std::uint64_t low = (a & kDigit) * (b & kDigit);
  const std::uint64_t left = (a >> 32) * (b & kDigit) + (low >> 32);
  const std::uint64_t right = (a & kDigit) * (b >> 32) + (left & kDigit);
  return {(a >> 32) * (b >> 32) + (left >> 32) + (right >> 32), (right << 32) | (low & kDigit)};
}

Wide plus(Wide a, std::uint64_t b) {
  const std::uint64_t low = a.low + b;
  return {a.high + (low < b ? 1 : 0), low};
}

// ⌊dividend / divisor⌋. REQUIRES: 0 < divisor <= 2^63, and the result is below 2^64.
std::uint64_t quotient(Wide dividend, std::uint64_t divisor) {
  std::uint64_t result = 0, rest = 0;
  for (int bit = 127; bit >= 0; --bit) {
    const std::uint64_t word = bit >= 64 ? dividend.high : dividend.low;
    rest = 2 * rest + ((word >> (bit % 64)) & 1);
    result *= 2;
    if (rest < divisor) continue;
    rest -= divisor;
    ++result;
  }
  return result;
}

}  // namespace

int compare_products_narrow(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  const int left = sign_of_product(a, b), right = sign_of_product(c, d);
  if (left != right) return left < right ? -1 : 1;
  const auto order = product(magnitude(a), magnitude(b)) <=> product(magnitude(c), magnitude(d));
  return order < 0 ? -left : order > 0 ? left : 0;
}

std::int64_t rounded_share_narrow(std::int64_t way, std::int64_t part, std::int64_t whole) {
  const auto divisor = static_cast<std::uint64_t>(whole);
  const Wide distance = product(magnitude(way), static_cast<std::uint64_t>(part));
  const Wide doubled{2 * distance.high + (distance.low >> 63), 2 * distance.low};
  // A half is rounded up, which is towards 0 where the way leads down.
  const std::uint64_t half = way < 0 ? divisor - 1 : divisor;
  const auto size = static_cast<std::int64_t>(quotient(plus(doubled, half), 2 * divisor));
  return way < 0 ? -size : size;
}

#ifdef __SIZEOF_INT128__

int compare_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  __extension__ using Int128 = __int128;
  const Int128 left = Int128{a} * b, right = Int128{c} * d;
  return left < right ? -1 : left > right ? 1 : 0;
}

std::int64_t rounded_share(std::int64_t way, std::int64_t part, std::int64_t whole) {
  __extension__ using Int128 = __int128;
  const Int128 numerator = 2 * Int128{way} * part + whole, denominator = 2 * Int128{whole};
  const Int128 share = numerator / denominator;
  return static_cast<std::int64_t>(share - (share * denominator > numerator ? 1 : 0));
}

#else

int compare_products(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
  return compare_products_narrow(a, b, c, d);
}

std::int64_t rounded_share(std::int64_t way, std::int64_t part, std::int64_t whole) {
  return rounded_share_narrow(way, part, whole);
}

#endif

}  // namespace core
