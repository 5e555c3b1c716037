// A controller's account of the lines that it has ("Last Line: 14", "Resend: 15"), when it cannot
// be true. Either it was damaged on its way, or the controller's counter has jumped. Damaged
// accounts differ, so the same one three times in a row means that the counter has jumped.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace firmware_link {

class AccountWatch {
 public:
  // A line was refused with these words.
  void refused(std::string_view words) {
    constexpr std::string_view kLast = "Last Line: ";
    last_line_.reset();
    const std::size_t at = words.rfind(kLast);
    if (at == std::string_view::npos) return;
    std::int64_t number = 0;
    const std::string_view digits = words.substr(at + kLast.size());
    if (std::from_chars(digits.data(), digits.data() + digits.size(), number).ec == std::errc()) {
      last_line_ = number;
    }
  }

  // A line was asked for that cannot be the next. True when three accounts in a row have said so,
  // each the same in both its lines.
  [[nodiscard]] bool impossible(std::int64_t number) {
    ++doubts_;
    if (!last_line_ || *last_line_ + 1 != number) return false;
    last_line_.reset();
    times_ = number == number_ ? times_ + 1 : 1;
    number_ = number;
    return times_ >= kTimesMax;
  }

  // A possible account came, or a line of ours was accepted.
  void possible() { times_ = doubts_ = 0; }

  // Whether to ask at once for another account.
  [[nodiscard]] bool ask_again() const { return times_ > 0 && doubts_ <= kDoubtsMax; }

 private:
  static constexpr int kDoubtsMax = 8;
  static constexpr int kTimesMax = 3;

  std::optional<std::int64_t> last_line_;
  std::int64_t number_ = 0;
  int times_ = 0;
  int doubts_ = 0;  // since the last one that can be true
};

}  // namespace firmware_link
