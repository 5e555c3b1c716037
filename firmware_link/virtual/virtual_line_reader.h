// Characters become lines, as in Marlin: comments are left out, a backslash and a
// backspace have their meaning, and what is over 95 characters is dropped without a word.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "firmware_link/wire/limits.h"  // kLineBytesMax

namespace firmware_link {

// A line as a command slot keeps it: with number and checksum, without its end.
struct VirtualLine {
  std::array<char, kLineBytesMax> bytes{};
  std::size_t size = 0;
  [[nodiscard]] std::string_view text() const { return {bytes.data(), size}; }
};

class VirtualLineReader {
 public:
  // `marlin`: backslash and backspace mean something.
  explicit VirtualLineReader(bool marlin) : marlin_(marlin) {}

  // True when `c` ends a line; take() then has it.
  [[nodiscard]] bool read(char c) {
    if (c == '\n' || c == '\r') {
      in_comment_ = escaped_ = false;
      return true;
    }
    if (in_comment_) return false;
    if (c == '\\' && !escaped_ && marlin_) {
      escaped_ = true;
      return false;
    }
    if (c == ';' && !escaped_) {
      in_comment_ = true;
      return false;
    }
    escaped_ = false;
    if (c == '\b' && marlin_) {  // takes back what is before it
      if (line_.size > 0) --line_.size;
      return false;
    }
    // The checksum is dropped with the rest.
    if (line_.size < line_.bytes.size()) line_.bytes[line_.size++] = c;
    return false;
  }

  // The line that has ended; the next one starts.
  [[nodiscard]] VirtualLine take() {
    const VirtualLine line = line_;
    line_.size = 0;
    return line;
  }

  void clear() {
    line_.size = 0;
    in_comment_ = escaped_ = false;
  }

 private:
  bool marlin_;
  VirtualLine line_;
  bool in_comment_ = false;
  bool escaped_ = false;
};

}  // namespace firmware_link
