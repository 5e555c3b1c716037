// How long a controller may stay silent over a command, by the command's word. Most are answered
// at once, or as soon as the planner has room; those in the table take long by nature, and firmware
// without `echo:busy:` says nothing meanwhile.
#pragma once

#include <string_view>

#include "firmware_link/wire/instant.h"  // Duration

namespace firmware_link {

struct CommandWait {
  // What it is that takes so long, for a sentence: "homing"; empty for what is answered at once.
  std::string_view what;
  // How long it may take in silence; 0 for what is answered at once.
  Duration limit{0};
  // The planner runs empty before it starts, so nothing is sent behind it.
  bool planner_runs_empty = false;

  [[nodiscard]] bool is_long() const { return limit.count() > 0; }
};

// By a command's text, without number. `macros`: words that are not a letter and a number are
// macros that a user wrote, which may do anything (Klipper).
[[nodiscard]] CommandWait wait_of(std::string_view text, bool macros);

// The command's word: "G1" of "G1X10", "PRINT_START" of "PRINT_START BED=60".
[[nodiscard]] std::string_view word_of(std::string_view text);

}  // namespace firmware_link
