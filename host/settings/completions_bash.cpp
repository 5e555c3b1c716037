#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/settings/completions.h"

namespace host {
namespace {

constexpr const char* kBashHead = R"(# Completion of rind for bash, written by: rind completion bash

_rind_ports() {
  printf '%s\n' virtual
  compgen -G '/dev/ttyUSB*'
  compgen -G '/dev/ttyACM*'
  compgen -G '/dev/serial/by-id/*'
}

_rind_printers() {
  local file
  printf '%s\n' none
  for file in "${XDG_CONFIG_HOME:-$HOME/.config}"/rind/*.ini; do
    file=${file##*/}
    [[ $file == '*.ini' ]] || printf '%s\n' "${file%.ini}"
  done
}

# The words that begin with what is typed, and no files.
_rind_words() {
  compopt +o default 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}

_rind() {
  local typed=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} joined='' options=''
  local before=$((COMP_CWORD - 1))
  COMPREPLY=()
  # bash takes '=' for a word of its own: --port = DEVICE, --set KEY = VALUE.
  if [[ $typed == = ]]; then
    typed='' joined=1
  elif [[ ${COMP_WORDS[before]} == = ]]; then
    before=$((before - 1)) joined=1
  fi
  local option=${COMP_WORDS[before]}
)";

// What is done for a value. Files are completed by bash itself.
std::string bash_action(const OptionText& option) {
  switch (option.kind) {
    case ValueKind::kNone:
      break;
    case ValueKind::kText:
      return "_rind_words '' \"$typed\"";
    case ValueKind::kWords:
      return "_rind_words '" + joined_words(option.words) + "' \"$typed\"";
    case ValueKind::kFile:
      return ":";
    case ValueKind::kFolder:
      return "compopt +o default -o dirnames 2>/dev/null";
    case ValueKind::kPort:
      return "_rind_words \"$(_rind_ports)\" \"$typed\"";
    case ValueKind::kPrinter:
      return "_rind_words \"$(_rind_printers)\" \"$typed\"";
    case ValueKind::kSetting:
      return "_rind_words \"$settings\" \"$typed\"; compopt -o nospace 2>/dev/null";
  }
  return {};
}

using Cases = std::vector<std::pair<std::string, std::vector<std::string>>>;  // action, patterns

void add_case(Cases& cases, const std::string& what, const std::string& pattern) {
  const auto same =
      std::find_if(cases.begin(), cases.end(), [&](const auto& one) { return one.first == what; });
  if (same == cases.end()) {
    cases.push_back({what, {pattern}});
    return;
  }
  auto& patterns = same->second;
  if (std::find(patterns.begin(), patterns.end(), pattern) == patterns.end()) {
    patterns.push_back(pattern);
  }
}

std::string written(const Cases& cases, const std::string& end) {
  std::string text;
  for (const auto& [what, patterns] : cases) {
    std::string all;
    for (const std::string& pattern : patterns) all += (all.empty() ? "" : "|") + pattern;
    text += fmt::format("    {}) {}{} ;;\n", all, what, end);
  }
  return text;
}

std::string setting_values(const std::vector<SettingRow>& settings) {
  Cases cases;
  for (const SettingRow& row : settings) {
    const std::vector<std::string> words = setting_words(row.key);
    if (!words.empty()) {
      add_case(cases, "_rind_words '" + joined_words(words) + "' \"$typed\"", row.key);
    }
  }
  return "  if [[ $joined && $option != -* ]]; then\n    case $option in\n" + written(cases, "") +
         "    *) _rind_words '' \"$typed\" ;;\n    esac\n    return\n  fi\n";
}

std::string option_values(const ProgramText& program, const std::vector<SettingRow>& settings) {
  std::string keys;
  for (const SettingRow& row : settings) keys += (keys.empty() ? "" : " ") + row.key + "=";
  Cases cases;
  for (const SharedOption& shared : shared_options(program)) {
    if (shared.option.kind == ValueKind::kNone) continue;
    for (const std::string& name : shared.option.names) {
      add_case(cases, bash_action(shared.option), name);
    }
  }
  return "  local settings='" + keys + "'\n  case $option in\n" + written(cases, "; return") +
         "  esac\n";
}

}  // namespace

std::string bash_completion(const ProgramText& program, const std::vector<SettingRow>& settings) {
  std::vector<std::string> commands, flags;
  Cases options, operands;
  for (const CommandText& command : program.commands) {
    commands.push_back(command.name);
    std::vector<std::string> names;
    for (const OptionText& option : command.options) {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
    add_case(options, "options='" + joined_words(names) + "'", command.name);
    if (command.operands.empty()) continue;
    add_case(operands, bash_action(command.operands.front()), command.name);
  }
  for (const OptionText& option : program.options) {
    flags.insert(flags.end(), option.names.begin(), option.names.end());
  }
  const std::string all = joined_words(commands);
  return kBashHead +
         fmt::format(
             "  if [[ $COMP_CWORD -eq 1 ]]; then\n    _rind_words '{} help {}' \"$typed\"\n"
             "    return\n  fi\n",
             all, joined_words(flags)) +
         setting_values(settings) + option_values(program, settings) + "  case $command in\n" +
         written(options, "") +
         "  esac\n  if [[ $typed == -* ]]; then\n    _rind_words \"$options\" \"$typed\"\n"
         "    return\n  fi\n  case $command in\n" +
         written(operands, "") + fmt::format("    help) _rind_words '{}' \"$typed\" ;;\n", all) +
         "    *) _rind_words '' \"$typed\" ;;\n  esac\n}\n\ncomplete -o default -F _rind rind\n";
}

}  // namespace host
