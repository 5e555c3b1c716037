// Just enough C++ to see lines, includes and functions in formatted code.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace test {

// Without their line ends; a last line without one counts too.
std::vector<std::string> lines_of(std::string_view text);

struct Include {
  std::size_t line = 0;  // from 1
  std::string name;
  bool quoted = false;  // "…", otherwise <…>
};
std::vector<Include> includes_of(std::string_view text);

// The text with comments, strings, characters and preprocessor lines blanked out: what is left has
// the same lines, and its braces are code's.
std::string code_only(std::string_view text);

struct Function {
  std::size_t first_line = 0;  // of its head
  std::size_t last_line = 0;   // of its closing brace
};
// Every block with braces in a namespace or a class that is neither of them, nor an initialiser.
// Lambdas belong to the function around them.
std::vector<Function> functions_of(std::string_view text);

}  // namespace test
