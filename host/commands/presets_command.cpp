#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/commands/commands.h"
#include "host/presets/presets.h"
#include "host/system/exit_codes.h"

namespace host {
namespace {

// Of any kind; nothing: there is none of that name.
std::optional<PresetText> preset_text(const std::string& name) {
  for (const PresetText& one : preset_texts()) {
    if (one.name == name) return one;
  }
  return std::nullopt;
}

std::string title_of(const PresetText& one) {
  const core::Result<Preset> preset = find_preset(one.kind, one.name);
  return preset.ok() ? preset.value().title : preset.error().message;
}

std::string list_text() {
  std::string text;
  std::optional<PresetKind> kind;
  for (const PresetText& one : preset_texts()) {
    if (kind != one.kind) {
      const std::string flag =
          one.kind == PresetKind::kPrinter ? "preset" : std::string(preset_kind_word(one.kind));
      text += fmt::format("{}--{} NAME\n", kind ? "\n" : "", flag);
      kind = one.kind;
    }
    text += fmt::format("  {:<14} {}\n", one.name, title_of(one));
  }
  return text + "\nrind presets NAME shows what one sets.\n";
}

std::string list_json() {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const PresetText& one : preset_texts()) {
    json.push_back(
        {{"kind", preset_kind_word(one.kind)}, {"name", one.name}, {"title", title_of(one)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace

int presets_command(const Options& options, Reporter& reporter) {
  if (options.preset_shown.empty()) {
    return show_result(options.json ? list_json() : list_text(), reporter);
  }
  const std::optional<PresetText> preset = preset_text(options.preset_shown);
  if (!preset) {
    reporter.error(
        fmt::format("there is no preset \"{}\"; rind presets lists them all", options.preset_shown),
        kExitUsage);
    return kExitUsage;
  }
  return show_result(std::string(preset->text), reporter);
}

}  // namespace host
