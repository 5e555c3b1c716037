#include "host/pipeline/motion_encoder.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "core/check.h"
#include "host/pipeline/wire_units.h"

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::Heater;
using firmware_link::Move;

Command temperature(Heater heater, double celsius, bool wait) {
  return firmware_link::SetTemperature{heater, celsius_tenths(celsius), wait};
}

}  // namespace

std::optional<Command> MotionEncoder::encode(const core::Motion& motion) {
  return std::visit([this](const auto& one) { return encode_one(one); }, motion);
}

std::optional<Command> MotionEncoder::encode_one(const core::Travel& motion) {
  Move move;
  put_position(motion.to, move);
  if (!move.x_um && !move.y_um) return std::nullopt;
  put_feed(motion.speed_mm_s, move);
  return move;
}

std::optional<Command> MotionEncoder::encode_one(const core::Lift& motion) {
  Move move;
  put_height(motion.to, move);
  if (!move.z_um) return std::nullopt;
  put_feed(motion.speed_mm_s, move);
  return move;
}

std::optional<Command> MotionEncoder::encode_one(const core::Extrude& motion) {
  Move move;
  move.extruding = true;
  put_position(motion.to, move);
  if (!move.x_um && !move.y_um) {
    // Too short for the wire's unit: its filament goes into the next move, not into a blob.
    state_.filament_rest_10nm += motion.filament_mm * kFilamentUnitsPerMm;
    return std::nullopt;
  }
  if (motion.z) put_height(*motion.z, move);
  put_filament(motion.filament_mm, move);
  put_feed(motion.speed_mm_s, move);
  return move;
}

std::optional<Command> MotionEncoder::encode_one(const core::ExtrudeArc& motion) {
  RIND_CHECK(state_.x_um && state_.y_um);
  firmware_link::Arc arc;
  arc.clockwise = motion.clockwise;
  arc.i_um = static_cast<std::int32_t>(um_of(motion.centre.x + origin_x_) - *state_.x_um);
  arc.j_um = static_cast<std::int32_t>(um_of(motion.centre.y + origin_y_) - *state_.y_um);
  arc.length_um = static_cast<std::int32_t>(std::lround(motion.length_mm * 1'000));
  Move move;
  move.extruding = true;
  put_position(motion.to, move);
  RIND_CHECK(move.x_um || move.y_um);
  put_filament(motion.filament_mm, move);
  put_feed(motion.speed_mm_s, move);
  move.arc = arc;
  return move;
}

std::optional<Command> MotionEncoder::encode_one(const core::MoveFilament& motion) {
  Move move;
  move.extruding = true;
  put_filament(motion.filament_mm, move);
  if (!move.e_10nm) return std::nullopt;
  put_feed(motion.speed_mm_s, move);
  return move;
}

std::optional<Command> MotionEncoder::encode_one(const core::SetFan& motion) {
  return firmware_link::SetFan{fan_power(motion.share)};
}

std::optional<Command> MotionEncoder::encode_one(const core::SetNozzleTemperature& motion) {
  return temperature(Heater::kNozzle, motion.celsius, motion.wait);
}

std::optional<Command> MotionEncoder::encode_one(const core::SetBedTemperature& motion) {
  return temperature(Heater::kBed, motion.celsius, motion.wait);
}

std::optional<Command> MotionEncoder::encode_one(const core::SetAcceleration& motion) const {
  return firmware_link::SetAcceleration{state_.flavor, acceleration_mm_s2(motion.mm_s2)};
}

std::optional<Command> MotionEncoder::encode_one(const core::SetPressureAdvance& motion) const {
  return firmware_link::SetPressureAdvance{state_.flavor, pressure_advance_tens_us(motion.seconds)};
}

std::optional<Command> MotionEncoder::encode_one(const core::Verbatim& motion) {
  if (firmware_link::blank_or_comment(motion.line)) return std::nullopt;
  const auto made = firmware_link::verbatim_from(motion.line);
  RIND_CHECK(std::holds_alternative<firmware_link::Verbatim>(made));
  // The line may have moved anything.
  state_.x_um = state_.y_um = state_.z_um = state_.f_mm_min = std::nullopt;
  return std::get<firmware_link::Verbatim>(made);
}

std::optional<Command> MotionEncoder::encode_one(const core::ObjectStart& motion) {
  return label(labels_.start(motion.object));
}

std::optional<Command> MotionEncoder::encode_one(const core::ObjectEnd& motion) {
  return label(labels_.end(motion.object));
}

std::optional<Command> MotionEncoder::label(const std::string& line) {
  state_.x_um = state_.y_um = state_.f_mm_min = std::nullopt;
  if (line.empty()) return std::nullopt;
  const auto made = firmware_link::verbatim_from(line);
  RIND_CHECK(std::holds_alternative<firmware_link::Verbatim>(made));
  return std::get<firmware_link::Verbatim>(made);
}

void MotionEncoder::put_position(core::Point to, Move& move) {
  const std::int64_t x_um = um_of(to.x + origin_x_), y_um = um_of(to.y + origin_y_);
  if (state_.x_um != x_um) move.x_um = state_.x_um = x_um;
  if (state_.y_um != y_um) move.y_um = state_.y_um = y_um;
}

void MotionEncoder::put_height(core::Length to, Move& move) {
  const std::int64_t z_um = um_of(to.units());
  if (state_.z_um != z_um) move.z_um = state_.z_um = z_um;
}

void MotionEncoder::put_feed(double speed_mm_s, Move& move) {
  const std::int64_t feed = feed_mm_min(speed_mm_s);
  if (state_.f_mm_min != feed) move.f_mm_min = state_.f_mm_min = feed;
}

void MotionEncoder::put_filament(double filament_mm, Move& move) {
  const double wanted = filament_mm * kFilamentUnitsPerMm + state_.filament_rest_10nm;
  const std::int64_t sent = std::llround(wanted);
  state_.filament_rest_10nm = wanted - static_cast<double>(sent);
  if (sent != 0) move.e_10nm = sent;
}

}  // namespace host
