#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/commands/commands.h"
#include "host/pipeline/user_gcode.h"  // check_user_gcode
#include "host/settings/profile_report.h"
#include "host/settings/settings_table.h"
#include "host/settings/settings_text.h"  // sendable_lines, write_lines

namespace host {
namespace {

nlohmann::ordered_json json_of(const std::vector<SettingRow>& rows) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SettingRow& row : rows) {
    json.push_back({{"key", row.key},
                    {"value", row.value},
                    {"unit", row.unit},
                    {"default", row.default_value},
                    {"range", row.range},
                    {"help", row.help},
                    {"type", row.type}});
    if (row.min) json.back()["min"] = *row.min;
    if (row.max) json.back()["max"] = *row.max;
    if (!row.words.empty()) json.back()["choices"] = row.words;
  }
  return json;
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

// An array for each group.
nlohmann::ordered_json json_of(const std::vector<ProfileRow>& rows) {
  nlohmann::ordered_json groups = nlohmann::ordered_json::object();
  for (const ProfileGroup group : kProfileGroups) {
    std::string name(group_name(group));
    std::replace(name.begin(), name.end(), ' ', '_');
    groups[name] = nlohmann::ordered_json::array();
  }
  for (const ProfileRow& row : rows) {
    std::string name(group_name(row.group));
    std::replace(name.begin(), name.end(), ' ', '_');
    groups[name].push_back({{"key", row.key}, {"value", row.value}, {"what", row.what}});
  }
  return groups;
}

// What became of the profile's settings, and then all of ours.
std::string translation_of(const Options& options, const WholeSettings& whole,
                           const std::vector<SettingRow>& rows) {
  const std::vector<ProfileRow> report =
      whole.profile ? report_of(*whole.profile) : std::vector<ProfileRow>();
  const std::string program = whole.profile ? whole.profile->program : "";
  if (options.json) {
    nlohmann::ordered_json all = {
        {"profile", options.translated}, {"program", program}, {"notes", whole.notes}};
    all.update(json_of(report));
    all["settings"] = json_of(rows);
    return all.dump(2) + "\n";
  }
  std::string text = fmt::format("# {}: {}\n", options.translated,
                                 program.empty() ? "rind's own" : program + "'s");
  for (const std::string& note : whole.notes) text += fmt::format("# {}\n", note);
  return text + text_of(report) + "\n" + table_of(rows);
}

}  // namespace

int settings_command(const Options& options, Reporter& reporter) {
  // A translation holds its notes itself.
  const core::Result<WholeSettings> whole = options.translated.empty()
                                                ? load_settings_of(options, reporter)
                                                : whole_settings(options.settings);
  if (!whole.ok()) return fail(whole.error(), reporter);
  core::Status fine = check_user_gcode(whole.value().settings);
  if (!fine.ok()) return fail(fine.error(), reporter);
  std::vector<SettingRow> rows = describe_settings(whole.value().settings);
  // What waits for a part is shown as it stands in the profile.
  for (const PendingGcode& gcode : whole.value().pending) {
    const core::Result<std::vector<std::string>> lines = sendable_lines(gcode.lines);
    if (!lines.ok()) continue;
    for (SettingRow& row : rows) {
      if (row.key == gcode.key) row.value = row.plain_value = write_lines(lines.value());
    }
  }
  if (options.translated.empty()) {
    return show_result(options.json ? json_of(rows).dump(2) + "\n" : table_of(rows), reporter);
  }
  return show_result(translation_of(options, whole.value(), rows), reporter);
}

}  // namespace host
