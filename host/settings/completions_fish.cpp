#include <fmt/format.h>

#include <string>
#include <vector>

#include "host/settings/completions.h"

namespace host {
namespace {

constexpr const char* kFishHead = R"(# Completion of rind for fish, written by: rind completion fish

function __rind_needs_command
    test (count (commandline -opc)) -eq 1
end

function __rind_command
    set -l words (commandline -opc)
    test (count $words) -gt 1; and contains -- $words[2] $argv
end

function __rind_ports
    echo virtual
    for pattern in /dev/ttyUSB /dev/ttyACM /dev/serial/by-id/
        for port in $pattern*
            echo $port
        end
    end
end

function __rind_printers
    echo none
    set -l folder $HOME/.config
    set -q XDG_CONFIG_HOME; and set folder $XDG_CONFIG_HOME
    for file in $folder/rind/*.ini
        basename $file .ini
    end
end

)";

std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char letter : text) {
    if (letter == '\'' || letter == '\\') out += '\\';
    out += letter;
  }
  return out + "'";
}

// What may stand behind the option: -x no files, -r -F files.
std::string fish_action(const OptionText& option) {
  switch (option.kind) {
    case ValueKind::kNone:
      break;
    case ValueKind::kText:
      return " -x";
    case ValueKind::kWords:
      return " -x -a " + fish_quoted(joined_words(option.words));
    case ValueKind::kFile:
      return " -r -F";
    case ValueKind::kFolder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::kPort:
      return " -x -a '(__rind_ports)'";
    case ValueKind::kPrinter:
      return " -x -a '(__rind_printers)'";
    case ValueKind::kSetting:
      return " -x -a '(__rind_settings)'";
  }
  return {};
}

std::string fish_names(const OptionText& option) {
  std::string text;
  for (const std::string& name : option.names) {
    text += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return text;
}

std::string in_commands(const std::vector<std::string>& commands) {
  return "complete -c rind -n " + fish_quoted("__rind_command " + joined_words(commands));
}

std::string fish_settings(const std::vector<SettingRow>& settings) {
  std::string text = "function __rind_settings\n    printf '%s\\n'";
  for (const SettingRow& row : settings) {
    const std::vector<std::string> words = setting_words(row.key);
    if (words.empty()) text += " " + row.key + "=";
    for (const std::string& word : words) text += " " + row.key + "=" + word;
  }
  return text + "\nend\n\n";
}

}  // namespace

std::string fish_completion(const ProgramText& program, const std::vector<SettingRow>& settings) {
  std::string text = kFishHead + fish_settings(settings) + "complete -c rind -f\n";
  std::vector<std::string> names;
  for (const CommandText& command : program.commands) {
    text += fmt::format("complete -c rind -n __rind_needs_command -a {} -d {}\n", command.name,
                        fish_quoted(command.help));
    names.push_back(command.name);
  }
  text += "complete -c rind -n __rind_needs_command -a help -d 'list the options of a command'\n";
  text += in_commands({"help"}) + " -a " + fish_quoted(joined_words(names)) + "\n";
  for (const OptionText& option : program.options) {
    text += "complete -c rind -n __rind_needs_command" + fish_names(option) + " -d " +
            fish_quoted(option.help) + "\n";
  }
  for (const SharedOption& shared : shared_options(program)) {
    text += in_commands(shared.commands) + fish_names(shared.option) + fish_action(shared.option) +
            " -d " + fish_quoted(shared.option.help) + "\n";
  }
  for (const CommandText& command : program.commands) {
    if (command.operands.empty()) continue;
    const OptionText& operand = command.operands.front();
    if (operand.kind != ValueKind::kWords) continue;
    text += in_commands({command.name}) + " -a " + fish_quoted(joined_words(operand.words)) + "\n";
  }
  const std::vector<std::string> files = commands_with_operand(program, ValueKind::kFile);
  return files.empty() ? text : text + in_commands(files) + " -F\n";
}

}  // namespace host
