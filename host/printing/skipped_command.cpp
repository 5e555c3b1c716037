#include "host/printing/skipped_command.h"

namespace host {

firmware_link::Command skipped(const firmware_link::Command& command, std::int64_t feed_mm_min) {
  const auto* asked = std::get_if<firmware_link::Move>(&command);
  if (asked == nullptr || (!asked->x_um && !asked->y_um)) return command;
  firmware_link::Move move = *asked;
  move.x_um.reset();
  move.y_um.reset();
  move.arc.reset();
  if (move.e_10nm && *move.e_10nm > 0) move.e_10nm.reset();
  if (!move.z_um && !move.e_10nm && !move.f_mm_min) move.f_mm_min = feed_mm_min;
  return move;
}

}  // namespace host
