#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "host/commands/commands.h"
#include "host/exit_codes.h"
#include "host/settings/settings_table.h"

namespace host {
namespace {

void print_json(const std::vector<SettingRow>& rows) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SettingRow& row : rows) {
    json.push_back({{"key", row.key},
                    {"value", row.value},
                    {"unit", row.unit},
                    {"default", row.default_value},
                    {"range", row.range},
                    {"help", row.help}});
  }
  std::puts(json.dump(2).c_str());
}

// The output is a profile that says what holds now.
void print_table(const std::vector<SettingRow>& rows) {
  std::string text = "# rind's settings; this text is itself a profile\n";
  for (const SettingRow& row : rows) {
    text += fmt::format("\n# {}\n", row.help);
    text += fmt::format("# {}{}{}default {}\n", row.range, row.range.empty() ? "" : ", ",
                        row.unit.empty() ? "" : "in " + row.unit + ", ",
                        row.default_value.empty() ? "empty" : row.default_value);
    text += fmt::format("{} = {}\n", row.key, row.value);
  }
  std::fputs(text.c_str(), stdout);
}

}  // namespace

int settings_command(const Options& options, Reporter& reporter) {
  const core::Result<core::Settings> settings = load_settings_of(options, reporter);
  if (!settings.ok()) return fail(settings.error(), reporter);
  const std::vector<SettingRow> rows = describe_settings(settings.value());
  if (options.json) {
    print_json(rows);
  } else {
    print_table(rows);
  }
  return kExitDone;
}

}  // namespace host
