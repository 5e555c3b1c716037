#include "host/settings/documents.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "host/calibration/calibration.h"  // calibration_names
#include "host/presets/presets.h"
#include "host/settings/command_texts.h"
#include "host/settings/completions.h"
#include "host/settings/manual_pages.h"
#include "host/settings/settings_table.h"
#include "host/system/version.h"

namespace host {
namespace {

std::vector<std::string> preset_names(std::optional<PresetKind> kind) {
  std::vector<std::string> names;
  for (const PresetText& preset : preset_texts()) {
    if (!kind || preset.kind == *kind) names.emplace_back(preset.name);
  }
  return names;
}

// Words of options whose value the program itself knows; they may take others, too.
std::vector<std::string> known_words(const std::string& command, const std::string& name) {
  if (name == "--preset") return preset_names(PresetKind::kPrinter);
  if (name == "--filament") return preset_names(PresetKind::kFilament);
  if (name == "--quality") return preset_names(PresetKind::kQuality);
  if (command == "test" && name == "TEST") {
    return {calibration_names().begin(), calibration_names().end()};
  }
  if (command == "presets" && name == "NAME") return preset_names(std::nullopt);
  return {};
}

// "WORD:{warn,stop}" is "WORD" and its words; "N:INT in [1 - 64]" is "N".
void read_type(const std::string& type, OptionText& text) {
  const std::size_t colon = type.find(':');
  text.value = type.substr(0, colon);
  if (colon == std::string::npos || type.substr(colon + 1, 1) != "{") return;
  std::istringstream words(type.substr(colon + 2, type.find('}') - colon - 2));
  for (std::string word; std::getline(words, word, ',');) text.words.push_back(word);
}

ValueKind kind_of(const OptionText& text) {
  const std::string& what = text.value.empty() ? text.names.front() : text.value;
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), what) != names.end();
  };
  if (!text.words.empty()) return ValueKind::kWords;
  if (text.names.front() == "--printer") return ValueKind::kPrinter;
  if (is({"FILE", "OUT", "PART", "JOURNAL", "PROFILE"})) return ValueKind::kFile;
  if (is({"DIR"})) return ValueKind::kFolder;
  if (is({"DEVICE"})) return ValueKind::kPort;
  if (is({"KEY=VALUE"})) return ValueKind::kSetting;
  return ValueKind::kText;
}

OptionText option_text(const std::string& command, const CLI::Option& option) {
  OptionText text;
  const bool operand = option.get_positional();
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (operand) text.names = {option.get_single_name()};
  text.help = option.get_description();
  text.usual = option.get_default_str();
  text.required = option.get_required();
  text.repeatable = option.get_items_expected_max() > 1;
  if (option.get_items_expected_max() == 0) return text;  // a flag
  read_type(option.get_type_name(), text);
  if (text.words.empty()) text.words = known_words(command, text.names.back());
  text.kind = kind_of(text);
  return text;
}

// Groups of options are commands without a name.
void add_options(const CLI::App& app, const std::string& name, CommandText& text) {
  for (const CLI::Option* option : app.get_options()) {
    (option->get_positional() ? text.operands : text.options).push_back(option_text(name, *option));
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (group->get_name().empty()) add_options(*group, name, text);
  }
}

ProgramText program_text(const CLI::App& app) {
  ProgramText program;
  program.about = app.get_description();
  program.version = kVersion;
  CommandText itself;
  add_options(app, "", itself);
  program.options = std::move(itself.options);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandText text{command->get_name(), command->get_description(), {}, {}};
    add_options(*command, text.name, text);
    program.commands.push_back(std::move(text));
  }
  return program;
}

std::string page_of(const ProgramText& program, const std::string& name) {
  std::string list, known;
  for (const ManualPage& page : manual_pages(program, describe_settings(PrintSettings{}))) {
    if (page.name == name) return page.text;
    list += page.name + "\n";
    known += (known.empty() ? "" : ", ") + page.name;
  }
  if (name.empty()) return list;
  throw CLI::ValidationError("PAGE", "there is no page '" + name + "'; there are " + known);
}

}  // namespace

void add_documents(CLI::App& app, DocumentRequest& request) {
  CLI::App* completion =
      app.add_subcommand("completion", "print what a shell needs to complete rind's command line");
  completion->add_option("SHELL", request.shell, "bash, zsh or fish")
      ->required()
      ->type_name("")
      ->check(CLI::IsMember(shell_names()));
  CLI::App* manual =
      app.add_subcommand("manual", "print a manual page, for man; or list the pages");
  manual
      ->add_option("PAGE", request.page, "the page's name, as rind-print.1; without it, list them")
      ->type_name("");
  request.completion = completion;
  request.manual = manual;
}

std::optional<std::string> document_of(const CLI::App& app, const DocumentRequest& request) {
  if (request.completion->parsed()) {
    return completion_text(program_text(app), describe_settings(PrintSettings{}), request.shell);
  }
  if (request.manual->parsed()) return page_of(program_text(app), request.page);
  return std::nullopt;
}

}  // namespace host
