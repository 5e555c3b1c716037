// MotionBuilder: what is done at heights of the part (height_actions.h).
#include <algorithm>

#include "core/motions/motion_builder.h"
#include "core/motions/park_height.h"  // park_height

namespace core {

// What is due before a layer that starts at `bottom`. The user's lines may move anything: the
// nozzle is off the part meanwhile, and its way back goes over the part.
void MotionBuilder::act(Length bottom, const Sink& sink) {
  const auto due = actions_.due(static_cast<std::size_t>(state_.actions), bottom);
  state_.actions += static_cast<std::int64_t>(due.size());
  for (const HeightAction& action : due) take(action, sink);
  const auto stands = [](const HeightAction& action) {
    return action.kind != HeightAction::Kind::kValue;
  };
  if (std::none_of(due.begin(), due.end(), stands)) return;
  const Length away = std::max(park_height(bottom, settings_), state_.nozzle_z.value_or(bottom));
  if (state_.position_known) {
    nozzle(sink).retract();
    nozzle(sink).lift(away);
  }
  bool told_otherwise = false;  // perhaps, by the user's lines
  for (const HeightAction& action : due) {
    if (action.kind == HeightAction::Kind::kPause) sink(Pause{action.height});
    if (action.kind != HeightAction::Kind::kGcode) continue;
    sink(Verbatim{action.line});
    told_otherwise = true;
  }
  if (told_otherwise) tell_ways_again(sink);
  sink(SetFan{state_.fan});
  state_.position_known = false;
  state_.nozzle_z.reset();
  nozzle(sink).lift(away);
}

// The pressure advance and acceleration that were told last.
void MotionBuilder::tell_ways_again(const Sink& sink) {
  if (settings_.pressure_advance_s >= 0) sink(SetPressureAdvance{settings_.pressure_advance_s});
  if (state_.acceleration_mm_s2 > 0) sink(SetAcceleration{state_.acceleration_mm_s2});
}

// A setting's value from here on.
void MotionBuilder::take(const HeightAction& action, const Sink& sink) {
  if (action.setting == nullptr) return;
  const double retraction_before = settings_.retraction_mm;
  settings_.*action.setting->member = action.value;
  if (action.setting->member == &Settings::pressure_advance_s) {
    sink(SetPressureAdvance{action.value});
  }
  // What is drawn back already is what the layer will return.
  if (!state_.retracted || settings_.retraction_mm == retraction_before) return;
  sink(MoveFilament{retraction_before - settings_.retraction_mm, settings_.retraction_speed_mm_s});
  state_.retracted = settings_.retraction_mm > 0;
}

}  // namespace core
