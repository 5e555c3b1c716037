// How many lines go alone after a refused one. A receive ring may be smaller than was thought (64
// bytes are found), so one that is refused again soon doubles the number.
//
//     refused ── 8 lines go alone ── 24 more ──┤ refused before here: 16 lines go alone next time
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace firmware_link {

class CalmLines {
 public:
  // That line was refused.
  void refused(std::int64_t sequence) {
    const bool soon = refused_last_ && sequence - *refused_last_ < 4 * lines_;
    lines_ = soon ? std::min(2 * lines_, kLinesMax) : kLinesMin;
    missing_ = lines_;
    refused_last_ = sequence;
  }

  // A line was acknowledged.
  void line_went_well() {
    if (missing_ > 0) --missing_;
  }

  // The rules of another dialect hold from now on.
  void forget() { missing_ = 0; }

  // Whether the next line must go alone.
  [[nodiscard]] bool alone() const { return missing_ > 0; }

 private:
  static constexpr std::int64_t kLinesMin = 8;
  static constexpr std::int64_t kLinesMax = 4096;

  std::int64_t lines_ = kLinesMin;
  std::int64_t missing_ = 0;
  std::optional<std::int64_t> refused_last_;
};

}  // namespace firmware_link
