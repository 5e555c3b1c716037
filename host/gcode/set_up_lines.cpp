#include "host/gcode/set_up_lines.h"

#include <algorithm>
#include <array>
#include <utility>

#include "firmware_link/wire/gcode_words.h"  // canonical, command_word_size
#include "firmware_link/wire/limits.h"       // kTextBytesMax

namespace host {
namespace {

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

// What a later line takes the place of: a letter of "P800", a name of "ADVANCE=0.04".
std::string_view key_of(std::string_view parameter) {
  const std::size_t equals = parameter.find('=');
  return equals == std::string_view::npos ? parameter.substr(0, 1) : parameter.substr(0, equals);
}

std::vector<std::string_view> parameters_of(std::string_view text, bool classic) {
  std::vector<std::string_view> parameters;
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] == ' ') {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != ' ' && !(classic && is_letter(text[end]))) ++end;
    parameters.push_back(text.substr(at, end - at));
    at = end;
  }
  return parameters;
}

std::string merged(std::string_view before, std::string_view line, std::size_t word_size,
                   bool classic) {
  std::vector<std::string_view> all =
      parameters_of(before.substr(std::min(before.size(), word_size)), classic);
  for (const std::string_view later : parameters_of(line.substr(word_size), classic)) {
    const auto same = std::find_if(
        all.begin(), all.end(), [&](std::string_view one) { return key_of(one) == key_of(later); });
    if (same != all.end()) {
      *same = later;
    } else {
      all.push_back(later);
    }
  }
  std::string text(line.substr(0, word_size));
  for (const std::string_view one : all) text.append(" ").append(one);
  return text;
}

}  // namespace

bool sets_up(std::string_view command) {
  constexpr std::array<std::string_view, 26> kCommands = {
      "G17",  "G18",  "G19",  "M92",  "M200", "M201", "M203", "M204", "M205",
      "M206", "M207", "M208", "M209", "M211", "M218", "M220", "M221", "M301",
      "M304", "M412", "M413", "M420", "M425", "M566", "M572", "M900"};
  constexpr std::array<std::string_view, 3> kNames = {"SET_PRESSURE_ADVANCE", "SET_VELOCITY_LIMIT",
                                                      "SET_GCODE_OFFSET"};
  return std::find(kCommands.begin(), kCommands.end(), command) != kCommands.end() ||
         std::find(kNames.begin(), kNames.end(), command) != kNames.end();
}

SetUpLines::SetUpLines(std::string_view text) : text_(text) {}

std::vector<std::string> SetUpLines::lines() const {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text_.size();) {
    const std::size_t end = text_.find('\n', at);
    lines.push_back(text_.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

void SetUpLines::add(std::string_view line) {
  const std::size_t word_size = firmware_link::command_word_size(line);
  const std::string_view word = line.substr(0, word_size);
  const bool classic = firmware_link::is_classic(word);
  // The three planes of arcs take each other's place.
  const auto kind = [](std::string_view of) {
    const std::string name = firmware_link::canonical(of);
    return name == "G18" || name == "G19" ? std::string("G17") : name;
  };
  std::string before;
  std::string text;
  for (const std::string& one : lines()) {
    const std::string_view one_word =
        std::string_view(one).substr(0, firmware_link::command_word_size(one));
    if (kind(one_word) == kind(word)) {
      before = one_word.size() == word_size ? one : std::string();
    } else {
      text += one + '\n';
    }
  }
  std::string whole = merged(before, line, word_size, classic);
  // In a line that can be sent.
  if (whole.size() > firmware_link::kTextBytesMax) whole = std::string(line), left_out_ = true;
  if (text.size() + whole.size() + 1 > kSetUpBytesMax) {
    left_out_ = true;
    return;
  }
  text_ = text + whole + '\n';
}

}  // namespace host
