// The commands that print what belongs to the command line itself: manual pages and completions of
// shells. Both are written from the options that the program reads, so they can't be out of date.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace host {

// `rind completion SHELL` and `rind manual [PAGE]`.
struct DocumentRequest {
  std::string shell;  // bash, zsh or fish
  std::string page;   // empty: list the pages
  const CLI::App* completion = nullptr;
  const CLI::App* manual = nullptr;
};

// REQUIRES: `request` lives as long as `app`
void add_documents(CLI::App& app, DocumentRequest& request);

// The text that was asked for; nothing: another command was typed. Throws CLI::ValidationError if
// there is no such page, and names those that are there.
// REQUIRES: all commands were added
[[nodiscard]] std::optional<std::string> document_of(const CLI::App& app,
                                                     const DocumentRequest& request);

}  // namespace host
