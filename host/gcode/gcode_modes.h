// The machine as a file's lines so far have set it, in millimetres and degrees, whatever modes the
// file is in. A controller that is switched on has absolute positions, absolute filament and
// millimetres.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware_link/wire/command.h"  // Move, ReadyLine

namespace host {

struct GcodeModes {
  std::optional<std::int64_t> x_um, y_um, z_um;  // nothing: not known
  std::optional<std::int64_t> f_mm_min;
  std::int64_t e_count_10nm = 0;  // what the controller counts
  std::int64_t drawn_back_10nm = 0;
  std::int64_t highest_laid_um = 0;  // at which a road was laid
  std::int32_t nozzle_tenths = 0;    // targets
  std::int32_t bed_tenths = 0;
  std::uint8_t fan = 0;
  std::int32_t modes = 0;  // Effect::kRelativePlace, kRelativeFilament, kInches
  std::int32_t tool = 0;
  std::int32_t feed_percent = 100;
  std::int32_t flow_percent = 100;
  bool shifted = false;  // G92 X0: the coordinates are not the machine's own
  bool road_laid = false;
  // G90 came behind M83: Marlin counts filament absolutely then, Klipper and RepRapFirmware don't.
  bool filament_mode_unclear = false;

  [[nodiscard]] bool has(std::int32_t mode) const { return (modes & mode) != 0; }

  // What the line has changed.
  void apply(const firmware_link::ReadyLine& line);
};

// How much filament is drawn back behind the move.
[[nodiscard]] std::int64_t drawn_back_after(const firmware_link::Move& move,
                                            std::int64_t before_10nm);

// The height at which roads were laid so far, behind the move.
[[nodiscard]] std::int64_t highest_laid_after(const firmware_link::Move& move,
                                              const std::optional<std::int64_t>& z_um,
                                              std::int64_t before_um);

// Whether material is laid: the nozzle moves along while filament is pushed.
[[nodiscard]] inline bool lays_road(const firmware_link::Move& move) {
  return move.e_10nm.value_or(0) > 0 && (move.x_um || move.y_um);
}

}  // namespace host
