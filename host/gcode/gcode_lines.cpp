#include "host/gcode/gcode_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace host {
namespace {

core::Error bad(std::string why) { return {core::ErrorCode::kBadPart, std::move(why)}; }

}  // namespace

// False at the end of the text.
core::Result<bool> GcodeLines::more() {
  while (at_ == piece_.size()) {
    const core::Result<std::string_view> next = text_.next();
    if (!next.ok()) return next.error();
    piece_ = next.value();
    at_ = 0;
    if (piece_.empty()) return false;
    if (!started_ && number_ == 0 && piece_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    started_ = true;
  }
  return true;
}

// A stretch of the line, without its end.
core::Status GcodeLines::take(std::string_view bytes) {
  if (std::memchr(bytes.data(), '\0', bytes.size()) != nullptr) {
    return bad(fmt::format("line {}: a byte of 0, which is no text: the file is damaged", number_));
  }
  if (!in_comment_) {
    const std::size_t semicolon = std::min(bytes.find(';'), bytes.size());
    if (line_size_ + semicolon > line_.size()) {
      return bad(fmt::format("line {}: more than {} characters, which no controller takes", number_,
                             kLineTextBytesMax));
    }
    std::copy_n(bytes.data(), semicolon, line_.data() + line_size_);
    line_size_ += semicolon;
    if (semicolon == bytes.size()) return {};
    in_comment_ = true;
    bytes.remove_prefix(semicolon + 1);
  }
  const std::size_t kept = std::min(bytes.size(), comment_.size() - comment_size_);
  std::copy_n(bytes.data(), kept, comment_.data() + comment_size_);
  comment_size_ += kept;
  return {};
}

core::Result<std::optional<GcodeLine>> GcodeLines::next() {
  line_size_ = comment_size_ = 0;
  in_comment_ = false;
  core::Result<bool> any = more();
  if (any.ok() && any.value() && after_return_ && piece_[at_] == '\n') {
    ++at_;
    any = more();
  }
  after_return_ = false;
  if (!any.ok()) return any.error();
  if (!any.value()) return std::optional<GcodeLine>();
  ++number_;
  GcodeLine line;
  line.number = number_;
  line.place = text_.place_in(at_);
  while (true) {
    const std::size_t end = piece_.find_first_of("\r\n", at_);
    const std::string_view bytes = piece_.substr(at_, end - at_);
    if (core::Status taken = take(bytes); !taken.ok()) return taken.error();
    if (end != std::string_view::npos) {
      after_return_ = piece_[end] == '\r';
      at_ = end + 1;
      break;
    }
    at_ = piece_.size();
    const core::Result<bool> goes_on = more();
    if (!goes_on.ok()) return goes_on.error();
    if (!goes_on.value()) break;
  }
  line.text = {line_.data(), line_size_};
  line.comment = {comment_.data(), comment_size_};
  return std::optional(line);
}

}  // namespace host
