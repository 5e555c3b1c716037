#include "core/motions/motion_builder.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/check.h"                // RIND_CHECK
#include "core/motions/park_height.h"  // park_height

namespace core {

namespace {

// How far the nozzle passes above finished objects, at least.
constexpr Length kObjectClearance = Length::from_units(10'000);

}  // namespace

MotionBuilder::MotionBuilder(const Settings& settings)
    : settings_(settings),
      actions_(settings),
      laying_(settings),
      pressure_advance_s_(settings.pressure_advance_s) {
  if (settings.arcs != ArcUse::kAuto) state_.arcs = settings.arcs == ArcUse::kOn;
}

void MotionBuilder::decide_arcs(bool drawn) {
  RIND_CHECK(!state_.arcs && !state_.started);
  state_.arcs = drawn;
}

void MotionBuilder::resume_from(const MotionState& state) {
  RIND_CHECK(!state_.preheated && !state_.started);
  state_ = state;
  actions_.apply(static_cast<std::size_t>(state_.actions), settings_);
}

void MotionBuilder::start_layer(const Slice& slice, const Sink& sink) {
  index_ = slice.index;
  top_ = slice.top();
  state_.highest = std::max(state_.highest, top_);
  ++totals_.layers;
  sink(LayerStart{index_, top_, slice.height});
}

void MotionBuilder::set_up_layer(double fan_share, const Sink& sink) {
  nozzle(sink).set_fan(fan_share);
  const double celsius =
      index_ == 0 ? settings_.nozzle_first_layer_celsius : settings_.nozzle_celsius;
  if (celsius != state_.nozzle_celsius) sink(SetNozzleTemperature{celsius, false});
  state_.nozzle_celsius = celsius;
  const double bed = index_ == 0 ? bed_first_layer_celsius(settings_) : settings_.bed_celsius;
  if (bed != state_.bed_celsius) sink(SetBedTemperature{bed, false});
  state_.bed_celsius = bed;
}

LayerPace MotionBuilder::pace_of(const Slice& slice) const {
  const auto done = static_cast<std::size_t>(state_.actions);
  const std::size_t due = actions_.due(done, slice.bottom).size();
  return laying_.pace(slice, done + due, state_.arcs.value_or(false));
}

void MotionBuilder::layer(const Slice& slice, const std::vector<Road>& roads, const Sink& sink,
                          const TravelSpace* space) {
  if (roads.empty()) return;
  begin_layer(slice, sink);
  const auto from = state_.position_known ? std::optional(state_.position) : std::nullopt;
  lay(slice, laying_.lay(slice, roads, pace_of(slice), from), sink, space, nullptr, nullptr);
}

void MotionBuilder::prepared_layer(const Slice& slice, const LaidLayer& laid, const Sink& sink,
                                   const TravelSpace* space, const LaidBody* body,
                                   const std::function<bool()>& take_body) {
  RIND_CHECK(suits(laid, slice));
  begin_layer(slice, sink);
  lay(slice, laid, sink, space, body, take_body);
}

void MotionBuilder::begin_layer(const Slice& slice, const Sink& sink) {
  RIND_CHECK(!ended_);
  if (!state_.started) preamble(sink);
  start_layer(slice, sink);
  act(slice.bottom, sink);
}

void MotionBuilder::lay(const Slice& slice, const LaidLayer& laid, const Sink& sink,
                        const TravelSpace* space, const LaidBody* body,
                        const std::function<bool()>& take_body) {
  set_up_layer(laid.fan_share, sink);
  const LayerPlace place{slice.index, slice.bottom, slice.height, slice.region};
  // Summed up by itself, so that the sums are the same wherever it was laid.
  MotionTotals roads;
  LayerMotions motions(settings_, place, laid, space, state_, roads, sink);
  motions.begin();
  totals_ += std::exchange(roads, {});
  if (body != nullptr && fits(*body, state_, place, settings_) && take_body()) {
    return end_body(*body, state_, totals_);
  }
  motions.rest();
  totals_ += roads;
}

void MotionBuilder::leave_object(const Sink& sink) {
  if (!state_.position_known) return;
  nozzle(sink).retract();
  nozzle(sink).lift(
      std::max(park_height(state_.highest, settings_), state_.highest + kObjectClearance));
}

}  // namespace core
