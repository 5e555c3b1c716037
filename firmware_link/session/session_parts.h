// What a session keeps in mind between its turns; its own business.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware_link/session/position_watch.h"  // PositionWatch
#include "firmware_link/wire/command.h"            // Command
#include "firmware_link/wire/reply.h"              // Position

namespace firmware_link {

// What the session itself has to say, as soon as there is room.
struct OwnRequests {
  std::optional<int> feed_percent;
  std::optional<int> flow_percent;
  std::optional<std::int64_t> filament_correction_10nm;
  bool reset_filament = false;
  bool ask_position = false;
  bool ask_temperatures = false;
  bool report_temperatures = false;
  bool stay_awake = false;
};

// Taken, and not in the window yet, because a line of the link's own goes before it.
struct DeferredCommand {
  Command command;
  bool is_command = false;
};

// An M114 on its way.
struct PositionQuestion {
  std::int64_t sequence = 0;
  PositionWatch::Expected expected;
  std::optional<Position> told;
};

}  // namespace firmware_link
