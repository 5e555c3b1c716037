#include "host/gcode/line_meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "firmware_link/wire/gcode_words.h"
#include "firmware_link/wire/line_codec.h"        // take_apart
#include "firmware_link/wire/refused_commands.h"  // refused_in
#include "host/gcode/gcode_numbers.h"
#include "host/gcode/other_commands.h"
#include "host/gcode/ready_moves.h"
#include "host/gcode/set_up_lines.h"

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using firmware_link::Verbatim;

constexpr std::string_view kBlanks = " \t\r\n\v\f";

std::string_view trimmed_line(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

bool has_number(std::string_view text) {
  return text.size() > 1 && (text[0] == 'N' || text[0] == 'n') &&
         (text[1] == ' ' || text[1] == '-' || (text[1] >= '0' && text[1] <= '9'));
}

// Without the file's own line number and checksum.
Result<std::string> without_numbering(std::string_view text) {
  std::string line(text);
  const firmware_link::NumberedText parts = firmware_link::take_apart(line);
  if (parts.checksum && !parts.checksum_matches) {
    return Error{ErrorCode::kBadPart, "its checksum does not fit: the file is damaged"};
  }
  std::string bare = line.substr(0, line.rfind('*'));
  std::size_t at = 1;
  while (at < bare.size() && (bare[at] == ' ' || bare[at] == '-')) ++at;
  while (at < bare.size() && bare[at] >= '0' && bare[at] <= '9') ++at;
  return std::string(trimmed_line(std::string_view(bare).substr(at)));
}

Result<Verbatim> checked_words(std::string_view text, const MeaningRules& rules) {
  auto made = firmware_link::verbatim_from(text);
  if (const auto* why = std::get_if<std::string>(&made)) return Error{ErrorCode::kBadPart, *why};
  if (rules.checks) {
    if (const auto refused = firmware_link::refused_in(text, rules.allowed)) {
      return Error{ErrorCode::kBadPart,
                   fmt::format("{0} {1}; take it out, or allow it with --allow-gcode {0}",
                               refused->command, refused->reason)};
    }
  }
  return std::get<Verbatim>(std::move(made));
}

}  // namespace

Result<std::optional<LineMeaning>> meaning_of(std::string_view text, const MeaningRules& rules,
                                              GcodeModes& modes) {
  std::string bare;
  text = trimmed_line(text);
  if (text.empty()) return std::optional<LineMeaning>();
  const bool plain = firmware_link::is_plain_move(text);
  if (!plain && has_number(text)) {
    Result<std::string> line = without_numbering(text);
    if (!line.ok()) return line.error();
    bare = std::move(line).value();
    text = bare;
  }
  if (!plain && (text == "%" || firmware_link::blank_or_comment(text))) {
    return std::optional<LineMeaning>();
  }
  Result<Verbatim> words =
      plain ? Result<Verbatim>(std::get<Verbatim>(firmware_link::verbatim_from(text)))
            : checked_words(text, rules);
  if (!words.ok()) return words.error();
  LineMeaning meaning;
  meaning.line.words = words.value();
  const std::string_view sent = meaning.line.words.text();
  if (plain) {
    read_move(text[1] - '0', GcodeNumbers(sent.substr(2)), modes, meaning.line);
  } else {
    const std::size_t word_size = firmware_link::command_word_size(sent);
    const std::string command = firmware_link::canonical(sent.substr(0, word_size));
    meaning.macro = read_command({command, sent, sent.substr(word_size), rules.flavor}, modes,
                                 meaning.line) == CommandKnown::kMacro;
    meaning.sets_up = sets_up(command);
  }
  modes.apply(meaning.line);
  return std::optional(meaning);
}

firmware_link::Effect percent_set_by(std::string_view line) {
  using Kind = firmware_link::Effect::Kind;
  GcodeModes modes;
  MeaningRules rules;
  rules.checks = false;
  const Result<std::optional<LineMeaning>> meaning = meaning_of(line, rules, modes);
  if (!meaning.ok() || !meaning.value()) return {};
  const firmware_link::Effect effect = meaning.value()->line.effect;
  const bool percent = effect.kind == Kind::kFeedPercent || effect.kind == Kind::kFlowPercent;
  return percent ? effect : firmware_link::Effect();
}

}  // namespace host
