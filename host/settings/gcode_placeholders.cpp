#include "host/settings/gcode_placeholders.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "host/settings/settings_text.h"  // kPlaceholderLineBytesMax
#include "host/system/text.h"             // is_digit, trimmed

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

bool is_name(std::string_view text) {
  constexpr std::size_t kNameBytesMax = 200;
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
  };
  return !text.empty() && text.size() <= kNameBytesMax && !is_digit(text.front()) &&
         std::all_of(text.begin(), text.end(), fits);
}

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// Position where the bracket or brace at `at` is closed on its line, within a placeholder's longest
// text; npos if it is not.
std::size_t closing(std::string_view text, std::size_t at) {
  text = text.substr(0, std::min(text.size(), at + kPlaceholderLineBytesMax));
  const char open = text[at], close = open == '[' ? ']' : '}';
  int depth = 0;
  for (; at < text.size() && text[at] != '\n'; ++at) {
    if (text[at] == open) ++depth;
    if (text[at] == close && --depth == 0) return at;
  }
  return std::string_view::npos;
}

class Expander {
 public:
  Expander(std::string_view text, const VariableLookup& lookup, GcodeOrigin origin)
      : cursor_{text}, lookup_(lookup), origin_(origin) {}

  Result<std::string> expand() {
    if (Status done = block(true); !done.ok()) return done.error();
    if (!cursor_.done()) return error_at(cursor_.at, "has no {if} before it");
    return std::move(out_);
  }

 private:
  // The error with line, column and the placeholder there.
  [[nodiscard]] Error error_at(std::size_t at, std::string_view cause) const {
    constexpr std::size_t kShown = 60;
    const std::string_view before = cursor_.text.substr(0, at);
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    const std::size_t end = closing(cursor_.text, at);
    std::string_view all =
        cursor_.text.substr(at, end == std::string_view::npos ? end : end + 1 - at);
    all = all.substr(0, all.find('\n'));
    std::string shown(all.substr(0, kShown));
    if (shown.size() < all.size()) shown += "…";
    return {ErrorCode::kBadSetting, fmt::format("line {}, column {}: {}: {}",
                                                std::count(before.begin(), before.end(), '\n') + 1,
                                                at - line_start + 1, shown, cause)};
  }

  Status put(std::string_view text) {
    if (out_.size() + text.size() > kExpandedBytesMax) {
      return Error{ErrorCode::kBadSetting, fmt::format("more than {} bytes", kExpandedBytesMax)};
    }
    out_ += text;
    return {};
  }

  // Up to the end, or to the {elsif}, {else} or {endif} that belongs to a condition before.
  Status block(bool live) {
    if (++depth_ > kExpressionDepthMax) return error_at(opened_, "conditions are nested too deep");
    while (!cursor_.done()) {
      const char c = cursor_.peek();
      if (c == '\n') comment_ = false;
      if (c == ';') comment_ = true;
      Status done;
      if (c == '{') {
        if (ends_block()) break;
        done = braces(live);
      } else if (c == '[' && origin_ != GcodeOrigin::kCura) {
        done = brackets(live);
      } else {
        if (live) done = put({&c, 1});
        ++cursor_.at;
      }
      if (!done.ok()) return done;
    }
    --depth_;
    return {};
  }

  [[nodiscard]] bool ends_block() const {
    Cursor ahead = cursor_;
    ++ahead.at;
    return ahead.take_word("elsif") || ahead.take_word("else") || ahead.take_word("endif");
  }

  Status braces(bool live) {
    const std::size_t open = cursor_.at++;
    if (cursor_.take_word("if")) return condition(open, live);
    Cursor ahead = cursor_;
    if (ahead.take_word("local") || ahead.take_word("global")) {
      return error_at(open, "variables of its own are not supported");
    }
    const Result<ExpressionValue> value = read_expression(cursor_, lookup_, live);
    std::string cause = value.ok() ? "" : value.error().message;
    if (value.ok() && origin_ == GcodeOrigin::kCura && cursor_.take(",")) {
      // The extruder's number: there is one.
      if (!read_expression(cursor_, lookup_, false).ok()) cause = "a number is missing";
    }
    if (cause.empty() && !cursor_.take("}")) cause = "a '}' is missing";
    if (cause.empty()) return live ? put(text_of(value.value())) : Status();
    return keep_or_refuse(open, cause, live);
  }

  // In a comment, and where it may be the controller's, a placeholder stays.
  Status keep_or_refuse(std::size_t open, const std::string& cause, bool live) {
    const std::size_t end = closing(cursor_.text, open);
    const bool closed = end != std::string_view::npos;
    const bool is_own = origin_ == GcodeOrigin::kOwn && cursor_.text[open] == '{' && closed &&
                        !is_name(trimmed(cursor_.text.substr(open + 1, end - open - 1)));
    if (!comment_ && !is_own) return error_at(open, closed ? cause : "it is not closed");
    cursor_.at = closed ? end + 1 : open + 1;
    return live ? put(cursor_.text.substr(open, cursor_.at - open)) : Status();
  }

  Status condition(std::size_t open, bool live) {
    bool done = false;
    for (bool last = false;;) {
      const bool asked = live && !done;
      bool holds_here = asked;
      const std::size_t place = opened_ = open;
      if (!last) {
        const Result<ExpressionValue> value = read_expression(cursor_, lookup_, asked);
        if (!value.ok()) return error_at(place, value.error().message);
        holds_here = asked && holds(value.value());
      }
      if (!cursor_.take("}")) return error_at(place, "a '}' is missing");
      if (Status inner = block(holds_here); !inner.ok()) return inner;
      done |= holds_here;
      if (cursor_.done()) return error_at(place, "has no {endif}");
      open = cursor_.at++;
      if (cursor_.take_word("endif")) break;
      if (last) return error_at(open, "comes behind {else}");
      last = cursor_.take_word("else");
      if (!last && !cursor_.take_word("elsif")) return error_at(open, "is not understood");
    }
    return cursor_.take("}") ? Status() : error_at(open, "a '}' is missing");
  }

  Status brackets(bool live) {
    const std::size_t open = cursor_.at, end = closing(cursor_.text, open);
    if (end == std::string_view::npos) return keep_or_refuse(open, "it is not closed", live);
    const std::string_view content = trimmed(cursor_.text.substr(open + 1, end - open - 1));
    const Result<std::optional<std::string>> known =
        live ? named(content) : Result<std::optional<std::string>>(std::string());
    if (!known.ok() || !known.value()) {
      const std::string cause =
          known.ok() ? "it stands for nothing that is known here" : known.error().message;
      return keep_or_refuse(open, cause, live);
    }
    cursor_.at = end + 1;
    return put(*known.value());
  }

  // "name", "name_0", "name[0]", "name_[initial_tool]", "8000".
  [[nodiscard]] Result<std::optional<std::string>> named(std::string_view content) const {
    const std::size_t bracket = content.find('[');
    if (bracket == std::string_view::npos) {
      if (!content.empty() && std::all_of(content.begin(), content.end(), is_digit)) {
        return std::optional(std::string(content));
      }
      return found(content, 0);
    }
    std::string_view name = trimmed(content.substr(0, bracket));
    if (!content.ends_with(']')) return std::optional<std::string>();
    const std::string_view inner =
        trimmed(content.substr(bracket + 1, content.size() - bracket - 2));
    std::optional<std::size_t> index = whole_number(inner);
    if (!index) {
      Result<std::optional<std::string>> number = found(inner, 0);
      if (!number.ok()) return number;
      if (number.value()) index = whole_number(*number.value());
    }
    if (name.ends_with('_')) name.remove_suffix(1);
    return index ? found(name, *index) : std::optional<std::string>();
  }

  [[nodiscard]] Result<std::optional<std::string>> found(std::string_view name,
                                                         std::size_t index) const {
    if (!is_name(name)) return std::optional<std::string>();
    const Result<std::optional<Variable>> known = lookup_(name, index);
    if (!known.ok()) return known.error();
    if (known.value()) return std::optional(known.value()->text);
    // "first_layer_temperature_0", as old profiles have it.
    const std::size_t underscore = name.rfind('_');
    if (underscore == std::string_view::npos || index != 0) return std::optional<std::string>();
    const std::optional<std::size_t> number = whole_number(name.substr(underscore + 1));
    return number ? found(name.substr(0, underscore), *number) : std::optional<std::string>();
  }

  Cursor cursor_;
  const VariableLookup& lookup_;
  GcodeOrigin origin_;
  std::string out_;
  std::size_t opened_ = 0;  // the last condition
  int depth_ = 0;
  bool comment_ = false;
};

}  // namespace

Result<std::vector<std::string>> fill_placeholders(const std::vector<std::string>& lines,
                                                   const VariableLookup& lookup,
                                                   GcodeOrigin origin) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const Result<std::string> expanded = Expander(text, lookup, origin).expand();
  if (!expanded.ok()) return expanded.error();
  std::vector<std::string> result;
  for (std::string_view rest = expanded.value(); !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::string_view sent = trimmed(line.substr(0, line.find(';')));
    if (!sent.empty()) result.emplace_back(sent);
  }
  return result;
}

}  // namespace host
