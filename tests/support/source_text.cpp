#include "tests/support/source_text.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <utility>

namespace test {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Walks over the text and blanks out what is no code.
class Blanker {
 public:
  explicit Blanker(std::string_view text) : text_(text) {}

  std::string run() {
    while (i_ < text_.size()) step();
    return std::move(text_);
  }

 private:
  void step() {
    const bool line_start = i_ == 0 || text_[i_ - 1] == '\n';
    if (line_start && starts("#")) {
      blank_directive();
    } else if (starts("//")) {
      blank_to(text_.find('\n', i_));
    } else if (starts("/*")) {
      blank_past("*/", 2);
    } else if (starts("R\"") && (i_ == 0 || !is_word(text_[i_ - 1]))) {
      const std::size_t open = text_.find('(', i_);
      blank_past(")" + text_.substr(i_ + 2, open - i_ - 2) + "\"", open - i_);
    } else if (text_[i_] == '"' || (text_[i_] == '\'' && !separates_digits())) {
      blank_quoted(text_[i_]);
    } else {
      ++i_;
    }
  }

  [[nodiscard]] bool starts(std::string_view what) const {
    return std::string_view(text_).substr(i_).starts_with(what);
  }
  // 1'000
  [[nodiscard]] bool separates_digits() const { return i_ > 0 && is_word(text_[i_ - 1]); }

  void blank_to(std::size_t end) {
    for (end = std::min(end, text_.size()); i_ < end; ++i_) {
      if (text_[i_] != '\n') text_[i_] = ' ';
    }
  }
  // Past the first `close` that begins at least `skip` characters from here.
  void blank_past(const std::string& close, std::size_t skip) {
    const std::size_t end = text_.find(close, i_ + skip);
    blank_to(end == std::string::npos ? end : end + close.size());
  }
  void blank_quoted(char quote) {
    std::size_t end = i_ + 1;
    while (end < text_.size() && text_[end] != quote) end += text_[end] == '\\' ? 2 : 1;
    blank_to(end + 1);
  }
  // With the lines that a backslash joins to it.
  void blank_directive() {
    std::size_t end = text_.find('\n', i_);
    while (end != std::string::npos && text_[end - 1] == '\\') end = text_.find('\n', end + 1);
    blank_to(end);
  }

  std::string text_;
  std::size_t i_ = 0;
};

// "namespace core {", "class Region {", "enum class Kind {", "template <…> struct X : Y {"
bool opens_scope(const std::string& head) {
  static const std::regex kScope(
      "^\\s*(template\\s*<[^{]*>\\s*)?(inline\\s+)?(namespace|class|struct|union|enum|extern)\\b");
  // "struct X f() {" would be a function; we write "X f() {".
  return std::regex_search(head, kScope) && head.find('(') == std::string::npos;
}

// "constexpr std::array table = {", but not "bool operator==(…) {" nor "f(int a = 1) {".
bool opens_initialiser(const std::string& head) {
  if (head.find("operator") != std::string::npos) return false;
  int depth = 0;
  for (const char c : head) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == '=' && depth == 0) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<Include> includes_of(std::string_view text) {
  static const std::regex kInclude("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*$");
  std::vector<Include> includes;
  const std::vector<std::string> lines = lines_of(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch match;
    if (lines[i].find("include") == std::string::npos) continue;
    if (!std::regex_match(lines[i], match, kInclude)) continue;
    includes.push_back({i + 1, match[2], match[1] == "\""});
  }
  return includes;
}

std::string code_only(std::string_view text) { return Blanker(text).run(); }

std::vector<Function> functions_of(std::string_view text) {
  std::vector<Function> functions;
  std::size_t scopes = 0;  // namespaces and classes around us
  std::size_t blocks = 0;  // braces open within a function or an initialiser
  bool is_function = false;
  std::string head;
  std::size_t line = 1, head_line = 1;
  for (const char c : code_only(text)) {
    if (c == '\n') ++line;
    if (blocks > 0) {
      if (c == '{') ++blocks;
      if (c == '}' && --blocks == 0 && is_function) functions.push_back({head_line, line});
    } else if (c == '{' && opens_scope(head)) {
      ++scopes;
      head.clear();
    } else if (c == '{') {
      is_function = !opens_initialiser(head);
      blocks = 1;
      head.clear();
    } else if (c == '}') {
      if (scopes > 0) --scopes;
      head.clear();
    } else if (c == ';') {
      head.clear();
    } else if (!head.empty() || std::isspace(static_cast<unsigned char>(c)) == 0) {
      if (head.empty()) head_line = line;
      head += c;
      if (head == "public:" || head == "private:" || head == "protected:") head.clear();
    }
  }
  return functions;
}

}  // namespace test
