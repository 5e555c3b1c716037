#include "host/formats/sif_scanner.h"

#include <cmath>
#include <cstdlib>
#include <optional>

#include "host/formats/format_limits.h"  // kWordBytesMax
#include "host/formats/number_text.h"    // parse_real

namespace host {

using core::Error;
using core::Result;
using core::Status;

// Powers of ten that a double holds exactly.
constexpr std::int64_t kExponentMax = 300;

bool SifScanner::skip_comment() {
  text_.take();
  text_.take();
  for (std::int64_t open = 1; open > 0;) {
    const std::string_view ahead = text_.lookahead(2);
    if (ahead.empty()) return false;
    const bool opens = ahead == "(*", closes = ahead == "*)";
    if (opens || closes) text_.take();
    text_.take();
    open += opens ? 1 : closes ? -1 : 0;
  }
  return true;
}

bool SifScanner::skip_gap() {
  while (true) {
    const int c = text_.skip_blanks();
    if (c == '#') {
      static_cast<void>(text_.rest_of_line());
    } else if (c == '(' && text_.lookahead(2) == "(*") {
      if (!skip_comment()) return false;
    } else {
      return true;
    }
  }
}

Result<SifScanner::Token> SifScanner::next() {
  word_.clear();
  if (!skip_gap()) return text_.cut_short("the end of a comment, '*)',");
  const int c = text_.peek();
  if (c == TextScanner::kEnd) {
    if (text_.failed()) return text_.bad("");
    return Token::kEnd;
  }
  if (c == '(' || c == ')') {
    text_.take();
    return c == '(' ? Token::kOpen : Token::kClose;
  }
  if (c == '"') {
    do {
      if (word_.size() < kWordBytesMax) word_ += static_cast<char>(text_.peek());
      text_.take();
      if (text_.peek() == TextScanner::kEnd) return text_.cut_short("the end of a quoted text");
    } while (text_.peek() != '"');
    text_.take();
    return Token::kWord;
  }
  word_ = text_.word("()#\"");
  if (word_.size() == kWordBytesMax) {
    return text_.bad("'" + shown(word_) + "…' is longer than any word; repair the file");
  }
  return Token::kWord;
}

Error SifScanner::unexpected(Token token, const std::string& wanted) {
  switch (token) {
    case Token::kEnd:
      return text_.cut_short(wanted);
    case Token::kOpen:
      return text_.unexpected("(", wanted);
    case Token::kClose:
      return text_.unexpected(")", wanted);
    case Token::kWord:
      break;
  }
  return text_.unexpected(word_, wanted);
}

Result<std::string> SifScanner::keyword() {
  const Result<Token> token = next();
  if (!token.ok()) return token.error();
  if (token.value() != Token::kWord) return unexpected(token.value(), "a keyword");
  return word_;
}

Status SifScanner::expect_open() {
  const Result<Token> token = next();
  if (!token.ok()) return token.error();
  return token.value() == Token::kOpen ? Status() : unexpected(token.value(), "'('");
}

Status SifScanner::expect_close() {
  const Result<Token> token = next();
  if (!token.ok()) return token.error();
  return token.value() == Token::kClose ? Status() : unexpected(token.value(), "')'");
}

Result<double> SifScanner::number(const std::string& wanted) {
  const Result<Token> token = next();
  if (!token.ok()) return token.error();
  return number(token.value(), wanted);
}

Result<double> SifScanner::number(Token token, const std::string& wanted) {
  if (token == Token::kWord) {
    const std::optional<double> value = parse_real(word_);
    return value ? Result<double>(*value) : unexpected(token, wanted);
  }
  if (token != Token::kOpen) return unexpected(token, wanted);
  const Result<std::string> name = keyword();
  if (!name.ok()) return name.error();
  if (name.value() != "e") return unexpected(Token::kWord, wanted + " as '(e M X)'");
  std::int64_t parts[2] = {0, 0};
  for (std::int64_t& part : parts) {
    const Result<Token> digits = next();
    if (!digits.ok()) return digits.error();
    const std::optional<std::int64_t> value = parse_integer(word_);
    if (!value) return unexpected(digits.value(), "a whole number in '(e M X)'");
    part = *value;
  }
  if (std::abs(parts[1]) > kExponentMax) return bad("(e M X) with X beyond 300; repair the file");
  if (Status closed = expect_close(); !closed.ok()) return closed.error();
  // Divides for negative exponents: powers below 1 are no exact doubles. (e 24 -1) is exactly 2.4.
  const double power = std::pow(10.0, static_cast<double>(std::abs(parts[1])));
  const auto mantissa = static_cast<double>(parts[0]);
  return parts[1] < 0 ? mantissa / power : mantissa * power;
}

Status SifScanner::skip_form() {
  for (std::int64_t open = 1; open > 0;) {
    const Result<Token> token = next();
    if (!token.ok()) return token.error();
    if (token.value() == Token::kEnd) return text_.cut_short("')'");
    open += token.value() == Token::kOpen ? 1 : token.value() == Token::kClose ? -1 : 0;
  }
  return {};
}

}  // namespace host
