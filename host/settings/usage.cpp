#include "host/settings/usage.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "host/settings/near_words.h"
#include "host/system/exit_codes.h"

namespace host {
namespace {

constexpr std::size_t kNameColumns = 30;

std::string exit_codes() {
  std::string text;
  for (const ExitText& exit : kExitTexts) {
    text += fmt::format("{} {} {}", text.empty() ? "Exit codes:" : ",", exit.code, exit.meaning);
  }
  return text + ".";
}

// The text in lines, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t columns) {
  std::string out;
  std::size_t used = indent, begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    if (used > indent && used + 1 + word.size() > columns) {
      out += "\n" + std::string(indent, ' ');
      used = indent;
    }
    if (used > indent) out += ' ', ++used;
    out += word;
    used += word.size();
  }
  return out;
}

// Lines of at most kHelpColumns, and what an option is if it is not given.
class Layout final : public CLI::Formatter {
 public:
  Layout() { column_width(kNameColumns); }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const std::string name = "  " + make_option_name(option, is_positional) + options_of(option);
    std::string text = option->get_description();
    if (const std::string usual = option->get_default_str(); !usual.empty()) {
      text += " (default: " + usual + ")";
    }
    const std::string gap = name.size() + 1 < kNameColumns
                                ? std::string(kNameColumns - name.size(), ' ')
                                : "\n" + std::string(kNameColumns, ' ');
    return name + gap + wrapped(text, kNameColumns, kHelpColumns) + "\n";
  }

  std::string make_description(const CLI::App* app) const override {
    return wrapped(app->get_description(), 0, kHelpColumns) + "\n";
  }

  std::string make_footer(const CLI::App* app) const override {
    return wrapped(app->get_footer(), 0, kHelpColumns) + "\n";
  }

 private:
  // Its value's name, without the range that CLI11 adds.
  static std::string options_of(const CLI::Option* option) {
    const std::string type = option->get_type_name();
    if (option->get_type_size() == 0 || type.empty()) return {};
    return " " + type.substr(0, type.find(':'));
  }
};

bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

std::string option_name(const std::string& word) { return word.substr(0, word.find('=')); }

// The command that the words begin with; null: none.
const CLI::App* command_of(const CLI::App& app, const std::vector<std::string>& words) {
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!words.empty() && command->get_name() == words.front()) return command;
  }
  return nullptr;
}

std::string nearest_option(const CLI::App& command, const std::string& typed) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  NearestWord nearest(typed);
  for (const std::string& name : names) nearest.look_at(name);
  return std::string(nearest.word());
}

// Whether the word before is an option that takes it.
bool is_value(const CLI::App& command, const std::string& before) {
  if (before.rfind("--", 0) != 0 || before.find('=') != std::string::npos) return false;
  const CLI::Option* option = command.get_option_no_throw(before);
  return option != nullptr && option->get_items_expected_max() > 0;
}

std::string no_such_command(const CLI::App& app, const std::string& typed) {
  std::string known;
  NearestWord nearest(typed);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known += (known.empty() ? "" : ", ") + command->get_name();
    nearest.look_at(command->get_name());
  }
  return fmt::format("'{}' is not a command; {}there are {}", typed,
                     nearest.word().empty() ? "" : fmt::format("did you mean {}? ", nearest.word()),
                     known);
}

}  // namespace

void lay_out_help(CLI::App& app) {
  const auto layout = std::make_shared<Layout>();
  app.formatter(layout);
  app.footer(std::string("rind COMMAND --help, or rind help COMMAND, lists a command's options. ") +
             exit_codes());
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->formatter(layout);
    const bool sets = command->get_option_no_throw("--set") != nullptr;
    command->footer(
        std::string(sets ? "rind settings lists all settings (KEY), with unit, range and "
                           "default. "
                         : "") +
        exit_codes());
  }
}

std::vector<std::string> usual_words(std::vector<std::string> words) {
  if (words.empty()) return {"--help"};
  if (words.front() == "-V" || words.front() == "-v" || words.front() == "version") {
    words.front() = "--version";
  }
  if (words.front() != "help") return words;
  if (words.size() == 1) return {"--help"};
  return {words[1], "--help"};
}

std::optional<std::string> unknown_word(const CLI::App& app,
                                        const std::vector<std::string>& words) {
  const CLI::App* command = command_of(app, words);
  if (command == nullptr) {
    if (words.empty() || is_option(words.front())) return std::nullopt;
    return no_such_command(app, words.front());
  }
  for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
    const std::string& word = words[i];
    if (!is_option(word) || is_value(*command, words[i - 1])) continue;
    const std::string name = option_name(word);
    if (word.rfind("--", 0) != 0) {
      // -o.gcode is an option and its value.
      if (command->get_option_no_throw(word.substr(0, 2)) != nullptr) continue;
      return fmt::format("there is no option {}; a file of that name is ./{}", word, word);
    }
    if (command->get_option_no_throw(name) != nullptr) continue;
    const std::string nearest = nearest_option(*command, name);
    return fmt::format("rind {} has no option {}{}", words.front(), name,
                       nearest.empty() ? "" : "; did you mean " + nearest + "?");
  }
  return std::nullopt;
}

std::string usage_hint(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* command = command_of(app, words);
  return fmt::format("Try 'rind {}--help'.", command == nullptr ? "" : command->get_name() + " ");
}

}  // namespace host
