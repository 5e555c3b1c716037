// The words of a line of classic G-code: a letter and its number each.
//
//     "G1 X10.5Y-.25 E1"   X 1050000   Y -25000   E 100000     in units of 0.00001
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace host {

class GcodeNumbers {
 public:
  // `text`: what stands behind the command word.
  explicit GcodeNumbers(std::string_view text);

  [[nodiscard]] bool has(char letter) const { return (present_ & bit(letter)) != 0; }
  // In units of 0.00001, rounded to the nearest; 0 where a letter has no number.
  [[nodiscard]] std::optional<std::int64_t> fixed(char letter) const {
    if (!has(letter)) return std::nullopt;
    return values_[static_cast<std::size_t>(letter - 'A')];
  }
  // To the nearest whole number.
  [[nodiscard]] std::optional<std::int64_t> whole(char letter) const;

 private:
  [[nodiscard]] static std::uint32_t bit(char letter) { return std::uint32_t{1} << (letter - 'A'); }

  std::array<std::int64_t, 26> values_;
  std::uint32_t present_ = 0;
};

// `value` / `by`, to the nearest, halves away from 0. REQUIRES: by > 0.
[[nodiscard]] constexpr std::int64_t divided(std::int64_t value, std::int64_t by) {
  return (value + (value < 0 ? -by / 2 : by / 2)) / by;
}

}  // namespace host
