// What a controller says that it can do (M115's `Cap:NAME:0|1` lines), and what it shows by how it
// answers, because advanced acknowledgements and the planner's size have no such line.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "firmware_link/wire/travel_limits.h"  // TravelLimits

namespace firmware_link {

struct Capabilities {
  bool autoreport_temperatures = false;  // M155
  bool emergency_parser = false;         // M112 acts at once, whatever runs
  bool host_actions = false;             // `//action:pause` and its kin may come
  bool arcs = false;                     // G2, G3 with I and J
  bool meatpack = false;                 // packed lines
  bool sets_position = false;            // where asked: SET_KINEMATIC_POSITION tells it its height
  bool advanced_ok = false;              // learned: an `ok` with P and B
  std::int32_t planner_blocks = 0;       // learned: most free blocks ever told; 0: never told
  std::optional<TravelLimits> travel;    // told twice the same, because an answer may be damaged
  std::optional<TravelLimits> travel_told_last;
};

// Takes one `Cap:` line's text, "ARCS:1". Names not listed above are ignored.
void note_capability(std::string_view text, Capabilities& capabilities);

// Takes any line; most tell nothing of travel.
void note_travel(std::string_view line, Capabilities& capabilities);

// "Marlin 2.1 (date) SOURCE_CODE_URL:…" is "Marlin 2.1 (date)": values hold blanks, so the name
// ends where the next KEY: starts.
[[nodiscard]] std::string firmware_name_in(std::string_view text);

// The printer's name in M115's answer (MACHINE_TYPE); empty: it tells none.
[[nodiscard]] std::string machine_type_in(std::string_view text);

}  // namespace firmware_link
