// MotionBuilder: how a print begins and ends.
#include <algorithm>
#include <cmath>

#include "core/check.h"  // RIND_CHECK
#include "core/motions/motion_builder.h"
#include "core/motions/park_height.h"  // park_height
#include "core/motions/park_place.h"   // park_place

namespace core {

void MotionBuilder::preheat(const Sink& sink) {
  RIND_CHECK(!state_.preheated && !state_.started);
  state_.preheated = true;
  sink(SetBedTemperature{bed_first_layer_celsius(settings_), false});
  sink(SetNozzleTemperature{settings_.nozzle_first_layer_celsius, false});
}

void MotionBuilder::preamble(const Sink& sink) {
  if (!state_.preheated) preheat(sink);
  state_.started = true;
  state_.nozzle_celsius = settings_.nozzle_first_layer_celsius;
  for (const std::string& line : settings_.start_gcode) sink(Verbatim{line});
  for (const std::string& line : object_lines_) sink(Verbatim{line});
  if (settings_.pressure_advance_s >= 0) sink(SetPressureAdvance{settings_.pressure_advance_s});
  state_.bed_celsius = bed_first_layer_celsius(settings_);
  sink(SetBedTemperature{state_.bed_celsius, true});
  sink(SetNozzleTemperature{state_.nozzle_celsius, true});
  sink(SetFan{0});
}

void MotionBuilder::show_preamble(const Sink& sink) const {
  MotionBuilder copy = *this;
  if (!copy.state_.started) copy.preamble(sink);
}

void MotionBuilder::finish(const Sink& sink) {
  if (!state_.started || ended_) return;
  ended_ = true;
  nozzle(sink).retract();
  const Length here = state_.nozzle_z.value_or(top_);
  nozzle(sink).lift(std::max(park_height(state_.highest, settings_), here));
  sink(Travel{park_place(settings_), settings_.travel_speed_mm_s});
  sink(SetNozzleTemperature{0, false});
  sink(SetBedTemperature{0, false});
  sink(SetFan{0});
  if (state_.acceleration_mm_s2 > 0)
    nozzle(sink).set_acceleration(std::round(settings_.default_acceleration_mm_s2));
  if (settings_.pressure_advance_s != pressure_advance_s_ && pressure_advance_s_ >= 0) {
    sink(SetPressureAdvance{pressure_advance_s_});
  }
  for (const std::string& line : settings_.end_gcode) sink(Verbatim{line});
}

}  // namespace core
