// Turns roads into motions: material, speed, travel, retraction, temperatures.
//
//     preheat    heaters on, and nothing else: as soon as a print is likely
//     preamble   once, before the first layer that has roads: heaters, start G-code
//     layer      LayerStart, what is due at its height (height_actions.h), then for each road
//                (retract) Lift Travel (return) RoadStart Extrude …
//                (ObjectEnd, ObjectStart), where it belongs to another object than the one before
//                (RoadChange Extrude …), where its width or what holds it changes, and at borders
//                of other speeds and flows (laid_areas.h); SetAcceleration where another one is
//                wanted than was told last (road_accelerations.h)
//     A spiral's turn (roads/vase_roads.h) begins where the one below ended, rises as it is laid,
//     and has no travel before it.
//     finish     retract, lift, park, heaters and fan off, end G-code
//
// Filament laid by a piece of road:  length · bead area / (π d² / 4),  relative. An arc lays as
// much as the segments that it stands for. Holds one layer's roads at a time, never the print.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/motions/height_actions.h"  // HeightActions
#include "core/motions/laid_body.h"       // LaidBody
#include "core/motions/laid_layer.h"      // LaidLayer, LayerLaying
#include "core/motions/layer_motions.h"   // LayerMotions
#include "core/motions/motion.h"          // Motion
#include "core/motions/motion_state.h"    // MotionState, MotionTotals
#include "core/motions/nozzle_motions.h"  // NozzleMotions
#include "core/roads/road.h"              // Road
#include "core/roads/travel_space.h"      // TravelSpace
#include "core/settings.h"                // Settings
#include "core/slices/slice.h"            // Slice

namespace core {

class MotionBuilder {
 public:
  using Sink = MotionSink;

  // REQUIRES: settings in their ranges.
  explicit MotionBuilder(const Settings& settings);

  // Decides what ArcUse::kAuto leaves open: whether the controller draws arcs. Without it, there
  // are none. REQUIRES: no layer had roads so far.
  [[nodiscard]] bool arcs_undecided() const { return !state_.arcs; }
  void decide_arcs(bool drawn);

  // Turns the heaters on before the first layer is known, so that they are warm by then. The first
  // layer's preamble leaves that out then, so that the motions in all are the same. Call it at most
  // once, before any layer().
  void preheat(const Sink& sink);

  // The roads of the next layer up, in this order. A layer without roads gives no motion, and a
  // print without any heats only in preheat().
  // `space`: of this slice, for ways around contours; null: ways are straight.
  // REQUIRES: slices come from the bed up, again behind leave_object(); every road has two points
  // or more.
  void layer(const Slice& slice, const std::vector<Road>& roads, const Sink& sink,
             const TravelSpace* space = nullptr);

  // The same for roads that were prepared in any thread (laid_layer.h), where they suit: only
  // actions at heights of an object before this one, and a spiral, can make them not to.
  [[nodiscard]] const LayerLaying& laying() const { return laying_; }
  [[nodiscard]] bool suits(const LaidLayer& laid, const Slice& slice) const {
    return !laid.roads.empty() && !laid.roads.front().spiral && laid.pace == pace_of(slice);
  }
  // `body`: of this layer, or of one with the same roads (laid_body.h); null: none. Where it fits,
  // and `take_body` says that its motions are given out otherwise, they are not given to the sink.
  // REQUIRES: suits(laid, slice), and likewise.
  void prepared_layer(const Slice& slice, const LaidLayer& laid, const Sink& sink,
                      const TravelSpace* space = nullptr, const LaidBody* body = nullptr,
                      const std::function<bool()>& take_body = nullptr);

  // The object at hand is finished, and the next one begins on the bed: the nozzle is lifted over
  // all that stands, and goes down again where the next road begins. Nothing when no layer had
  // roads.
  void leave_object(const Sink& sink);

  // Ends the print: retracts, lifts the nozzle off the part, parks it (park_place.h), heaters and
  // fan off, end G-code.
  // Nothing when no layer had roads.
  void finish(const Sink& sink);

  // What will come before the first layer; nothing if that has begun.
  void show_preamble(const Sink& sink) const;

  // Lines that follow the start G-code. REQUIRES: no layer had roads so far.
  void tell_objects(std::vector<std::string> lines) { object_lines_ = std::move(lines); }

  [[nodiscard]] const MotionTotals& totals() const { return totals_; }

  // The lowest height at which something is still to be done (height_actions.h), if any.
  [[nodiscard]] std::optional<Length> next_action() const {
    return actions_.height_of(static_cast<std::size_t>(state_.actions));
  }

  // Between two layers. A builder of the same settings that resumes from this state gives the same
  // motions as this one would. Its totals start from 0.
  [[nodiscard]] const MotionState& state() const { return state_; }
  // REQUIRES: nothing was built yet.
  void resume_from(const MotionState& state);

 private:
  void preamble(const Sink& sink);
  void start_layer(const Slice& slice, const Sink& sink);
  void act(Length bottom, const Sink& sink);
  void take(const HeightAction& action, const Sink& sink);
  void tell_ways_again(const Sink& sink);
  void set_up_layer(double fan_share, const Sink& sink);
  [[nodiscard]] LayerPace pace_of(const Slice& slice) const;
  void begin_layer(const Slice& slice, const Sink& sink);
  void lay(const Slice& slice, const LaidLayer& laid, const Sink& sink, const TravelSpace* space,
           const LaidBody* body, const std::function<bool()>& take_body);
  [[nodiscard]] NozzleMotions nozzle(const Sink& sink) {
    return {settings_, state_, totals_, sink};
  }

  Settings settings_;  // with the values from heights so far
  HeightActions actions_;
  LayerLaying laying_;
  double pressure_advance_s_;  // that the printer is left with; negative: as it is
  std::vector<std::string> object_lines_;
  MotionTotals totals_;
  MotionState state_;
  bool ended_ = false;
  Length top_;  // of the layer
  LayerIndex index_ = 0;
};

}  // namespace core
