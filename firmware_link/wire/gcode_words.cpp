#include "firmware_link/wire/gcode_words.h"

#include <algorithm>
#include <iterator>

namespace firmware_link {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_letter(char c) { return capital(c) >= 'A' && capital(c) <= 'Z'; }
bool in_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Where the parenthesis at `at` ends; the text's end when it is never closed.
std::size_t end_of_parenthesis(std::string_view text, std::size_t at) {
  int depth = 0;
  for (; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && --depth == 0) return at + 1;
  }
  return at;
}

std::string without_parentheses(std::string_view text) {
  std::string kept;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '(') {
      at = end_of_parenthesis(text, at);
    } else {
      kept.push_back(text[at++]);
    }
  }
  return kept;
}

// Of a letter and a number, with blanks between them; 0 where there is none.
std::size_t classic_size(std::string_view text) {
  if (text.empty() || !is_letter(text[0])) return 0;
  std::size_t size = 1;
  while (size < text.size() && text[size] == ' ') ++size;
  if (size == text.size() || !is_digit(text[size])) return 0;
  while (size < text.size() && (is_digit(text[size]) || text[size] == '.')) ++size;
  return size;
}

// Letters that start a command in the middle of a line, too. T is a parameter there (M104 T0).
bool starts_command(char letter) { return letter == 'G' || letter == 'M'; }

}  // namespace

std::string without_comments(std::string_view line) {
  std::string text(trim(line.substr(0, line.find(';'))));
  std::replace(text.begin(), text.end(), '\t', ' ');
  while (!text.empty() && text.front() == '(') {
    text = trim(std::string_view(text).substr(end_of_parenthesis(text, 0)));
  }
  if (text.starts_with("//") || text.starts_with('@')) return {};
  const std::string word = canonical(std::string_view(text).substr(0, command_word_size(text)));
  if (carries_text(word)) return text;
  return std::string(trim(without_parentheses(text)));
}

std::size_t command_word_size(std::string_view text) {
  if (const std::size_t size = classic_size(text); size > 0) return size;
  std::size_t size = 0;
  while (size < text.size() && in_name(text[size])) ++size;
  return size > 0 ? size : std::min(text.size(), text.find(' '));
}

bool is_classic(std::string_view command_word) {
  return !command_word.empty() && classic_size(command_word) == command_word.size();
}

std::string canonical(std::string_view command_word) {
  std::string name;
  if (is_classic(command_word)) {
    name.push_back(capital(command_word.front()));
    std::size_t at = command_word.find_first_not_of(' ', 1);
    while (at + 1 < command_word.size() && command_word[at] == '0' &&
           is_digit(command_word[at + 1])) {
      ++at;
    }
    while (at < command_word.size() && is_digit(command_word[at])) name += command_word[at++];
    return name;
  }
  std::transform(command_word.begin(), command_word.end(), std::back_inserter(name), capital);
  return name;
}

bool carries_text(std::string_view canonical_word) {
  constexpr std::string_view kCarriers[] = {"M16",  "M23",  "M30",  "M32",
                                            "M117", "M118", "M486", "M928"};
  return std::find(std::begin(kCarriers), std::end(kCarriers), canonical_word) !=
         std::end(kCarriers);
}

std::vector<std::string> commands_in(std::string_view line) {
  const std::string text = without_comments(line);
  std::vector<std::string> commands;
  std::size_t at = command_word_size(text);
  if (at == 0) return commands;
  const std::string_view word(text.data(), at);
  commands.push_back(canonical(word));
  if (!is_classic(word) || carries_text(commands.front())) return commands;
  bool quoted = false;
  for (; at < text.size(); ++at) {
    if (text[at] == '"') quoted = !quoted;
    if (quoted || !starts_command(capital(text[at])) || is_letter(text[at - 1])) continue;
    const std::string_view rest = std::string_view(text).substr(at);
    if (const std::size_t size = classic_size(rest); size > 0) {
      commands.push_back(canonical(rest.substr(0, size)));
    }
  }
  return commands;
}

bool has_parameter(std::string_view line, char letter) {
  const std::string text = without_comments(line);
  for (std::size_t at = command_word_size(text); at < text.size(); ++at) {
    if (capital(text[at]) == letter && !is_letter(text[at - 1])) return true;
  }
  return false;
}

}  // namespace firmware_link
