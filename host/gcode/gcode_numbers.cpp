#include "host/gcode/gcode_numbers.h"

#include "host/system/text.h"  // is_digit

namespace host {
namespace {

constexpr int kDecimals = 5;
constexpr std::int64_t kOne = 100'000;
// Larger numbers stay there: ten thousand kilometres.
constexpr std::int64_t kLargest = 1'000'000'000'000'000;

// Reads a number from `at` on, and moves `at` behind it.
std::int64_t read_fixed(std::string_view text, std::size_t& at) {
  const bool negative = at < text.size() && text[at] == '-';
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  std::int64_t value = 0;
  int taken = 0;
  bool point = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '.' && !point) {
      point = true;
    } else if (!is_digit(c)) {
      break;
    } else if (value >= kLargest) {
      continue;
    } else if (!point || taken < kDecimals) {
      value = value * 10 + (c - '0');
      taken += point ? 1 : 0;
    } else if (taken == kDecimals) {
      value += c >= '5' ? 1 : 0;
      ++taken;
    }
  }
  for (; taken < kDecimals && value < kLargest; ++taken) value *= 10;
  return negative ? -value : value;
}

}  // namespace

GcodeNumbers::GcodeNumbers(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    char letter = text[at++];
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
    if (letter < 'A' || letter > 'Z') continue;
    while (at < text.size() && text[at] == ' ') ++at;
    values_[static_cast<std::size_t>(letter - 'A')] = read_fixed(text, at);
    present_ |= bit(letter);
  }
}

std::optional<std::int64_t> GcodeNumbers::whole(char letter) const {
  const std::optional<std::int64_t> value = fixed(letter);
  if (!value) return std::nullopt;
  return divided(*value, kOne);
}

}  // namespace host
