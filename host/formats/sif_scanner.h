// The words of SIF and L-SIF: one construct, (keyword field field …).
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

  // A word is in word() until the next call.
  [[nodiscard]] core::Result<Token> next();
  [[nodiscard]] const std::string& word() const { return word_; }

  // After an opening one: the form's keyword.
  [[nodiscard]] core::Result<std::string> keyword();
  [[nodiscard]] core::Status expect_open();
  [[nodiscard]] core::Status expect_close();
  // A number in either way of writing. `wanted` is for messages: "a coordinate".
  [[nodiscard]] core::Result<double> number(const std::string& wanted);
  // The same, where `token` is what next() gave last.
  [[nodiscard]] core::Result<double> number(Token token, const std::string& wanted);
  // The rest of a form, nested ones too, with its closing parenthesis. COSTS: no memory.
  [[nodiscard]] core::Status skip_form();

  [[nodiscard]] core::Error bad(const std::string& cause) const { return text_.bad(cause); }
  // What next() gave last is not what should be there.
  [[nodiscard]] core::Error unexpected(Token token, const std::string& wanted);
  [[nodiscard]] const std::string& name() const { return text_.name(); }

 private:
  // Nothing but blanks and comments; false where a comment does not end.
  [[nodiscard]] bool skip_gap();
  [[nodiscard]] bool skip_comment();

  TextScanner text_;
  std::string word_;
};

}  // namespace host
