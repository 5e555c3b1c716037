#include "host/pipeline/user_gcode.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include "core/motions/height_actions.h"          // read_height_action
#include "firmware_link/wire/command.h"           // verbatim_from
#include "firmware_link/wire/gcode_words.h"       // commands_in
#include "firmware_link/wire/refused_commands.h"  // refused_in
#include "host/gcode/line_meaning.h"              // meaning_of
#include "host/pipeline/standing_values.h"

namespace host {
namespace {

using Lines = std::vector<std::string>;

core::Error bad(std::string message) { return {core::ErrorCode::kBadSetting, std::move(message)}; }

bool holds(const Lines& lines, std::string_view command) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    const std::vector<std::string> commands = firmware_link::commands_in(line);
    return std::find(commands.begin(), commands.end(), command) != commands.end();
  });
}

bool moves_filament(const Lines& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find_first_of("Ee") != std::string::npos && firmware_link::has_parameter(line, 'E');
  });
}

core::Status check_lines(const Lines& lines, const char* setting, const Lines& allowed) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (firmware_link::blank_or_comment(lines[i])) continue;
    const auto place = [&] {
      return fmt::format("{}, line {} ('{}'): ", setting, i + 1, lines[i]);
    };
    const auto made = firmware_link::verbatim_from(lines[i]);
    if (const auto* refusal = std::get_if<std::string>(&made)) return bad(place() + *refusal);
    if (const auto refused = firmware_link::refused_in(lines[i], allowed)) {
      return bad(fmt::format("{0}{1} {2}; take it out, or allow it with --allow-gcode {1}", place(),
                             refused->command, refused->reason));
    }
  }
  return {};
}

// The G-code in at_height; lines of other actions are empty.
Lines height_lines(const core::Settings& settings) {
  Lines lines;
  for (const std::string& text : settings.at_height) {
    const core::Result<core::HeightAction> action = core::read_height_action(text);
    lines.push_back(action.ok() ? action.value().line : "");
  }
  return lines;
}

struct NamedLines {
  const char* setting;
  Lines lines;
};

std::array<NamedLines, 4> lines_of(const core::Settings& settings) {
  return {NamedLines{"start_gcode", settings.start_gcode},
          NamedLines{"at_height", height_lines(settings)},
          NamedLines{"pause_gcode", settings.pause_gcode},
          NamedLines{"end_gcode", settings.end_gcode}};
}

// The command that restores a mode, and the commands that change it.
struct Restored {
  std::string_view changed_by;
  std::string_view line;
};

constexpr std::array kRestored = {
    Restored{"G18", "G17"},      Restored{"G19", "G17"},     Restored{"G93", "G94"},
    Restored{"G95", "G94"},      Restored{"M149", "M149 C"}, Restored{"M200", "M200 D0"},
    Restored{"M209", "M209 S0"},
};

// Commands whose effect is kept, although it changes the part or its position.
struct Kept {
  std::string_view command;
  std::string_view effect;
};

constexpr std::array kKept = {
    Kept{"G53", "changes the coordinates that the part is laid in"},
    Kept{"G54", "changes the coordinates that the part is laid in"},
    Kept{"G55", "changes the coordinates that the part is laid in"},
    Kept{"G56", "changes the coordinates that the part is laid in"},
    Kept{"G57", "changes the coordinates that the part is laid in"},
    Kept{"G58", "changes the coordinates that the part is laid in"},
    Kept{"G59", "changes the coordinates that the part is laid in"},
    Kept{"M206", "moves the coordinates that the part is laid in"},
    Kept{"SET_GCODE_OFFSET", "moves the coordinates that the part is laid in"},
};

// True for G92 with more than E: it gives the current position other coordinates.
bool renames_place(const std::string& line) {
  const std::vector<std::string> commands = firmware_link::commands_in(line);
  if (commands.empty() || commands.front() != "G92") return false;
  return std::any_of(std::begin("XYZ"), std::end("XYZ") - 1,
                     [&](char axis) { return firmware_link::has_parameter(line, axis); });
}

// A name of Klipper's of which nothing is known; PAUSE brings back what it changes.
bool is_macro(const std::string& line) {
  GcodeModes modes;
  MeaningRules rules;
  rules.checks = false;
  const auto meaning = meaning_of(line, rules, modes);
  const Lines commands = firmware_link::commands_in(line);
  const std::string command = commands.empty() ? "" : commands.front();
  return meaning.ok() && meaning.value() && meaning.value()->macro &&
         command != "ACTIVATE_EXTRUDER" && command != "PAUSE";
}

bool chooses_other_tool(std::string_view command) {
  return command.size() > 1 && command[0] == 'T' && command != "T0" &&
         firmware_link::is_classic(command);
}

// What start_gcode sets for the whole print.
constexpr std::array kStanding = {
    Kept{"M220", "changes the speed of the whole print"},
    Kept{"M221", "changes the flow of the whole print"},
};

// Of lines that are no start G-code.
Lines effects_of_later(const std::string& line, const StandingValues& standing) {
  Lines effects;
  const Lines again = standing.told_again_after({line});
  if (!again.empty()) {
    effects.push_back(
        fmt::format("counts for the lines at that place alone: {} is told behind them",
                    fmt::join(again, ", ")));
  }
  if (standing.loses_value({line})) {
    effects.emplace_back(
        "changes the rest of the print: neither start_gcode nor a setting tells what to go back to "
        "(default_acceleration_mm_s2, pressure_advance_s)");
  }
  if (is_macro(line)) {
    effects.emplace_back(
        "is a macro: the tool, M220, M221, acceleration and pressure advance stay as it leaves "
        "them, unless other lines there change them");
  }
  return effects;
}

Lines effects_of_start(const std::string& line) {
  Lines effects;
  for (const std::string& command : firmware_link::commands_in(line)) {
    for (const Kept& standing : kStanding) {
      if (standing.command == command) effects.emplace_back(standing.effect);
    }
    if (chooses_other_tool(command)) {
      effects.emplace_back("chooses the tool that the part is laid with");
    }
  }
  return effects;
}

Lines lasting_effects(const std::string& line) {
  Lines effects;
  if (renames_place(line)) {
    effects.emplace_back(
        "gives the nozzle's position other coordinates: the part is laid in those");
  }
  for (const std::string& command : firmware_link::commands_in(line)) {
    for (const Kept& kept : kKept) {
      if (kept.command == command) effects.emplace_back(kept.effect);
    }
  }
  return effects;
}

// What the print needs behind the user's lines. `again`: of standing values.
Lines modes_after(const Lines& lines, const Lines& again = {}) {
  Lines modes = {"G21", "G90", "M83"};
  const Lines restored = restored_after(lines);
  modes.insert(modes.end(), restored.begin(), restored.end());
  modes.insert(modes.end(), again.begin(), again.end());
  modes.emplace_back("G92 E0");
  return modes;
}

// at_height, with the modes behind the lines of each height.
Lines with_modes_at_heights(const core::Settings& settings) {
  using Kind = core::HeightAction::Kind;
  const std::vector<core::HeightAction> actions = core::height_actions(settings);
  const StandingValues standing(settings);
  Lines whole, of_height;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const core::HeightAction& action = actions[i];
    const double mm = action.height.mm();
    if (action.kind == Kind::kPause) {
      whole.push_back(fmt::format("{} pause", mm));
      of_height.insert(of_height.end(), settings.pause_gcode.begin(), settings.pause_gcode.end());
    } else if (action.kind == Kind::kValue) {
      whole.push_back(fmt::format("{} {} {}", mm, action.setting->key, action.value));
    } else {
      whole.push_back(fmt::format("{} gcode {}", mm, action.line));
      of_height.push_back(action.line);
    }
    if (of_height.empty()) continue;
    if (i + 1 < actions.size() && actions[i + 1].height == action.height) continue;
    Lines modes = modes_after(of_height, standing.told_again_after(of_height));
    modes.emplace_back("M400");
    for (const std::string& line : modes) whole.push_back(fmt::format("{} gcode {}", mm, line));
    of_height.clear();
  }
  return whole;
}

}  // namespace

core::Result<Lines> allowed_commands(const std::string& text) {
  Lines allowed;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find_first_of(", "));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    if (one.empty()) continue;
    const std::string command = firmware_link::canonical(one);
    const bool starts_right = command.front() >= 'A' && command.front() <= 'Z';
    if (!starts_right || firmware_link::command_word_size(one) != one.size()) {
      return bad(fmt::format("allow_gcode: \"{}\" is no command; expected such as M500,M501", one));
    }
    const auto refused = firmware_link::refused_command(command);
    if (refused && refused->never) {
      return bad(fmt::format("allow_gcode: {} is never sent: it {}", command, refused->reason));
    }
    allowed.push_back(command);
  }
  return allowed;
}

core::Status check_user_gcode(const core::Settings& settings) {
  const core::Result<Lines> allowed = allowed_commands(settings.allow_gcode);
  if (!allowed.ok()) return allowed.error();
  for (const NamedLines& lines : lines_of(settings)) {
    core::Status fine = check_lines(lines.lines, lines.setting, allowed.value());
    if (!fine.ok()) return fine;
  }
  return {};
}

std::vector<std::string> user_gcode_notes(const core::Settings& settings) {
  std::vector<std::string> notes;
  const auto note = [&notes](std::string text) {
    if (std::find(notes.begin(), notes.end(), text) == notes.end())
      notes.push_back(std::move(text));
  };
  const StandingValues standing(settings);
  for (const NamedLines& lines : lines_of(settings)) {
    const std::string_view setting = lines.setting;
    if (setting == "end_gcode") continue;
    for (const std::string& line : lines.lines) {
      Lines effects = lasting_effects(line);
      const Lines more =
          setting == "start_gcode" ? effects_of_start(line) : effects_of_later(line, standing);
      effects.insert(effects.end(), more.begin(), more.end());
      for (const std::string& lasts : effects) {
        note(fmt::format("{}: {} {}", lines.setting, firmware_link::without_comments(line), lasts));
      }
    }
  }
  return notes;
}

std::vector<std::string> restored_after(const Lines& lines) {
  Lines restored;
  for (const Restored& one : kRestored) {
    if (!holds(lines, one.changed_by)) continue;
    const bool there = std::find(restored.begin(), restored.end(), one.line) != restored.end();
    if (!there) restored.emplace_back(one.line);
  }
  return restored;
}

core::Settings with_own_modes(core::Settings settings) {
  Lines& start = settings.start_gcode;
  const Lines modes = modes_after(start);
  if (!start.empty()) start.insert(start.begin(), {"G21", "G90", "M82"});
  start.insert(start.end(), modes.begin(), modes.end());
  settings.at_height = with_modes_at_heights(settings);
  Lines& end = settings.end_gcode;
  if (moves_filament(end)) end.insert(end.begin(), "G92 E0");
  return settings;
}

}  // namespace host
