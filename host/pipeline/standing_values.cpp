#include "host/pipeline/standing_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "firmware_link/wire/gcode_words.h"  // canonical, command_word_size, commands_in
#include "host/gcode/line_meaning.h"         // percent_set_by

namespace host {
namespace {

using firmware_link::Effect;
using Lines = std::vector<std::string>;

constexpr std::string_view kTool = "T", kFeed = "M220", kFlow = "M221", kAcceleration = "M204",
                           kRetractAcceleration = "M204 R", kAdvance = "advance";

char capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

// The parameter's value in "P800 T1500" or "M900K.2"; empty: there is none.
std::string_view number_behind(std::string_view parameters, char letter) {
  for (std::size_t at = 0; at < parameters.size(); ++at) {
    if (capital(parameters[at]) != letter) continue;
    const std::string_view rest = parameters.substr(at + 1);
    return rest.substr(0, std::min(rest.size(), rest.find_first_not_of("0123456789.+-:")));
  }
  return {};
}

// The parameter's value in " EXTRUDER=extruder1 ADVANCE=0.04"; empty: there is none.
std::string named(std::string_view parameters, std::string_view name) {
  std::string capitals(parameters);
  std::transform(capitals.begin(), capitals.end(), capitals.begin(), capital);
  const std::size_t at = capitals.find(fmt::format(" {}=", name));
  if (at == std::string::npos) return {};
  const std::string_view rest = parameters.substr(at + name.size() + 2);
  return std::string(rest.substr(0, rest.find(' ')));
}

bool chooses_tool(std::string_view command) {
  return command.size() > 1 && command[0] == 'T' && firmware_link::is_classic(command);
}

// "G28 M221 S95" is two commands, as RepRapFirmware runs them. `count`: as many are there.
Lines single_commands(const std::string& line, std::size_t count) {
  std::string rest = firmware_link::without_comments(line);
  Lines single;
  while (single.size() + 1 < count) {
    std::size_t at = 1;
    while (at < rest.size() && !(rest[at - 1] == ' ' && std::strchr("GMgm", rest[at]) != nullptr &&
                                 firmware_link::is_classic(rest.substr(at, 2)))) {
      ++at;
    }
    if (at == rest.size()) break;
    single.push_back(rest.substr(0, at));
    rest.erase(0, at);
  }
  single.push_back(rest);
  return single;
}

// The key of values that each tool has of its own.
std::string of_tool(std::string_view key, std::string_view tool) {
  const bool first = tool.empty() || tool == "0" || tool == "extruder";
  return first ? std::string(key) : fmt::format("{} {}", key, tool);
}

// P and T together are all that S is, and S is both of them.
std::string merged_acceleration(std::string_view before, std::string_view parameters) {
  constexpr std::string_view kLetters = "SPT";
  std::array<std::string, 3> values;
  for (const std::string_view text : {before, parameters}) {
    if (!number_behind(text, 'S').empty()) values = {};
    for (std::size_t i = 0; i < kLetters.size(); ++i) {
      const std::string_view told = number_behind(text, kLetters[i]);
      if (!told.empty()) values[i] = told;
    }
    if (!values[1].empty() && !values[2].empty()) values[0].clear();
  }
  std::string line(kAcceleration);
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    if (!values[i].empty()) line += fmt::format(" {}{}", kLetters[i], values[i]);
  }
  return line;
}

}  // namespace

// Adds what one line leaves, or puts it in the place of what lines before it left.
void StandingValues::read(std::string_view line, std::vector<Value>& values) {
  const auto put = [&values](std::string key, std::string text) {
    std::erase_if(values, [&](const Value& value) { return value.key == key; });
    values.push_back({std::move(key), std::move(text)});
  };
  const auto before = [&values](std::string_view key) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const Value& value) { return value.key == key; });
    return found != values.end() ? found->line : std::string();
  };
  const std::size_t word_size = firmware_link::command_word_size(line);
  if (word_size == 0) return;
  const std::string command = firmware_link::canonical(line.substr(0, word_size));
  const std::string parameters(line.substr(word_size));
  if (chooses_tool(command)) {
    put(std::string(kTool), command);
  } else if (command == "ACTIVATE_EXTRUDER") {
    put(std::string(kTool), std::string(line));
  } else if (command == kFeed) {
    const Effect effect = percent_set_by(line);
    if (effect.kind == Effect::Kind::kFeedPercent) {
      put(std::string(kFeed), fmt::format("{} S{}", kFeed, effect.value));
    } else if (firmware_link::has_parameter(line, 'R')) {
      put(std::string(kFeed), "");  // what M220 B has noted
    }
  } else if (command == kFlow) {
    const Effect effect = percent_set_by(line);
    if (effect.kind != Effect::Kind::kFlowPercent) return;
    std::string text = fmt::format("{} S{}", kFlow, effect.value);
    std::string of(kFlow);
    for (const char letter : {'T', 'D'}) {
      const std::string_view tool = number_behind(parameters, letter);
      if (tool.empty() || tool == "0") continue;
      of = fmt::format("{} {}{}", kFlow, letter, tool);
      text += fmt::format(" {}{}", letter, tool);
    }
    put(std::move(of), std::move(text));
  } else if (command == kAcceleration) {
    const std::string whole = merged_acceleration(before(kAcceleration), parameters);
    if (whole != kAcceleration) put(std::string(kAcceleration), whole);
    const std::string_view retract = number_behind(parameters, 'R');
    if (!retract.empty()) {
      put(std::string(kRetractAcceleration), fmt::format("{}{}", kRetractAcceleration, retract));
    }
  } else if (command == "SET_VELOCITY_LIMIT") {
    const std::string told = named(parameters, "ACCEL");
    if (!told.empty()) put(std::string(kAcceleration), fmt::format("{} ACCEL={}", command, told));
  } else if (command == "M900") {
    const std::string_view tool = number_behind(parameters, 'T');
    if (!number_behind(parameters, 'K').empty()) put(of_tool(kAdvance, tool), std::string(line));
  } else if (command == "M572") {
    const std::string_view tool = number_behind(parameters, 'D');
    if (!number_behind(parameters, 'S').empty()) put(of_tool(kAdvance, tool), std::string(line));
  } else if (command == "SET_PRESSURE_ADVANCE") {
    const std::string tool = named(parameters, "EXTRUDER");
    if (!named(parameters, "ADVANCE").empty()) put(of_tool(kAdvance, tool), std::string(line));
  }
}

std::vector<StandingValues::Value> StandingValues::values_after(const Lines& lines) {
  std::vector<Value> values;
  for (const std::string& line : lines) {
    const Lines commands = firmware_link::commands_in(line);
    if (commands.empty()) continue;
    for (const std::string& one : single_commands(line, commands.size())) read(one, values);
  }
  return values;
}

StandingValues::StandingValues(const core::Settings& settings)
    : of_start_(values_after(settings.start_gcode)),
      accelerations_are_told_(settings.default_acceleration_mm_s2 > 0),
      advance_is_told_(settings.pressure_advance_s >= 0) {}

std::optional<std::string> StandingValues::standing(const Value& changed) const {
  if (changed.key == kAcceleration && accelerations_are_told_) return "";
  if (changed.key == kAdvance && advance_is_told_) return "";
  const auto found = std::find_if(of_start_.begin(), of_start_.end(),
                                  [&](const Value& value) { return value.key == changed.key; });
  if (found != of_start_.end() && !found->line.empty()) return found->line;
  if (changed.key == kTool) {
    return changed.line.starts_with(kTool) ? "T0" : "ACTIVATE_EXTRUDER EXTRUDER=extruder";
  }
  if (changed.key == kFeed) return "M220 S100";
  if (changed.key.starts_with(kFlow)) return "M221 S100" + changed.key.substr(kFlow.size());
  return std::nullopt;
}

Lines StandingValues::told_again_after(const Lines& lines) const {
  Lines again;
  for (const Value& changed : values_after(lines)) {
    const std::optional<std::string> line = standing(changed);
    if (!line || line->empty() || *line == changed.line) continue;
    // The tool first: others are told to the tool that is chosen.
    again.insert(changed.key == kTool ? again.begin() : again.end(), *line);
  }
  return again;
}

bool StandingValues::loses_value(const Lines& lines) const {
  const std::vector<Value> values = values_after(lines);
  return std::any_of(values.begin(), values.end(),
                     [&](const Value& value) { return !standing(value); });
}

std::string StandingValues::tool() const {
  for (const Value& value : of_start_) {
    if (value.key == kTool) return value.line;
  }
  return {};
}

int StandingValues::feed() const {
  for (const Value& value : of_start_) {
    if (value.key == kFeed && !value.line.empty()) {
      return static_cast<int>(percent_set_by(value.line).value);
    }
  }
  return 100;
}

int StandingValues::flow() const {
  for (const Value& value : of_start_) {
    if (value.key == kFlow) return static_cast<int>(percent_set_by(value.line).value);
  }
  return 100;
}

}  // namespace host
