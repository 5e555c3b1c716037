// A file's bytes one by one, with the line they stand in: what readers of text are made of.
//
// Reading can fail anywhere, so failure is kept and looks like the end of the file; whoever meets
// the end asks bad() or cut_short(), which tell the truth.
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
  // The next so many bytes, fewer only before the end. Valid until the next call.
  // REQUIRES: count <= InputFile::kWindowMax
  [[nodiscard]] std::string_view lookahead(std::size_t count);
  // Without counting lines. REQUIRES: count <= what lookahead() gave last.
  void skip(std::size_t count) { next_ += count; }

  // Blanks and line ends. Returns peek().
  int skip_blanks();
  // Up to the next blank, line end, or one of `stops`, which stays; at most kWordBytesMax. Valid
  // until the next call. Empty where there is none.
  [[nodiscard]] std::string_view word(std::string_view stops = {});
  // Up to the line's end, which stays; at most kEntryBytesMax of it are given, the rest skipped.
  [[nodiscard]] std::string_view rest_of_line();

  [[nodiscard]] std::int64_t line() const { return line_; }
  [[nodiscard]] std::int64_t byte() const {
    return file_.position() + static_cast<std::int64_t>(next_);
  }
  [[nodiscard]] const std::string& name() const { return file_.name(); }

  // Reading failed. Else file, line or byte, and the cause.
  [[nodiscard]] core::Error bad(const std::string& cause) const;
  [[nodiscard]] core::Error bad_at_byte(const std::string& cause) const;
  // The same at the end of the file where `wanted` should be.
  [[nodiscard]] core::Error cut_short(const std::string& wanted) const;
  // cut_short() at the end, else that something else stands where `wanted` should be.
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

// What a file says, made fit for a message: short, printable.
[[nodiscard]] std::string shown(std::string_view text, std::size_t length_max = 40);

}  // namespace host
