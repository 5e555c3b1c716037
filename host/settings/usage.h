// Help texts, and what is wrong with a command line in words that help.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace host {

// Help is at most this wide.
inline constexpr int kHelpColumns = 100;

// Gives the program and its commands their layout, and the end of every help text.
// REQUIRES: all commands were added.
void lay_out_help(CLI::App& app);

// As `rind help print` is `rind print --help`, and -V is --version. `words`: without the program.
[[nodiscard]] std::vector<std::string> usual_words(std::vector<std::string> words);

// A command or an option that does not exist, before anything else is found wrong: its name, and
// the nearest. Nothing: all are known.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app,
                                                      const std::vector<std::string>& words);

// "Try 'rind slice --help'."
[[nodiscard]] std::string usage_hint(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace host
