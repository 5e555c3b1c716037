#include "host/settings/completions.h"

#include <algorithm>

#include "core/check.h"  // RIND_CHECK

namespace host {

std::vector<std::string> shell_names() { return {"bash", "zsh", "fish"}; }

std::string completion_text(const ProgramText& program, const std::vector<SettingRow>& settings,
                            const std::string& shell) {
  if (shell == "bash") return bash_completion(program, settings);
  if (shell == "zsh") return zsh_completion(program, settings);
  RIND_CHECK(shell == "fish");
  return fish_completion(program, settings);
}

std::vector<SharedOption> shared_options(const ProgramText& program) {
  std::vector<SharedOption> shared;
  for (const CommandText& command : program.commands) {
    for (const OptionText& option : command.options) {
      const auto same = std::find_if(shared.begin(), shared.end(), [&](const SharedOption& known) {
        return known.option.names == option.names && known.option.help == option.help &&
               known.option.kind == option.kind;
      });
      if (same == shared.end()) {
        shared.push_back({option, {command.name}});
      } else {
        same->commands.push_back(command.name);
      }
    }
  }
  return shared;
}

std::string joined_words(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

std::vector<std::string> commands_with_operand(const ProgramText& program, ValueKind kind) {
  std::vector<std::string> names;
  for (const CommandText& command : program.commands) {
    if (!command.operands.empty() && command.operands.front().kind == kind) {
      names.push_back(command.name);
    }
  }
  return names;
}

}  // namespace host
