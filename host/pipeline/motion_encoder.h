// Motions in typed lengths become commands in the controller's whole numbers: the only place where
// core's words meet the link's.
//
// Positions are absolute, so each is rounded by itself. An arc's centre is told from the begin's
// place on the wire, so that its radius differs by less than 3 µm from begin to end (2 √2 roundings
// of half a µm); Grbl, the strictest, refuses 5 µm where that is 0.1 %, Marlin and Klipper end at
// the end whatever it is. Filament is relative: what rounding leaves
// over is carried to the next move, so that the sum of what is sent never differs from the sum of
// what was asked by more than half a unit (5 nm), however long the print.
//
// Motions count from the bed's front left corner, the controller from where its own origin is: the
// bed's origin is added here, and nowhere before.
//
// What a controller knows already is left out (an unchanged x, y or feed), because on a serial line
// each byte takes 40 to 90 µs.
#pragma once

#include <cstdint>
#include <optional>

#include "core/motions/motion.h"         // Motion
#include "core/settings.h"               // Settings
#include "firmware_link/wire/command.h"  // Command

namespace host {

class MotionEncoder {
 public:
  MotionEncoder() = default;
  // The bed's origin is where the settings say; otherwise it is the controller's.
  explicit MotionEncoder(const core::Settings& settings)
      : origin_x_(settings.bed_origin_x.units()), origin_y_(settings.bed_origin_y.units()) {}

  // What the controller was told last, and what is owed to it.
  struct State {
    std::optional<std::int64_t> x_um, y_um, z_um, f_mm_min;  // nothing: unknown
    double filament_rest_10nm = 0;                           // within ±0.5
  };

  // The command that carries the motion out; nothing where none is needed: a mark, a move to where
  // the nozzle is, a line without a command.
  // REQUIRES: check_user_gcode() was fine; positions within what command.h allows; where an arc
  // begins has been encoded, and its radius and chord are 10 µm at least.
  [[nodiscard]] std::optional<firmware_link::Command> encode(const core::Motion& motion);

  // An encoder that gets this state goes on with the very commands that this one would give.
  [[nodiscard]] const State& state() const { return state_; }
  void resume_from(const State& state) { state_ = state; }

 private:
  std::optional<firmware_link::Command> encode_one(const core::LayerStart&) { return {}; }
  std::optional<firmware_link::Command> encode_one(const core::RoadStart&) { return {}; }
  std::optional<firmware_link::Command> encode_one(const core::Travel& motion);
  std::optional<firmware_link::Command> encode_one(const core::Lift& motion);
  std::optional<firmware_link::Command> encode_one(const core::Extrude& motion);
  std::optional<firmware_link::Command> encode_one(const core::ExtrudeArc& motion);
  std::optional<firmware_link::Command> encode_one(const core::MoveFilament& motion);
  std::optional<firmware_link::Command> encode_one(const core::SetFan& motion);
  std::optional<firmware_link::Command> encode_one(const core::SetNozzleTemperature& motion);
  std::optional<firmware_link::Command> encode_one(const core::SetBedTemperature& motion);
  std::optional<firmware_link::Command> encode_one(const core::Verbatim& motion);

  // Puts into the move what the controller doesn't know yet.
  void put_position(core::Point to, firmware_link::Move& move);
  void put_feed(double speed_mm_s, firmware_link::Move& move);
  void put_filament(double filament_mm, firmware_link::Move& move);

  // Between the motions' corner and the controller's origin, in core's units.
  std::int64_t origin_x_ = 0;
  std::int64_t origin_y_ = 0;
  State state_;
};

}  // namespace host
