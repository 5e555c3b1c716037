// How long a print's commands take, and how much filament: one clock for what rind plans, writes
// and prints, and for ready G-code. It follows what commands change about moving:
//
//     M201 M203 M204 M205 M566   SET_VELOCITY_LIMIT   M220     limits, accelerations, corners, feed
//     M221                                                    the flow
//     G4                                                      a pause is counted
//     G28 M109 M400 M600 macros …                              the machine comes to rest first
//
// Not counted: heating, homing, measuring the bed, and what macros and M600 do.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/motions/motion_clock.h"   // MotionClock
#include "core/settings.h"               // Settings
#include "firmware_link/wire/command.h"  // Command
#include "host/gcode/gcode_modes.h"      // GcodeModes

namespace host {

class CommandClock {
 public:
  explicit CommandClock(const core::Settings& settings);

  // Of the controller; that of the settings until it is known.
  void set_flavor(firmware_link::Flavor flavor) { flavor_ = flavor; }

  // `filament_mm`: what a move was asked to push, before it was rounded; nothing: what it says.
  // COSTS: O(core::kLookAheadMoves).
  void add(const firmware_link::Command& command, std::optional<double> filament_mm = std::nullopt);
  // The same in two halves.
  void add_time(const firmware_link::Command& command,
                std::optional<double> filament_mm = std::nullopt);
  void add_filament(std::int64_t e_10nm) {
    pushed_10nm_ += e_10nm * flow_percent_ / 100;
    needed_10nm_ = std::max(needed_10nm_, pushed_10nm_);
  }

  // A clock that begins anew, at rest and at this place, with what was told about moving.
  [[nodiscard]] CommandClock at_rest(std::int64_t x_um, std::int64_t y_um, std::int64_t z_um) const;

  // As core::MotionClock's: the time of a stretch that another clock has counted.
  [[nodiscard]] bool goes_on_as(const CommandClock& from, bool any_height) const;
  void skip(const CommandClock& from, const CommandClock& to, bool any_height);

  // For all that was added, coming to rest at its end.
  [[nodiscard]] double seconds() const { return clock_.seconds(); }

  // The most that was taken off the spool, with what users' lines push out.
  [[nodiscard]] double needed_mm() const { return static_cast<double>(needed_10nm_) * 1e-5; }
  // Likewise, up to the first M600 behind some filament, which asks for a new spool; nothing: there
  // is none.
  [[nodiscard]] std::optional<double> needed_to_change_mm() const { return to_change_mm_; }

 private:
  void add_move(const firmware_link::Move& move, std::optional<double> filament_mm);
  void add_line(const firmware_link::ReadyLine& line);
  void add_user_line(const firmware_link::Verbatim& line);
  void change_model(std::string_view text);

  firmware_link::Flavor flavor_;
  core::MotionClock clock_;
  GcodeModes modes_;  // of a user's lines
  std::int64_t x_um_ = 0, y_um_ = 0, z_um_ = 0;
  std::int64_t feed_mm_min_ = 1'500;  // Marlin's, until a line tells one
  std::int64_t feed_percent_ = 100;
  std::int64_t flow_percent_ = 100;
  std::int64_t pushed_10nm_ = 0, needed_10nm_ = 0;
  std::optional<double> to_change_mm_;
};

}  // namespace host
