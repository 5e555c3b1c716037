#include "core/decimal_text.h"

#include <algorithm>
#include <cstddef>

namespace core {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_word(std::string_view& text) {
  text = without_blanks(text);
  const auto* const end = std::find_if(text.begin(), text.end(), is_blank);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text = without_blanks(text.substr(word.size()));
  return word;
}

std::optional<std::int64_t> read_decimal(std::string_view text, int decimals,
                                         std::int64_t largest) {
  std::int64_t value = 0;
  int behind_point = -1;  // digits behind the point; -1: it was not met
  bool any = false;
  for (const char c : text) {
    if (c == '.' && behind_point < 0) {
      behind_point = 0;
      continue;
    }
    if (!is_digit(c)) return std::nullopt;
    any = true;
    if (behind_point >= 0 && ++behind_point > decimals) {
      if (c != '0') return std::nullopt;
      continue;
    }
    value = value * 10 + (c - '0');
    if (value > largest) return std::nullopt;
  }
  for (int i = std::max(behind_point, 0); i < decimals; ++i) value *= 10;
  if (!any || value > largest) return std::nullopt;
  return value;
}

}  // namespace core
