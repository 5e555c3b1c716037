#include "host/formats/text_scanner.h"

#include <algorithm>

#include "core/check.h"                  // RIND_CHECK
#include "host/formats/format_limits.h"  // kWordBytesMax

namespace host {

using core::Error;
using core::ErrorCode;

bool TextScanner::refill(std::size_t least) {
  if (failure_) return false;
  file_.skip(next_);
  next_ = 0;
  const core::Result<std::string_view> window = file_.window(least);
  if (window.ok()) {
    view_ = window.value();
  } else {
    failure_ = window.error();
    view_ = {};
  }
  return !view_.empty();
}

void TextScanner::take() {
  RIND_CHECK(next_ < view_.size());
  const char c = view_[next_++];
  if (c == '\r' || (c == '\n' && !after_return_)) ++line_;
  after_return_ = c == '\r';
}

std::string_view TextScanner::lookahead(std::size_t count) {
  if (view_.size() - next_ < count) refill(count);
  return view_.substr(next_, count);
}

int TextScanner::skip_blanks() {
  int c = peek();
  while (is_blank(c)) {
    take();
    c = peek();
  }
  return c;
}

std::string_view TextScanner::word(std::string_view stops) {
  word_.clear();
  for (int c = peek(); c != kEnd && !is_blank(c) && word_.size() < kWordBytesMax; c = peek()) {
    if (stops.find(static_cast<char>(c)) != std::string_view::npos) break;
    word_ += static_cast<char>(c);
    take();
  }
  return word_;
}

std::string_view TextScanner::rest_of_line() {
  word_.clear();
  for (int c = peek(); c != kEnd && c != '\n' && c != '\r'; c = peek()) {
    if (word_.size() < kEntryBytesMax) word_ += static_cast<char>(c);
    take();
  }
  return word_;
}

Error TextScanner::bad(const std::string& cause) const {
  if (failure_) return *failure_;
  return {ErrorCode::kBadPart, name() + ": line " + std::to_string(line_) + ": " + cause};
}

Error TextScanner::bad_at_byte(const std::string& cause) const {
  if (failure_) return *failure_;
  return {ErrorCode::kBadPart, name() + ": byte " + std::to_string(byte()) + ": " + cause};
}

Error TextScanner::cut_short(const std::string& wanted) const {
  return bad("the file ends where " + wanted +
             " should be: it is cut short; copy or export it again");
}

Error TextScanner::unexpected(std::string_view found, const std::string& wanted) {
  const std::string text = shown(found);
  if (peek() == kEnd && text.empty()) return cut_short(wanted);
  return bad("'" + text + "' where " + wanted + " should be; repair the file or export it again");
}

std::string shown(std::string_view text, std::size_t length_max) {
  std::string result(text.substr(0, length_max));
  std::replace_if(
      result.begin(), result.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
  return result;
}

}  // namespace host
