#include "host/settings/gcode_expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "host/settings/regular_expression.h"
#include "host/system/text.h"  // is_digit

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

using Value = ExpressionValue;

bool in_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

Error bad(std::string message) { return {ErrorCode::kBadSetting, std::move(message)}; }

std::optional<double> number_of(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

bool is_text(const Value& value) { return std::holds_alternative<std::string>(value); }

// Whole numbers wrap around: no text makes the program fail.
std::int64_t wrapped(std::int64_t a, std::int64_t b, char sign) {
  const auto x = static_cast<std::uint64_t>(a), y = static_cast<std::uint64_t>(b);
  return static_cast<std::int64_t>(sign == '+' ? x + y : sign == '-' ? x - y : x * y);
}

Result<Value> divided(const Value& a, const Value& b, char sign) {
  const double x = *number_of(a), y = *number_of(b);
  if (y == 0) return bad("a division by zero");
  const auto* whole_a = std::get_if<std::int64_t>(&a);
  const auto* whole_b = std::get_if<std::int64_t>(&b);
  if (whole_a == nullptr || whole_b == nullptr) {
    return Value(sign == '/' ? x / y : std::fmod(x, y));
  }
  if (*whole_b == -1) return Value(sign == '/' ? wrapped(0, *whole_a, '-') : std::int64_t{0});
  return Value(sign == '/' ? *whole_a / *whole_b : *whole_a % *whole_b);
}

Result<Value> calculated(const Value& a, const Value& b, char sign) {
  if (sign == '+' && (is_text(a) || is_text(b))) {
    std::string both = text_of(a) + text_of(b);
    if (both.size() > kExpandedBytesMax) return bad("a text is too long");
    return Value(std::move(both));
  }
  const std::optional<double> x = number_of(a), y = number_of(b);
  if (!x || !y) return bad(fmt::format("{} needs two numbers", sign));
  if (sign == '/' || sign == '%') return divided(a, b, sign);
  const auto* whole_a = std::get_if<std::int64_t>(&a);
  const auto* whole_b = std::get_if<std::int64_t>(&b);
  if (whole_a != nullptr && whole_b != nullptr) return Value(wrapped(*whole_a, *whole_b, sign));
  return Value(sign == '+' ? *x + *y : sign == '-' ? *x - *y : *x * *y);
}

// -1, 0, 1; numbers by size, all else by its text.
int order(const Value& a, const Value& b) {
  const std::optional<double> x = number_of(a), y = number_of(b);
  if (x && y) return *x < *y ? -1 : *x > *y ? 1 : 0;
  return std::clamp(text_of(a).compare(text_of(b)), -1, 1);
}

Result<Value> rounded(const Value& value, bool down) {
  const std::optional<double> number = number_of(value);
  if (!number) return bad("int and round need a number");
  // PrusaSlicer's int() drops the fraction.
  const double whole = down ? std::trunc(*number) : std::round(*number);
  if (!(std::abs(whole) < 9e18)) return bad("a number is too large");
  return Value(static_cast<std::int64_t>(whole));
}

// The number in so many characters, spaces or zeros in front.
Result<Value> padded(const std::vector<Value>& parts, char with) {
  const std::optional<double> number = number_of(parts[0]), width = number_of(parts[1]);
  const std::optional<double> decimals = parts.size() > 2 ? number_of(parts[2]) : 0;
  if (!number || !width || !decimals) return bad("digits needs numbers");
  if (!(std::abs(*number) < 1e15) || !(*width >= 0 && *width <= 64) ||
      !(*decimals >= 0 && *decimals <= 16)) {
    return bad("digits: a number is too large");
  }
  std::string text = fmt::format("{:.{}f}", *number, static_cast<int>(*decimals));
  const auto size = static_cast<std::size_t>(*width);
  if (text.size() < size) text.insert(0, size - text.size(), with);
  return Value(std::move(text));
}

class Reader {
 public:
  Reader(Cursor& cursor, const VariableLookup& lookup, bool live)
      : at_(cursor), lookup_(lookup), live_(live) {}

  // condition ? a : b, and all that binds closer.
  Result<Value> whole() {
    if (++depth_ > kExpressionDepthMax) return bad("parentheses are nested too deep");
    Result<Value> value = any_of();
    if (value.ok() && at_.take("?")) value = choice(holds(value.value()));
    --depth_;
    return value;
  }

 private:
  Result<Value> choice(bool first) {
    const bool live = live_;
    live_ = live && first;
    Result<Value> yes = whole();
    if (!yes.ok()) return yes;
    if (!at_.take(":")) return bad("a ':' is missing behind '?'");
    live_ = live && !first;
    Result<Value> no = whole();
    live_ = live;
    return no.ok() && first ? yes : no;
  }

  Result<Value> any_of() {
    Result<Value> value = all_of();
    while (value.ok() && (at_.take("||") || at_.take_word("or"))) {
      Result<Value> other = all_of();
      if (!other.ok()) return other;
      value = Value(holds(value.value()) || holds(other.value()));
    }
    return value;
  }

  Result<Value> all_of() {
    Result<Value> value = equality();
    while (value.ok() && (at_.take("&&") || at_.take_word("and"))) {
      Result<Value> other = equality();
      if (!other.ok()) return other;
      value = Value(holds(value.value()) && holds(other.value()));
    }
    return value;
  }

  Result<Value> equality() {
    Result<Value> value = relation();
    while (value.ok()) {
      const bool alike = at_.take("=~");
      if (alike || at_.take("!~")) {
        value = matched(value.value(), alike);
        continue;
      }
      const bool equal = at_.take("==");
      if (!equal && !at_.take("!=") && !at_.take("<>")) break;
      Result<Value> other = relation();
      if (!other.ok()) return other;
      value = Value((order(value.value(), other.value()) == 0) == equal);
    }
    return value;
  }

  Result<Value> matched(const Value& value, bool alike) {
    at_.skip_space();
    if (at_.peek() != '/') return bad("a regular expression between slashes is missing");
    std::size_t end = ++at_.at;
    while (end < at_.text.size() && at_.text[end] != '/') end += at_.text[end] == '\\' ? 2 : 1;
    if (end >= at_.text.size()) return bad("a regular expression is not closed");
    const Result<bool> found =
        matches_whole(at_.text.substr(at_.at, end - at_.at), live_ ? text_of(value) : "");
    if (!found.ok()) return found.error();
    at_.at = end + 1;
    return Value(found.value() == alike);
  }

  Result<Value> relation() {
    Result<Value> value = sum();
    while (value.ok()) {
      at_.skip_space();
      if (at_.text.substr(at_.at).starts_with("<>")) break;
      const bool less_or_equal = at_.take("<="), more_or_equal = !less_or_equal && at_.take(">=");
      const bool less = !less_or_equal && !more_or_equal && at_.take("<");
      if (!less_or_equal && !more_or_equal && !less && !at_.take(">")) break;
      Result<Value> other = sum();
      if (!other.ok()) return other;
      const int by = order(value.value(), other.value());
      value = Value(less_or_equal ? by <= 0 : more_or_equal ? by >= 0 : less ? by < 0 : by > 0);
    }
    return value;
  }

  Result<Value> sum() {
    Result<Value> value = product();
    while (value.ok()) {
      const bool plus = at_.take("+");
      if (!plus && !at_.take("-")) break;
      Result<Value> other = product();
      if (!other.ok()) return other;
      if (live_) value = calculated(value.value(), other.value(), plus ? '+' : '-');
    }
    return value;
  }

  Result<Value> product() {
    Result<Value> value = single();
    while (value.ok()) {
      const char sign = at_.take("*") ? '*' : at_.take("/") ? '/' : at_.take("%") ? '%' : '\0';
      if (sign == '\0') break;
      Result<Value> other = single();
      if (!other.ok()) return other;
      if (live_) value = calculated(value.value(), other.value(), sign);
    }
    return value;
  }

  Result<Value> single() {
    if (++depth_ > kExpressionDepthMax) return bad("signs are nested too deep");
    Result<Value> value = single_of();
    --depth_;
    return value;
  }

  Result<Value> single_of() {
    at_.skip_space();
    if (at_.take("(")) {
      Result<Value> value = whole();
      if (value.ok() && !at_.take(")")) return bad("a ')' is missing");
      return value;
    }
    if (at_.take("+")) return single();
    if (at_.take("-")) {
      Result<Value> value = single();
      if (!value.ok() || !live_) return value;
      return calculated(Value(std::int64_t{0}), value.value(), '-');
    }
    if (at_.take_word("not") || (!at_.text.substr(at_.at).starts_with("!~") && at_.take("!"))) {
      Result<Value> value = single();
      return value.ok() ? Result<Value>(Value(!holds(value.value()))) : value;
    }
    if (at_.peek() == '"') return quoted();
    if (is_digit(at_.peek()) || at_.peek() == '.') return number();
    return named();
  }

  Result<Value> quoted() {
    std::string text;
    for (++at_.at; !at_.done() && at_.peek() != '"'; ++at_.at) {
      if (at_.peek() == '\\' && at_.at + 1 < at_.text.size()) ++at_.at;
      text += at_.peek();
    }
    if (at_.done()) return bad("a '\"' is not closed");
    ++at_.at;
    return Value(std::move(text));
  }

  Result<Value> number() {
    std::size_t end = at_.at;
    while (end < at_.text.size() && (is_digit(at_.text[end]) || at_.text[end] == '.')) ++end;
    const std::string_view digits = at_.text.substr(at_.at, end - at_.at);
    const char* const last = digits.data() + digits.size();
    at_.at = end;
    if (digits.find('.') == std::string_view::npos) {
      std::int64_t whole = 0;
      const auto [stop, code] = std::from_chars(digits.data(), last, whole);
      if (code == std::errc() && stop == last) return Value(whole);
    }
    double value = 0;
    const auto [stop, code] = std::from_chars(digits.data(), last, value);
    if (code != std::errc() || stop != last) return bad(fmt::format("{} is no number", digits));
    return Value(value);
  }

  Result<Value> named() {
    std::size_t end = at_.at;
    while (end < at_.text.size() && in_name(at_.text[end])) ++end;
    const std::string_view name = at_.text.substr(at_.at, end - at_.at);
    if (name.empty()) {
      return bad(at_.done() ? std::string("the expression ends too early")
                            : fmt::format("'{}' is not understood", at_.peek()));
    }
    at_.at = end;
    if (name == "true" || name == "false") return Value(name == "true");
    if (at_.take("(")) return function(name);
    std::size_t index = 0;
    if (at_.take("[")) {
      Result<Value> read = whole();
      if (!read.ok()) return read;
      if (!at_.take("]")) return bad("a ']' is missing");
      const auto* chosen = std::get_if<std::int64_t>(&read.value());
      if (live_ && (chosen == nullptr || *chosen < 0)) return bad("an index is no whole number");
      if (live_) index = static_cast<std::size_t>(*chosen);
    }
    if (!live_) return Value(std::int64_t{1});
    return variable(name, index);
  }

  [[nodiscard]] Result<Value> variable(std::string_view name, std::size_t index) const {
    const Result<std::optional<Variable>> known = lookup_(name, index);
    if (!known.ok()) return known.error();
    if (!known.value()) return bad(fmt::format("{} stands for nothing that is known here", name));
    const Variable& found = *known.value();
    std::string_view digits = found.text;
    if (digits.ends_with('%')) digits.remove_suffix(1);
    if (found.kind == VariableKind::kText || digits.empty()) return Value(found.text);
    double number = 0;
    const char* const last = digits.data() + digits.size();
    const auto [stop, code] = std::from_chars(digits.data(), last, number);
    if (code != std::errc() || stop != last) return Value(found.text);
    if (found.kind == VariableKind::kWhole && std::abs(number) < 9e15 &&
        number == std::trunc(number)) {
      return Value(static_cast<std::int64_t>(number));
    }
    return Value(number);
  }

  Result<Value> function(std::string_view name) {
    std::vector<Value> parts;
    while (!at_.take(")")) {
      if (!parts.empty() && !at_.take(",")) return bad("a ')' is missing");
      if (parts.size() == 3) return bad(fmt::format("{} has too many values", name));
      Result<Value> part = whole();
      if (!part.ok()) return part;
      parts.push_back(std::move(part).value());
    }
    const bool pair = parts.size() == 2;
    if (pair && (name == "min" || name == "max")) {
      const bool first = (order(parts[0], parts[1]) < 0) == (name == "min");
      return parts[first ? 0 : 1];
    }
    if (parts.size() == 1 && (name == "int" || name == "round")) {
      return live_ ? rounded(parts[0], name == "int") : Result<Value>(parts[0]);
    }
    if (parts.size() >= 2 && (name == "digits" || name == "zdigits")) {
      return live_ ? padded(parts, name == "digits" ? ' ' : '0') : Result<Value>(parts[0]);
    }
    return bad(fmt::format("there is no function {} of {} values here", name, parts.size()));
  }

  Cursor& at_;
  const VariableLookup& lookup_;
  bool live_;
  int depth_ = 0;
};

}  // namespace

void Cursor::skip_space() {
  while (!done() && std::string_view(" \t\r\n").find(text[at]) != std::string_view::npos) ++at;
}

bool Cursor::take(std::string_view sign) {
  skip_space();
  if (!text.substr(at).starts_with(sign)) return false;
  at += sign.size();
  return true;
}

bool Cursor::take_word(std::string_view word) {
  skip_space();
  if (!text.substr(at).starts_with(word)) return false;
  if (at + word.size() < text.size() && in_name(text[at + word.size()])) return false;
  at += word.size();
  return true;
}

Result<ExpressionValue> read_expression(Cursor& cursor, const VariableLookup& lookup, bool live) {
  return Reader(cursor, lookup, live).whole();
}

std::string text_of(const ExpressionValue& value) {
  if (const auto* is = std::get_if<bool>(&value)) return *is ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:g}", *number);
  return std::get<std::string>(value);
}

bool holds(const ExpressionValue& value) {
  if (const auto* is = std::get_if<bool>(&value)) return *is;
  const std::optional<double> number = number_of(value);
  return number ? *number != 0 : !std::get<std::string>(value).empty();
}

}  // namespace host
