// Reads a file byte by byte and counts lines: the base of all readers of text.
//
// A failure to read is stored and looks like the end of the file. At the end, use the error of
// bad() or cut_short(): they return the failure if there was one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"            // Error
#include "host/files/input_file.h"  // InputFile

namespace host {

class TextScanner {
 public:
  static constexpr int kEnd = -1;

  explicit TextScanner(InputFile file) : file_(std::move(file)) {}

  // The next byte, 0 … 255, or kEnd.
  [[nodiscard]] int peek() {
    if (next_ == view_.size() && !refill(1)) return kEnd;
    return static_cast<unsigned char>(view_[next_]);
  }
  // REQUIRES: peek() is not kEnd.
  void take();
  // The next `count` bytes, fewer only at the end. Valid until the next call.
  // REQUIRES: count <= InputFile::kWindowMax
  [[nodiscard]] std::string_view lookahead(std::size_t count);
  // Skips bytes without counting lines. REQUIRES: count <= size of the last lookahead().
  void skip(std::size_t count) { next_ += count; }

  // Skips blanks and line ends. Returns peek().
  int skip_blanks();
  // Reads up to the next blank, line end, or one of `stops`, which is not read; at most
  // kWordBytesMax. Valid until the next call. Empty if there is no word.
  [[nodiscard]] std::string_view word(std::string_view stops = {});
  // Reads up to the line's end, which is not read. Returns at most kEntryBytesMax; skips the rest.
  [[nodiscard]] std::string_view rest_of_line();

  [[nodiscard]] std::int64_t line() const { return line_; }
  [[nodiscard]] std::int64_t byte() const {
    return file_.position() + static_cast<std::int64_t>(next_);
  }
  [[nodiscard]] const std::string& name() const { return file_.name(); }

  // The failure to read, if there was one; otherwise an error with file, line (or byte) and cause.
  [[nodiscard]] core::Error bad(const std::string& cause) const;
  [[nodiscard]] core::Error bad_at_byte(const std::string& cause) const;
  // The same, for a file that ends where `wanted` should be.
  [[nodiscard]] core::Error cut_short(const std::string& wanted) const;
  // cut_short() at the end; otherwise an error for `found` where `wanted` should be.
  [[nodiscard]] core::Error unexpected(std::string_view found, const std::string& wanted);
  [[nodiscard]] bool failed() const { return failure_.has_value(); }

 private:
  bool refill(std::size_t least);

  InputFile file_;
  std::string_view view_;
  std::size_t next_ = 0;
  std::int64_t line_ = 1;
  bool after_return_ = false;  // a line feed here belongs to the return before it
  std::optional<core::Error> failure_;
  std::string word_;
};

[[nodiscard]] constexpr bool is_blank(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// A file's text for a message: short, printable.
[[nodiscard]] std::string shown(std::string_view text, std::size_t length_max = 40);

}  // namespace host
