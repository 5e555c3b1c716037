// Where the controller must be after the commands that it was given, in whole wire units, and
// whether its own account (M114) agrees. That finds a line that ran in part, twice, or not at all.
//
//     given   G1 X10 E0.5   G1 X20 E0.5   M114          expected  X20, E one mm on
//     told                                "X:20.00 Y:5.00 Z:0.20 E:1.50 Count …"
//
// x, y, z are absolute and compared as such. Filament is relative: the controller's count of it is
// compared, from a G92 E0 on. So a line that ran twice or not at all shows even where the next
// absolute move has corrected the position.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "firmware_link/wire/command.h"  // Move
#include "firmware_link/wire/instant.h"  // Duration
#include "firmware_link/wire/reply.h"    // Position

namespace firmware_link {

class PositionWatch {
 public:
  // What is true when all commands given so far have run. Axes that are not known are not set.
  struct Expected {
    std::array<std::optional<std::int64_t>, 3> axes_um;
    std::optional<std::int64_t> e_10nm;  // in the controller's own count
    std::int64_t moves = 0;              // since that count began: its roundings add up
  };

  enum class Verdict { kAgrees, kFilamentDiffers, kPositionDiffers };

  // REQUIRES: in the order in which they are given to the controller.
  void gave(const Move& move);
  void gave_filament_reset();  // G92 E0
  // A line whose effect is not known here.
  void gave_unknown() { expected_ = {}; }
  // Behind the move of a file's line. `counts`: the controller's count of filament is compared.
  void gave_ready(const ReadyLine& line, bool counts);

  [[nodiscard]] const Expected& expected() const { return expected_; }

  // How long the move takes at its feed, if it never had to slow down; 0 when not known.
  [[nodiscard]] Duration nominal_time(const Move& move) const;

  // The controller's account of what was expected at that point.
  [[nodiscard]] static Verdict compare(const Expected& then, const Position& told);

  // How much more filament it counts than expected. REQUIRES: both are known.
  [[nodiscard]] static std::int64_t filament_excess_10nm(const Expected& then,
                                                         const Position& told);

  // "X20 Y5 Z0.2", for a sentence.
  [[nodiscard]] static std::string text_of(const Expected& expected);
  [[nodiscard]] static std::string text_of(const Position& position);

 private:
  [[nodiscard]] double straight_um(const Move& move) const;

  Expected expected_;
  std::int64_t feed_mm_min_ = 0;
};

}  // namespace firmware_link
