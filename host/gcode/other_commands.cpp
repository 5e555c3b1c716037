#include "host/gcode/other_commands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string>

#include "firmware_link/wire/gcode_words.h"  // is_classic
#include "host/gcode/gcode_numbers.h"
#include "host/gcode/ready_moves.h"

namespace host {
namespace {

using firmware_link::Effect;
using firmware_link::Flavor;
using firmware_link::PlaceAfter;
using firmware_link::ReadyLine;

constexpr std::uint8_t kAllAxes = 7;

template <std::size_t N>
bool among(const std::array<std::string_view, N>& list, std::string_view command) {
  return std::find(list.begin(), list.end(), command) != list.end();
}

void lose(std::uint8_t axes, ReadyLine& line) {
  line.place = PlaceAfter::kAxesLost;
  line.lost_axes = axes;
}

std::uint8_t axes_in(const GcodeNumbers& numbers) {
  int axes = 0;
  if (numbers.has('X')) axes |= 1;
  if (numbers.has('Y')) axes |= 2;
  if (numbers.has('Z')) axes |= 4;
  return static_cast<std::uint8_t>(axes);
}

void set(Effect::Kind kind, std::int64_t value, ReadyLine& line) { line.effect = {kind, value}; }

// G20, G21, G90, G91, M82, M83.
bool read_mode(const CommandWords& words, GcodeModes& modes, ReadyLine& line) {
  std::int32_t now = modes.modes;
  const auto put = [&now](std::int32_t mode, bool on) { now = on ? now | mode : now & ~mode; };
  if (words.command == "G20" || words.command == "G21") {
    put(Effect::kInches, words.command == "G20");
  } else if (words.command == "G90" || words.command == "G91") {
    const bool relative = words.command == "G91";
    const bool filament_too = words.flavor == Flavor::kMarlin;
    if (modes.has(Effect::kRelativeFilament) != relative) modes.filament_mode_unclear = true;
    put(Effect::kRelativePlace, relative);
    if (filament_too) put(Effect::kRelativeFilament, relative);
  } else if (words.command == "M82" || words.command == "M83") {
    modes.filament_mode_unclear = false;
    put(Effect::kRelativeFilament, words.command == "M83");
  } else {
    return false;
  }
  set(Effect::Kind::kModes, now, line);
  return true;
}

// The temperature that M104 S210, M109 R210 … set; nothing: none, or another tool's.
void read_heat(const CommandWords& words, const GcodeModes& modes, ReadyLine& line) {
  const GcodeNumbers numbers(words.parameters);
  const bool nozzle = words.command == "M104" || words.command == "M109";
  if (nozzle && numbers.whole('T').value_or(modes.tool) != modes.tool) return;
  std::optional<std::int64_t> celsius = numbers.fixed('S');
  if (!celsius) celsius = numbers.fixed('R');
  if (!celsius) return;
  const std::int64_t tenths = std::clamp<std::int64_t>(divided(*celsius, 10'000), 0, 9'999);
  set(nozzle ? Effect::Kind::kNozzle : Effect::Kind::kBed, tenths, line);
}

void read_fan(const CommandWords& words, ReadyLine& line) {
  const GcodeNumbers numbers(words.parameters);
  // Others than the part's.
  if (numbers.whole('P').value_or(0) != 0) return;
  const std::int64_t power = words.command == "M107" ? 0 : numbers.whole('S').value_or(255);
  set(Effect::Kind::kFan, std::clamp<std::int64_t>(power, 0, 255), line);
}

void read_percent(const CommandWords& words, ReadyLine& line) {
  const GcodeNumbers numbers(words.parameters);
  const std::optional<std::int64_t> percent = numbers.whole('S');
  if (!percent || *percent < 1 || *percent > 999) return;
  set(words.command == "M220" ? Effect::Kind::kFeedPercent : Effect::Kind::kFlowPercent, *percent,
      line);
}

// G92: what the controller's count of filament is, and other coordinates for where it stands.
void read_rename(const CommandWords& words, const GcodeModes& modes, ReadyLine& line) {
  const GcodeNumbers numbers(words.parameters);
  const std::optional<std::int64_t> filament = numbers.fixed('E');
  const std::uint8_t axes = axes_in(numbers);
  const bool all = axes == 0 && !filament;
  if (filament || all) {
    set(Effect::Kind::kFilamentCount, all ? 0 : filament_10nm_in(*filament, modes), line);
  }
  if (axes == 0 && !all) return;
  lose(all ? kAllAxes : axes, line);
  line.shifted = true;
}

void read_home(const CommandWords& words, ReadyLine& line) {
  const std::uint8_t axes = axes_in(GcodeNumbers(words.parameters));
  lose(axes == 0 ? kAllAxes : axes, line);
  if (axes == 0 || axes == kAllAxes) line.shifted = false;
}

// "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=210"
void read_heater(const CommandWords& words, ReadyLine& line) {
  const std::size_t at = words.text.find("TARGET=");
  if (at == std::string_view::npos) return;
  const double celsius = std::strtod(std::string(words.text.substr(at + 7)).c_str(), nullptr);
  const auto tenths = std::int64_t{std::llround(std::clamp(celsius, 0.0, 999.0) * 10)};
  if (words.text.find("HEATER=extruder") != std::string_view::npos) {
    set(Effect::Kind::kNozzle, tenths, line);
  } else if (words.text.find("HEATER=heater_bed") != std::string_view::npos) {
    set(Effect::Kind::kBed, tenths, line);
  }
}

// They move, and come back.
constexpr std::array<std::string_view, 14> kComeBack = {"M0",   "M1",   "M25",  "M125", "M226",
                                                        "M240", "M600", "M601", "M602", "M603",
                                                        "M701", "M702", "M98",  "G12"};
// They leave the nozzle anywhere.
constexpr std::array<std::string_view, 16> kLeave = {"G26",  "G27", "G29", "G30", "G32", "G33",
                                                     "G34",  "G35", "G38", "G61", "G76", "G80",
                                                     "G425", "M18", "M45", "M84"};

void leaves_or_comes_back(const GcodeModes& modes, ReadyLine& line) {
  if (!modes.road_laid) return lose(kAllAxes, line);
  line.place = PlaceAfter::kAsBefore;
}

CommandKnown read_name(const CommandWords& words, const GcodeModes& modes, ReadyLine& line) {
  if (words.command == "SET_HEATER_TEMPERATURE") read_heater(words, line);
  for (const std::string_view still : {"SET_", "EXCLUDE_OBJECT", "SAVE_GCODE_STATE", "RESPOND"}) {
    if (words.command.starts_with(still)) return CommandKnown::kYes;
  }
  leaves_or_comes_back(modes, line);
  return CommandKnown::kMacro;
}

void read_other_g(const CommandWords& words, const GcodeModes& modes, ReadyLine& line) {
  constexpr std::array<std::string_view, 9> kStill = {"G4",  "G17", "G18", "G19", "G21",
                                                      "G60", "G53", "G54", "G94"};
  constexpr std::array<std::string_view, 5> kShift = {"G55", "G56", "G57", "G58", "G59"};
  const std::string_view command = words.command;
  if (command == "G92") return read_rename(words, modes, line);
  if (command == "G28") return read_home(words, line);
  if (command == "G10" || command == "G11") {
    line.place = PlaceAfter::kFilament;
  } else if (among(kShift, command)) {
    lose(kAllAxes, line);
    line.shifted = true;
  } else if (among(kLeave, command)) {
    lose(kAllAxes, line);
  } else if (!among(kStill, command)) {
    leaves_or_comes_back(modes, line);
  }
}

void read_m(const CommandWords& words, const GcodeModes& modes, ReadyLine& line) {
  const std::string_view command = words.command;
  if (command == "M104" || command == "M109" || command == "M140" || command == "M190") {
    read_heat(words, modes, line);
  } else if (command == "M106" || command == "M107") {
    read_fan(words, line);
  } else if (command == "M220" || command == "M221") {
    read_percent(words, line);
  } else if (command == "M206" || command == "M428") {
    line.shifted = true;
  } else if (among(kComeBack, command)) {
    line.place = PlaceAfter::kAsBefore;
  } else if (among(kLeave, command)) {
    lose(kAllAxes, line);
  }
}

}  // namespace

CommandKnown read_command(const CommandWords& words, GcodeModes& modes, ReadyLine& line) {
  const std::string_view command = words.command;
  if (!firmware_link::is_classic(command)) return read_name(words, modes, line);
  if (read_mode(words, modes, line)) return CommandKnown::kYes;
  if (command == "G0" || command == "G1" || command == "G2" || command == "G3") {
    read_move(command[1] - '0', GcodeNumbers(words.parameters), modes, line);
  } else if (command[0] == 'G') {
    read_other_g(words, modes, line);
  } else if (command[0] == 'M') {
    read_m(words, modes, line);
  } else if (command[0] == 'T') {
    const std::optional<std::int64_t> tool = GcodeNumbers(command).whole('T');
    if (tool && *tool <= 99) set(Effect::Kind::kTool, *tool, line);
    line.place = PlaceAfter::kAsBefore;
  } else {
    leaves_or_comes_back(modes, line);
  }
  return CommandKnown::kYes;
}

}  // namespace host
