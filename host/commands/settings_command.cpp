#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/commands/commands.h"
#include "host/settings/settings_table.h"
#include "host/settings/settings_text.h"  // sendable_lines, write_lines

namespace host {
namespace {

std::string json_of(const std::vector<SettingRow>& rows) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SettingRow& row : rows) {
    json.push_back({{"key", row.key},
                    {"value", row.value},
                    {"unit", row.unit},
                    {"default", row.default_value},
                    {"range", row.range},
                    {"help", row.help}});
  }
  return json.dump(2) + "\n";
}

// The table is a valid profile with the current values.
std::string table_of(const std::vector<SettingRow>& rows) {
  std::string text = "# rind's settings; this text is itself a profile\n";
  for (const SettingRow& row : rows) {
    text += fmt::format("\n# {}\n", row.help);
    text += fmt::format("# {}, default {}\n", row.range,
                        row.default_value.empty() ? "empty" : row.default_value);
    text += fmt::format("{} = {}\n", row.key, row.value);
  }
  return text;
}

}  // namespace

int settings_command(const Options& options, Reporter& reporter) {
  const core::Result<WholeSettings> whole = load_settings_of(options, reporter);
  if (!whole.ok()) return fail(whole.error(), reporter);
  std::vector<SettingRow> rows = describe_settings(whole.value().settings);
  // What waits for a part is shown as it stands in the profile.
  for (const PendingGcode& gcode : whole.value().pending) {
    const core::Result<std::vector<std::string>> lines = sendable_lines(gcode.lines);
    if (!lines.ok()) continue;
    for (SettingRow& row : rows) {
      if (row.key == gcode.key) row.value = row.plain_value = write_lines(lines.value());
    }
  }
  return show_result(options.json ? json_of(rows) : table_of(rows), reporter);
}

}  // namespace host
