#include "firmware_link/wire/command.h"

#include <algorithm>

#include "firmware_link/wire/gcode_words.h"
#include "firmware_link/wire/refused_commands.h"
#include "firmware_link/wire/reply.h"  // read_reply: what an M118 would look like

namespace firmware_link {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool is_letter(char c) { return capital(c) >= 'A' && capital(c) <= 'Z'; }

std::string capitals(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), capital);
  return result;
}

// The same, but for what stands between quotation marks: M862.3 P"name".
std::string capitals_outside_quotes(std::string_view text) {
  std::string result(text);
  bool quoted = false;
  for (char& c : result) {
    if (c == '"') quoted = !quoted;
    if (!quoted) c = capital(c);
  }
  return result;
}

// What is left of a line when comments are gone, in the capitals that it needs. Names stay as they
// are: Klipper takes any, and Prusa's Tx and Tc are none in capitals.
std::string normalised(std::string_view line) {
  std::string text = without_comments(line);
  const std::size_t size = command_word_size(text);
  const std::string command_word = capitals(std::string_view(text).substr(0, size));
  if (!is_classic(command_word)) return text;
  if (!carries_text(canonical(command_word))) return capitals_outside_quotes(text);
  return command_word + text.substr(size);
}

// "N12 …", "N 12", "N-1": the link numbers lines.
bool numbers_itself(std::string_view text) {
  if (!text.starts_with('N')) return false;
  const std::size_t next = text.find_first_not_of(" +-", 1);
  return next != std::string_view::npos && is_digit(text[next]);
}

// A text that the controller would say, so that it reads like an answer of its own.
bool feigns_answer(std::string_view text) {
  const std::string command_word = canonical(text.substr(0, command_word_size(text)));
  if (command_word == "M118") {
    std::string_view words = text.substr(command_word_size(text));
    words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
    return read_reply(words).kind != Reply::Kind::kUnknown;
  }
  if (command_word != "RESPOND") return false;
  const std::string all = capitals(text);
  return all.find("TYPE=ERROR") != std::string::npos || all.find("PREFIX=") != std::string::npos;
}

// Why a command may not be sent at all; empty when it may.
std::string refusal(std::string_view text) {
  if (capitals(text).find("M110") != std::string::npos) {
    return "M110 " + std::string(refused_command("M110")->reason);
  }
  if (feigns_answer(text)) {
    return "the controller would say a text that reads like an answer of its own";
  }
  if (commands_in(text).front() == "M555" && has_parameter(text, 'P')) {
    return "M555 P changes the language in which the controller answers";
  }
  for (const std::string& command : commands_in(text)) {
    const std::optional<RefusedCommand> refused = refused_command(command);
    if (refused && refused->never) return command + " " + std::string(refused->reason);
  }
  return {};
}

}  // namespace

bool blank_or_comment(std::string_view line) { return normalised(line).empty(); }

bool is_plain_move(std::string_view line) {
  constexpr std::string_view kLetters = "XYZEFIJ";
  if (line.size() < 4 || line.size() > kTextBytesMax || line[0] != 'G') return false;
  if (line[1] < '0' || line[1] > '3' || line[2] != ' ') return false;
  char before = ' ';
  for (const char c : line.substr(3)) {
    const bool after_blank = before == ' ';
    before = c;
    if (is_digit(c) || c == '.' || c == '-') continue;
    if (after_blank ? kLetters.find(c) == std::string_view::npos : c != ' ') return false;
  }
  return before != ' ';
}

std::variant<Verbatim, std::string> verbatim_from(std::string_view line) {
  if (is_plain_move(line)) {
    Verbatim verbatim;
    std::copy(line.begin(), line.end(), verbatim.text_.begin());
    verbatim.size_ = static_cast<std::uint8_t>(line.size());
    return verbatim;
  }
  const std::string text = normalised(line);
  if (text.empty()) return std::string("nothing is left of it without its comment");
  for (const char c : text) {
    if (c < ' ' || c > '~') return std::string("it holds a character that is not printable ASCII");
  }
  if (text.size() > kTextBytesMax) {
    return "it has " + std::to_string(text.size()) + " characters, more than the " +
           std::to_string(kTextBytesMax) + " that a controller's line can hold";
  }
  if (!is_letter(text.front())) return std::string("it does not start with a command word");
  if (numbers_itself(text)) {
    return std::string("it has a line number of its own; the link numbers lines");
  }
  if (text.find('*') != std::string::npos) {
    return std::string("it holds a *, which starts a checksum");
  }
  if (std::string why = refusal(text); !why.empty()) return why;
  Verbatim verbatim;
  std::copy(text.begin(), text.end(), verbatim.text_.begin());
  verbatim.size_ = static_cast<std::uint8_t>(text.size());
  return verbatim;
}

}  // namespace firmware_link
