#include "firmware_link/command.h"

#include <algorithm>
#include <charconv>

#include "firmware_link/reply.h"  // read_reply: what an M118 would look like

namespace firmware_link {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_letter(char c) { return capital(c) >= 'A' && capital(c) <= 'Z'; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// A letter and a number, as all of classic G-code has it; otherwise it is a named command.
bool is_classic(std::string_view command_word) {
  return command_word.size() >= 2 && is_letter(command_word.front()) &&
         std::all_of(command_word.begin() + 1, command_word.end(),
                     [](char c) { return is_digit(c) || c == '.'; });
}

// Commands whose parameter is a text of the user's, to be left as it is.
bool carries_text(std::string_view command_word) {
  constexpr std::string_view kCarriers[] = {"M16", "M23", "M30", "M32", "M117", "M118", "M928"};
  return std::find(std::begin(kCarriers), std::end(kCarriers), command_word) != std::end(kCarriers);
}

std::size_t command_word_size(std::string_view text) {
  if (text.size() >= 2 && is_letter(text[0]) && is_digit(text[1])) {
    std::size_t size = 1;
    while (size < text.size() && (is_digit(text[size]) || text[size] == '.')) ++size;
    return size;
  }
  return std::min(text.size(), text.find(' '));
}

std::string without_parentheses(std::string_view text) {
  std::string kept;
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (depth == 0) kept.push_back(c);
    if (c == ')' && depth > 0) --depth;
  }
  return std::string(trim(kept));
}

// What is left of a line when comments are gone, in the capitals that it needs.
std::string normalised(std::string_view line) {
  std::string text(trim(line.substr(0, line.find(';'))));
  std::replace(text.begin(), text.end(), '\t', ' ');
  const std::size_t size = command_word_size(text);
  const auto end_of_word = text.begin() + static_cast<std::ptrdiff_t>(size);
  std::transform(text.begin(), end_of_word, text.begin(), capital);
  const std::string command_word = text.substr(0, size);
  if (carries_text(command_word)) return text;
  text = without_parentheses(text);
  if (is_classic(command_word)) std::transform(text.begin(), text.end(), text.begin(), capital);
  return text;
}

// Why a command may not be sent at all; empty when it may.
std::string refusal(std::string_view command_word, std::string_view text) {
  const std::string name(command_word);
  if (text.find("M110") != std::string_view::npos || text.find("m110") != std::string_view::npos) {
    return "M110 sets line numbers, which the link does itself, and controllers obey it even in "
           "a text";
  }
  if (name == "M112" || name == "M410") return name + " stops the controller in mid-print";
  if (name == "M28" || name == "M29") return name + " turns what follows into a file on its card";
  if (name == "M999") return "M999 restarts the controller's queue and loses lines";
  if (name == "M118") {
    const Reply::Kind kind = read_reply(trim(text.substr(command_word.size()))).kind;
    if (kind != Reply::Kind::kUnknown) {
      return "the controller would say a text that reads like an answer of its own";
    }
  }
  return {};
}

}  // namespace

bool blank_or_comment(std::string_view line) { return normalised(line).empty(); }

std::variant<Verbatim, std::string> verbatim_from(std::string_view line) {
  const std::string text = normalised(line);
  if (text.empty()) return std::string("nothing is left of it without its comment");
  for (const char c : text) {
    if (c < ' ' || c > '~') return std::string("it holds a character that is not printable ASCII");
  }
  if (text.size() > kTextBytesMax) {
    return "it has " + std::to_string(text.size()) + " characters, more than the " +
           std::to_string(kTextBytesMax) + " that a controller's line can hold";
  }
  if (!is_letter(text.front())) return std::string("it does not begin with a command word");
  const std::string command_word = text.substr(0, command_word_size(text));
  if (command_word.front() == 'N' && is_classic(command_word)) {
    return std::string("it has a line number of its own; the link numbers lines");
  }
  if (text.find('*') != std::string::npos) {
    return std::string("it holds a *, which begins a checksum");
  }
  if (std::string why = refusal(command_word, text); !why.empty()) return why;
  Verbatim verbatim;
  std::copy(text.begin(), text.end(), verbatim.text_.begin());
  verbatim.size_ = static_cast<std::uint8_t>(text.size());
  return verbatim;
}

}  // namespace firmware_link
