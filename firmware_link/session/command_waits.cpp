#include "firmware_link/session/command_waits.h"

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace firmware_link {
namespace {

using std::chrono::minutes;

struct Row {
  std::string_view word;
  std::string_view what;
  minutes limit;
};

// Generous: a bed of 400 mm takes half an hour to warm, a mesh of 15 × 15 points twenty minutes. A
// limit that is too long costs a warm nozzle, one that is too short a part. Whoever is to change
// filament may be away for days.
constexpr minutes kUsersTime(30 * 24 * 60);
constexpr Row kRows[] = {
    {"G4", "a pause in the G-code", minutes(60)},
    {"G12", "cleaning the nozzle", minutes(10)},
    {"G26", "a test pattern", minutes(60)},
    {"G27", "parking", minutes(5)},
    {"G28", "homing", minutes(10)},
    {"G29", "probing the bed", minutes(60)},
    {"G30", "probing the bed", minutes(10)},
    {"G32", "probing the bed", minutes(60)},
    {"G33", "calibrating", minutes(60)},
    {"G34", "levelling the gantry", minutes(30)},
    {"G35", "probing the bed", minutes(30)},
    {"G38", "probing", minutes(10)},
    {"G76", "calibrating the probe's warmth", minutes(240)},
    {"G80", "probing the bed", minutes(60)},
    {"G425", "calibrating", minutes(30)},
    {"M0", "its user", kUsersTime},
    {"M1", "its user", kUsersTime},
    {"M18", "the last moves", minutes(10)},
    {"M25", "its user", kUsersTime},
    {"M45", "calibrating", minutes(60)},
    {"M48", "testing the probe", minutes(60)},
    {"M84", "the last moves", minutes(10)},
    {"M109", "the nozzle to be warm", minutes(20)},
    {"M116", "all heaters to be warm", minutes(90)},
    {"M125", "parking", kUsersTime},
    {"M190", "the bed to be warm", minutes(90)},
    {"M191", "the chamber to be warm", minutes(240)},
    {"M192", "the probe to be warm", minutes(60)},
    {"M226", "its user", kUsersTime},
    {"M303", "tuning a heater", minutes(60)},
    {"M306", "tuning a heater", minutes(60)},
    {"M400", "the last moves", minutes(10)},
    {"M600", "a change of filament", kUsersTime},
    {"M601", "its user", kUsersTime},
    {"M701", "loading filament", minutes(10)},
    {"M702", "unloading filament", minutes(10)},
};

constexpr minutes kMacroLimit(60);
constexpr minutes kToolChangeLimit(5);

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

}  // namespace

std::string_view word_of(std::string_view text) {
  std::size_t end = std::min(text.find(' '), text.size());
  if (text.size() >= 2 && is_capital(text[0]) && is_digit(text[1])) {
    end = 1;
    while (end < text.size() && is_digit(text[end])) ++end;
  }
  return text.substr(0, end);
}

CommandWait wait_of(std::string_view text, bool macros) {
  const std::string_view word = word_of(text);
  const bool classic = word.size() >= 2 && is_digit(word[1]);
  if (!classic) return macros ? CommandWait{"a macro", kMacroLimit, true} : CommandWait{};
  if (word[0] == 'T') return {"a change of tool", kToolChangeLimit, true};
  const auto* const row = std::find_if(std::begin(kRows), std::end(kRows),
                                       [&](const Row& one) { return one.word == word; });
  if (row == std::end(kRows)) return {};
  // Klipper's user may have written any of them again.
  return {row->what, macros ? std::max(row->limit, kMacroLimit) : row->limit, true};
}

}  // namespace firmware_link
