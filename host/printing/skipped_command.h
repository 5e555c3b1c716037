// What is left of a command of an object that nobody wants any more.
#pragma once

#include <cstdint>

#include "firmware_link/wire/command.h"  // Command

namespace host {

// The nozzle stays where it is, and lays nothing; what it draws back, a lift, and all that is no
// move stay as they are. Of a move nothing else is left than its feed, or `feed_mm_min`: commands
// are counted, so there is one for one. The next object's first move says all that it needs
// (MotionEncoder::set_labels).
[[nodiscard]] firmware_link::Command skipped(const firmware_link::Command& command,
                                             std::int64_t feed_mm_min);

}  // namespace host
