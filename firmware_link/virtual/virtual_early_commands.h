// What acts as soon as its line has arrived, before it has its turn (Marlin's EMERGENCY_PARSER).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace firmware_link {

class VirtualEarlyCommands {
 public:
  enum class Act { kNone, kEndWait, kStop };  // M108, M112

  [[nodiscard]] Act read(char c) {
    if (c == '\n' || c == '\r') {
      const std::string_view seen(start_.data(), size_ <= start_.size() ? size_ : 0);
      size_ = 0;
      if (seen == "M108") return Act::kEndWait;
      return seen == "M112" ? Act::kStop : Act::kNone;
    }
    if (size_ >= start_.size()) {
      size_ = start_.size() + 1;  // longer than what acts early
    } else if (size_ != 0 || c != ' ') {
      start_[size_++] = c;
    }
    return Act::kNone;
  }

  void clear() { size_ = 0; }

 private:
  std::array<char, 4> start_{};  // of the line that comes in
  std::size_t size_ = 0;
};

}  // namespace firmware_link
