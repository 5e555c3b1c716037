// The lines of a G-code file: text in front, comment behind.
//
//     "G1 X5 E.03 ; wall\r\n"     text "G1 X5 E.03 ", comment " wall"
//     "; 300 KiB of settings\n"   text "", the comment's first kCommentBytesMax bytes
//
// Lines end with \n, \r, or both. A byte order mark at the start of the file is passed over.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/result.h"            // Result
#include "host/gcode/gcode_text.h"  // GcodeText, TextPlace

namespace host {

// What is kept of a line, and of its comment. A controller's line has at most 81 characters.
inline constexpr std::size_t kLineTextBytesMax = 1'024;
inline constexpr std::size_t kCommentBytesMax = 256;

struct GcodeLine {
  std::string_view text;     // valid until the next line is read
  std::string_view comment;  // behind the semicolon; likewise
  std::int64_t number = 0;   // from 1
  TextPlace place;           // of its first byte
};

class GcodeLines {
 public:
  // `number`: of the line before the next one. The text outlives the lines.
  explicit GcodeLines(GcodeText& text, std::int64_t number = 0) : text_(text), number_(number) {}

  // nullopt at the end. Errors: those of the text; a line whose text is longer than
  // kLineTextBytesMax, a byte that is no text.
  [[nodiscard]] core::Result<std::optional<GcodeLine>> next();

  // Of the line that next() has read last, or failed at.
  [[nodiscard]] std::int64_t number() const { return number_; }

 private:
  [[nodiscard]] core::Result<bool> more();
  [[nodiscard]] core::Status take(std::string_view bytes);

  GcodeText& text_;
  std::int64_t number_;
  std::string_view piece_;
  std::size_t at_ = 0;
  bool after_return_ = false;  // a \n that follows belongs to the line before
  bool started_ = false;

  // The line at hand.
  std::array<char, kLineTextBytesMax> line_{};
  std::array<char, kCommentBytesMax> comment_{};
  std::size_t line_size_ = 0;
  std::size_t comment_size_ = 0;
  bool in_comment_ = false;
};

}  // namespace host
