// Turns motions, in typed lengths, into commands, in the controller's integers. Only this file
// converts core's types to the link's.
//
// Positions are absolute, so each is rounded by itself. Arc centres are relative to the start point
// as sent, so start and end radii differ by under 3 µm (2 √2 roundings of half a µm). Grbl is the
// strictest firmware: it refuses 5 µm if that is over 0.1 %. Marlin and Klipper accept any
// difference. Filament is relative: the rounding error is carried to the next move, so the sum of
// the filament sent differs from the sum of the motions by at most half a unit (5 nm), however long
// the print.
//
// Motions are relative to the bed's front left corner, commands to the controller's origin. The
// bed's origin is added only here.
//
// An unchanged x, y or feed is left out of a command, because on a serial line each byte takes 40
// to 90 µs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/motions/motion.h"          // Motion
#include "core/settings.h"                // Settings
#include "firmware_link/wire/command.h"   // Command
#include "host/pipeline/object_labels.h"  // ObjectLabels

namespace host {

class MotionEncoder {
 public:
  MotionEncoder() = default;
  // Takes the bed's origin from the settings; by default it is the controller's origin.
  explicit MotionEncoder(const core::Settings& settings)
      : origin_x_(settings.bed_origin_x.units()), origin_y_(settings.bed_origin_y.units()) {}

  // The firmware that commands are spelled for. Unless it is set, Marlin.
  void set_flavor(firmware_link::Flavor flavor) { state_.flavor = flavor; }

  // How objects are told apart. Whether or not they are told, the first move of each says all that
  // it needs, so that an object before it may be skipped.
  void set_labels(ObjectLabels labels) { labels_ = std::move(labels); }

  // The last values sent, the filament's rounding error that is still to be sent, and for whom.
  struct State {
    std::optional<std::int64_t> x_um, y_um, z_um, f_mm_min;  // nullopt: not known
    double filament_rest_10nm = 0;                           // within ±0.5
    firmware_link::Flavor flavor = firmware_link::Flavor::kMarlin;
  };

  // The command for the motion; nullopt if it needs none: a mark, a move to the current position, a
  // line without a command.
  // REQUIRES: check_user_gcode() was fine; positions are within the bounds of command.h; an arc's
  // start point has been encoded, and its radius and chord are at least 10 µm.
  [[nodiscard]] std::optional<firmware_link::Command> encode(const core::Motion& motion);

  // An encoder that is given this state produces the same commands as this one would.
  [[nodiscard]] const State& state() const { return state_; }
  void resume_from(const State& state) { state_ = state; }

 private:
  std::optional<firmware_link::Command> encode_one(const core::LayerStart&) { return {}; }
  std::optional<firmware_link::Command> encode_one(const core::RoadStart&) { return {}; }
  std::optional<firmware_link::Command> encode_one(const core::RoadChange&) { return {}; }
  std::optional<firmware_link::Command> encode_one(const core::Pause&) { return {}; }
  std::optional<firmware_link::Command> encode_one(const core::ObjectStart& motion);
  std::optional<firmware_link::Command> encode_one(const core::ObjectEnd& motion);
  std::optional<firmware_link::Command> encode_one(const core::Travel& motion);
  std::optional<firmware_link::Command> encode_one(const core::Lift& motion);
  std::optional<firmware_link::Command> encode_one(const core::Extrude& motion);
  std::optional<firmware_link::Command> encode_one(const core::ExtrudeArc& motion);
  std::optional<firmware_link::Command> encode_one(const core::MoveFilament& motion);
  std::optional<firmware_link::Command> encode_one(const core::Wipe& motion) {
    return encode_one(core::Extrude{motion.to, motion.filament_mm, motion.speed_mm_s});
  }
  std::optional<firmware_link::Command> encode_one(const core::SetFan& motion);
  std::optional<firmware_link::Command> encode_one(const core::SetNozzleTemperature& motion);
  std::optional<firmware_link::Command> encode_one(const core::SetBedTemperature& motion);
  std::optional<firmware_link::Command> encode_one(const core::SetAcceleration& motion) const;
  std::optional<firmware_link::Command> encode_one(const core::SetPressureAdvance& motion) const;
  std::optional<firmware_link::Command> encode_one(const core::Verbatim& motion);

  std::optional<firmware_link::Command> label(const std::string& line);

  // Put values into the move that differ from the last ones sent.
  void put_position(core::Point to, firmware_link::Move& move);
  void put_height(core::Length to, firmware_link::Move& move);
  void put_feed(double speed_mm_s, firmware_link::Move& move);
  void put_filament(double filament_mm, firmware_link::Move& move);

  // The bed's front left corner, from the controller's origin, in core's units.
  std::int64_t origin_x_ = 0;
  std::int64_t origin_y_ = 0;
  ObjectLabels labels_;
  State state_;
};

}  // namespace host
