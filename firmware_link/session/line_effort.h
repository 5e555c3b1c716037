// What a line costs the controller, as far as the host can know it.
#pragma once

#include <cstddef>

#include "firmware_link/wire/instant.h"  // Duration

namespace firmware_link {

struct LineEffort {
  // How long its move takes at its feed. 0: it moves nothing, or the time is not known.
  Duration nominal{0};
  // How many blocks of the planner its move takes.
  std::size_t blocks = 1;
  // The planner runs empty before the command starts (M400, G4, G28, M109).
  bool empties_planner = false;
  // No line is sent behind it until it has been acknowledged.
  bool goes_alone = false;
};

// A command that waits also goes alone: a controller with free command slots reads an M112 at once,
// one whose slots are full reads it when the command ends (11 s were measured).
inline constexpr LineEffort kWaitsForPlanner{Duration(0), 1, true, true};
inline constexpr LineEffort kGoesAlone{Duration(0), 1, false, true};

}  // namespace firmware_link
