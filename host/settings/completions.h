// What bash, zsh and fish need to complete rind's command line: a script in the shell's language.
//
// A script knows the program's words, presets and settings as they were when it was written; ports
// and printers that were set up are looked for when somebody completes.
#pragma once

#include <string>
#include <vector>

#include "host/settings/command_texts.h"
#include "host/settings/settings_table.h"  // SettingRow

namespace host {

[[nodiscard]] std::vector<std::string> shell_names();

// REQUIRES: `shell` is one of shell_names()
[[nodiscard]] std::string completion_text(const ProgramText& program,
                                          const std::vector<SettingRow>& settings,
                                          const std::string& shell);

[[nodiscard]] std::string bash_completion(const ProgramText& program,
                                          const std::vector<SettingRow>& settings);
[[nodiscard]] std::string zsh_completion(const ProgramText& program,
                                         const std::vector<SettingRow>& settings);
[[nodiscard]] std::string fish_completion(const ProgramText& program,
                                          const std::vector<SettingRow>& settings);

// An option, and the commands that have it with the same text.
struct SharedOption {
  OptionText option;
  std::vector<std::string> commands;
};
[[nodiscard]] std::vector<SharedOption> shared_options(const ProgramText& program);

// The words with one space between them.
[[nodiscard]] std::string joined_words(const std::vector<std::string>& words);

// Commands whose operand is of that kind.
[[nodiscard]] std::vector<std::string> commands_with_operand(const ProgramText& program,
                                                             ValueKind kind);

}  // namespace host
