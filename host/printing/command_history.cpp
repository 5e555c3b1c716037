#include "host/printing/command_history.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "firmware_link/session/planner_watch.h"  // planner_blocks_of

namespace host {
namespace {

using firmware_link::Move;

// Of lines that somebody else has written.
std::string_view words_of(const firmware_link::Command& command) {
  if (const auto* line = std::get_if<firmware_link::Verbatim>(&command)) return line->text();
  const auto* ready = std::get_if<firmware_link::ReadyLine>(&command);
  return ready != nullptr ? ready->words.text() : std::string_view();
}

// Marlin's own code waits for the planner in these; in M109 and M190 it does not.
bool empties_planner(std::string_view text) {
  const std::string_view word = text.substr(0, text.find(' '));
  return word == "G4" || word == "G28" || word == "M400";
}

// 0 where it is not known from where.
std::int64_t distance_um(const std::optional<std::int64_t>& to,
                         const std::optional<std::int64_t>& from) {
  return to && from ? std::abs(*to - *from) : 0;
}

}  // namespace

std::size_t blocks_at_least(const firmware_link::Command& command, const MachineState& before) {
  if (empties_planner(words_of(command))) return kAllBlocks;
  if (const Move* move = firmware_link::move_of(command)) {
    if (move->arc) return planner_blocks_of(*move);
    const std::int64_t farthest =
        std::max({distance_um(move->x_um, before.x_um), distance_um(move->y_um, before.y_um),
                  distance_um(move->z_um, before.z_um), std::abs(move->e_10nm.value_or(0)) / 100});
    return farthest >= kBlockLengthUm ? 1 : 0;
  }
  return 0;
}

std::optional<std::int64_t> CommandHistory::executed_before(std::int64_t number,
                                                            std::size_t blocks) const {
  std::array<std::size_t, kHistoryCommandsMax> taken{};
  MachineState state = before_;
  // Where the last block ended, and the filament since: moves too short for a block of their own
  // are part of the next.
  MachineState planned = before_;
  std::int64_t filament_10nm = 0;
  for (std::int64_t i = begin_; i < number; ++i) {
    const firmware_link::Command& command = at(i).command;
    const Move* move = firmware_link::move_of(command);
    if (move != nullptr) filament_10nm += move->e_10nm.value_or(0);
    std::size_t& here = taken[static_cast<std::size_t>(i) % kHistoryCommandsMax];
    here = blocks_at_least(command, planned);
    if (here == 0 && std::abs(filament_10nm) / 100 >= kBlockLengthUm) here = 1;
    state.apply(command);
    if (here == 0 && planned.position_known()) continue;
    planned = state;
    filament_10nm = 0;
  }
  while (blocks > 0) {
    if (number == begin_) return std::nullopt;
    const std::size_t here = taken[static_cast<std::size_t>(number - 1) % kHistoryCommandsMax];
    if (here == kAllBlocks) return number;
    blocks -= std::min(blocks, here);
    --number;
  }
  return number;
}

std::int64_t CommandHistory::last_z_um(std::int64_t number) const {
  for (std::int64_t i = number; i > begin_; --i) {
    const Move* move = firmware_link::move_of(at(i - 1).command);
    if (move != nullptr && move->z_um) return *move->z_um;
  }
  return before_.z_um.value_or(0);
}

std::optional<std::int64_t> CommandHistory::executed_before(std::int64_t number,
                                                            double seconds) const {
  if (number == begin_) return std::nullopt;
  const double until = at(number - 1).seconds - seconds;
  while (number > begin_ && at(number - 1).seconds > until) {
    // Klipper, too, waits for its moves in M400.
    if (words_of(at(number - 1).command) == "M400") return number;
    --number;
  }
  return number > begin_ ? std::optional(number) : std::nullopt;
}

}  // namespace host
