// Completions of shells: bash's script is run as bash runs it; the others' list what help lists.
#include "host/settings/completions.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "host/presets/presets.h"
#include "host/settings/options.h"
#include "host/system/exit_codes.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace {

std::string printed(std::vector<const char*> words) {
  words.insert(words.begin(), "rind");
  const auto parsed = host::parse_options(static_cast<int>(words.size()), words.data());
  const auto* exit = std::get_if<host::OptionsExit>(&parsed);
  REQUIRE(exit != nullptr);
  REQUIRE_EQ(exit->exit_code, host::kExitDone);
  return exit->text;
}

std::set<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::set<std::string> words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

// What bash proposes for the last of the words; "=" is a word of its own.
class Bash {
 public:
  Bash() : script_(folder_.write("script", printed({"completion", "bash"}))) {}

  std::set<std::string> proposes(const std::string& words) const {
    const auto run = test::run_program("bash -c '. " + script_ + "; COMP_WORDS=(rind " + words +
                                       "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rind; "
                                       "printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    CHECK_EQ(run.exit_code, 0);
    return words_of(run.output);
  }

 private:
  test::TemporaryFolder folder_;
  std::string script_;
};

using Words = std::set<std::string>;

}  // namespace

TEST_CASE("bash proposes commands, options, and what an option takes") {
  const Bash bash;
  CHECK_EQ(bash.proposes("p"), Words{"print", "plan", "ports", "presets"});
  CHECK_EQ(bash.proposes("print --on-"),
           Words{"--on-bad-layer", "--on-floating", "--on-lost-port"});
  CHECK_EQ(bash.proposes("show part.stl --la"), Words{"--layer", "--layer-height"});
  CHECK_EQ(bash.proposes("print --on-floating \"\""), Words{"warn", "stop"});
  CHECK_EQ(bash.proposes("slice --contents s"), Words{"slices"});
  CHECK_EQ(bash.proposes("plan --wall \"\""), Words{"ball", "cylinder"});
  CHECK_EQ(bash.proposes("plan --set wall_sh"), Words{"wall_shape="});
  CHECK_EQ(bash.proposes("plan --set wall_shape = c"), Words{"cylinder"});
  CHECK_EQ(bash.proposes("plan --set wall_shape ="), Words{"ball", "cylinder"});
  CHECK_EQ(bash.proposes("print --port = v"), Words{"virtual"});
  CHECK_EQ(bash.proposes("print --port v"), Words{"virtual"});
  CHECK_EQ(bash.proposes("print --json --qui"), Words{"--quiet"});
  CHECK_EQ(bash.proposes("completion \"\""), Words{"bash", "zsh", "fish"});
  CHECK_EQ(bash.proposes("help se"), Words{"setup", "settings"});
  // Numbers and unknown things: nothing, and files are bash's own.
  CHECK_EQ(bash.proposes("print --baud \"\""), Words{});
  CHECK_EQ(bash.proposes("print pa"), Words{});
  CHECK_EQ(bash.proposes("nonsense --la"), Words{});
}

TEST_CASE("bash proposes presets") {
  const Bash bash;
  Words filaments;
  for (const host::PresetText& preset : host::preset_texts()) {
    if (preset.kind == host::PresetKind::kFilament) filaments.emplace(preset.name);
  }
  CHECK_GT(filaments.size(), 2);
  CHECK_EQ(bash.proposes("print --filament \"\""), filaments);
}

TEST_CASE("printers are the files of the user's folder") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("rind"));
  folder.write("rind/attic.ini", "");
  folder.write("rind/attic.ini.old", "");
  const std::string script = folder.write("script", printed({"completion", "bash"}));
  const auto run = test::run_program("XDG_CONFIG_HOME='" + folder.path() + "' bash -c '. " +
                                     script + "; _rind_printers'");
  CHECK_EQ(words_of(run.output), Words{"none", "attic"});
}

TEST_CASE("every shell's script knows all options that help lists") {
  const std::string bash = printed({"completion", "bash"}), zsh = printed({"completion", "zsh"}),
                    fish = printed({"completion", "fish"});
  const Words in_bash = words_of(bash);
  std::size_t count = 0;
  for (const char* command : {"setup", "print", "resume", "slice", "plan", "show", "settings"}) {
    std::istringstream help(printed({command, "--help"}));
    for (std::string line; std::getline(help, line);) {
      const std::size_t at = line.find("--");
      if (line.rfind("  ", 0) != 0 || at == std::string::npos || at > 5) continue;
      const std::string name = line.substr(at, line.find_first_of(" ,[", at) - at);
      CAPTURE(name);
      ++count;
      CHECK((in_bash.count(name) > 0 || in_bash.count(name + "'") > 0));
      CHECK((zsh.find(name + "[") != std::string::npos ||
             zsh.find(name + "=[") != std::string::npos));
      CHECK_NE(fish.find(" -l " + name.substr(2) + " "), std::string::npos);
    }
  }
  CHECK_GT(count, 100);
}

TEST_CASE("quotes, brackets and colons of a help text are no signs of the shell") {
  host::ProgramText program;
  program.commands = {{"go", "it's a [way]: on", {}, {}}};
  program.commands[0].options = {
      {{"--far"}, "N", host::ValueKind::kText, {}, "how far: it's [m] \\", "", false, false}};
  const auto at = [&](const std::string& shell, const std::string& text) {
    return host::completion_text(program, {}, shell).find(text);
  };
  CHECK_NE(at("zsh", R"('(--far)--far=[how far\: it'\''s \[m\] \\]:N: ')"), std::string::npos);
  CHECK_NE(at("zsh", R"('go:it'\''s a \[way\]\: on')"), std::string::npos);
  CHECK_NE(at("fish", R"(-l far -x -d 'how far: it\'s [m] \\')"), std::string::npos);
}
