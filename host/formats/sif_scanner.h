// Splits SIF and L-SIF into tokens. Their only construct is (keyword field field …).
//
//     (* comments (* nest *) *)   # and end with the line
//     numbers: 12, -0.5, and (e M X) for M · 10^X, both whole: (e 24 -1) is 2.4
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"                // Result, Status
#include "host/files/input_file.h"      // InputFile
#include "host/formats/text_scanner.h"  // TextScanner

namespace host {

class SifScanner {
 public:
  enum class Token { kOpen, kClose, kWord, kEnd };

  explicit SifScanner(InputFile file) : text_(std::move(file)) {}

  // The next token. word() holds a word until the next call.
  [[nodiscard]] core::Result<Token> next();
  [[nodiscard]] const std::string& word() const { return word_; }

  // The form's keyword. REQUIRES: the last token was an opening parenthesis.
  [[nodiscard]] core::Result<std::string> keyword();
  [[nodiscard]] core::Status expect_open();
  [[nodiscard]] core::Status expect_close();
  // A number in either notation. `wanted` is for messages: "a coordinate".
  [[nodiscard]] core::Result<double> number(const std::string& wanted);
  // The same, if next() has already returned its first token.
  [[nodiscard]] core::Result<double> number(Token token, const std::string& wanted);
  // Skips the rest of a form, nested ones too, and its closing parenthesis. COSTS: no memory.
  [[nodiscard]] core::Status skip_form();

  [[nodiscard]] core::Error bad(const std::string& cause) const { return text_.bad(cause); }
  // The error for a token that should not be there. `token`: the last of next().
  [[nodiscard]] core::Error unexpected(Token token, const std::string& wanted);
  [[nodiscard]] const std::string& name() const { return text_.name(); }

 private:
  // Skips blanks and comments; false if a comment does not end.
  [[nodiscard]] bool skip_gap();
  [[nodiscard]] bool skip_comment();

  TextScanner text_;
  std::string word_;
};

}  // namespace host
