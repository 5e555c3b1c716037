#include <fmt/format.h>

#include <string>
#include <vector>

#include "host/settings/completions.h"

namespace host {
namespace {

constexpr const char* kZshHead = R"(#compdef rind
# Completion of rind for zsh, written by: rind completion zsh

_rind_ports() {
  local -a ports
  ports=(virtual /dev/ttyUSB*(N) /dev/ttyACM*(N) /dev/serial/by-id/*(N))
  compadd -a ports
}

_rind_printers() {
  local -a printers
  printers=(none ${XDG_CONFIG_HOME:-$HOME/.config}/rind/*.ini(N:t:r))
  compadd -a printers
}

)";

// A shell's word between quotes, in which a specification's own signs are no signs.
std::string zsh_quoted(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\'') {
      out += "'\\''";
      continue;
    }
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') out += '\\';
    out += letter;
  }
  return out;
}

std::string zsh_action(const OptionText& option) {
  switch (option.kind) {
    case ValueKind::kNone:
    case ValueKind::kText:
      break;
    case ValueKind::kWords:
      return "(" + joined_words(option.words) + ")";
    case ValueKind::kFile:
      return "_files";
    case ValueKind::kFolder:
      return "_files -/";
    case ValueKind::kPort:
      return "_rind_ports";
    case ValueKind::kPrinter:
      return "_rind_printers";
    case ValueKind::kSetting:
      return "_rind_settings";
  }
  return " ";  // nothing is proposed
}

std::string zsh_settings(const std::vector<SettingRow>& settings) {
  std::string keys, cases;
  for (const SettingRow& row : settings) {
    keys += (keys.empty() ? "" : " ") + row.key;
    const std::vector<std::string> words = setting_words(row.key);
    if (words.empty()) continue;
    cases += fmt::format("      {}) compadd -- {} ;;\n", row.key, joined_words(words));
  }
  return "_rind_settings() {\n  local key=${PREFIX%%=*}\n  if compset -P '*='; then\n"
         "    case $key in\n" +
         cases + "    esac\n  else\n    compadd -S = -- " + keys + "\n  fi\n}\n\n";
}

// One specification a name; a name excludes its others.
std::string specifications(const std::vector<OptionText>& options) {
  std::string text;
  for (const OptionText& option : options) {
    const bool help = option.names.back() == "--help" || option.names.back() == "--version";
    const std::string before = help                ? "(- *)"
                               : option.repeatable ? "*"
                                                   : "(" + joined_words(option.names) + ")";
    for (const std::string& name : option.names) {
      const bool valued = option.kind != ValueKind::kNone;
      const std::string sign = !valued ? "" : name.rfind("--", 0) == 0 ? "=" : "+";
      text += fmt::format(" \\\n        '{}{}{}[{}]", before, name, sign, zsh_quoted(option.help));
      if (valued) text += fmt::format(":{}:{}", zsh_quoted(option.value), zsh_action(option));
      text += "'";
    }
  }
  return text;
}

std::string command_case(const CommandText& command) {
  std::string text = fmt::format("      {})\n      _arguments -s{}", command.name,
                                 specifications(command.options));
  for (const OptionText& operand : command.operands) {
    text += fmt::format(" \\\n        '{}:{}:{}'",
                        operand.required ? "1" : "1:", zsh_quoted(operand.names.front()),
                        zsh_action(operand));
  }
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(const ProgramText& program, const std::vector<SettingRow>& settings) {
  std::string list, cases;
  std::vector<std::string> names;
  for (const CommandText& command : program.commands) {
    list += fmt::format("        '{}:{}'\n", command.name, zsh_quoted(command.help));
    cases += command_case(command);
    names.push_back(command.name);
  }
  return kZshHead + zsh_settings(settings) +
         "_rind() {\n  local curcontext=$curcontext state line\n  typeset -A opt_args\n"
         "  _arguments -C" +
         specifications(program.options) +
         " \\\n        '1:command:->command' '*::argument:->argument'\n  case $state in\n"
         "    command)\n      local -a commands\n      commands=(\n" +
         list +
         "        'help:list the options of a command'\n      )\n"
         "      _describe command commands ;;\n    argument)\n      case $words[1] in\n" +
         cases + fmt::format("      help) _arguments '1:command:({})' ;;\n", joined_words(names)) +
         "      esac ;;\n  esac\n}\n\n"
         "if [[ $funcstack[1] == _rind ]]; then\n  _rind \"$@\"\nelse\n  compdef _rind rind\nfi\n";
}

}  // namespace host
