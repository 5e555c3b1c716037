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

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/motions/arc_fit.h"          // RoadPiece
#include "core/motions/height_actions.h"   // HeightActions
#include "core/motions/laid_layer.h"       // LaidLayer, LayerLaying
#include "core/motions/motion.h"           // Motion
#include "core/motions/slice_boundary.h"   // SliceBoundary
#include "core/motions/spiral_rise.h"      // SpiralRise
#include "core/motions/width_stretches.h"  // WidthStretch
#include "core/roads/road.h"               // Road, RoadKind
#include "core/roads/travel_space.h"       // TravelSpace
#include "core/settings.h"                 // Settings
#include "core/slices/slice.h"             // Slice

namespace core {

// What was asked for since the start of the print.
struct MotionTotals {
  std::array<double, kRoadKindCount> filament_mm{};  // by RoadKind; retractions don't count
  double travel_mm = 0;
  std::int64_t roads = 0;
  std::int64_t arcs = 0;
  std::int64_t travels = 0;
  std::int64_t retractions = 0;
  std::int64_t layers = 0;  // with roads
};

// Where a print stands between two layers: all that the next layer's motions depend on besides its
// roads.
struct MotionState {
  bool preheated = false;
  bool started = false;
  bool retracted = false;
  bool position_known = false;
  Point position;                  // where the nozzle is, once known
  std::optional<Length> nozzle_z;  // likewise
  double fan = 0;
  double nozzle_celsius = 0;
  double bed_celsius = 0;
  double acceleration_mm_s2 = 0;  // as last told; 0: never told
  std::optional<bool> arcs;       // whether round roads become arcs; nothing: not decided
  std::int64_t actions = 0;       // carried out, of those at heights (height_actions.h)
  Length highest;                 // top of the highest layer that has roads
};

class MotionBuilder {
 public:
  using Sink = std::function<void(const Motion&)>;

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
  // REQUIRES: suits(laid, slice), and likewise.
  void prepared_layer(const Slice& slice, const LaidLayer& laid, const Sink& sink,
                      const TravelSpace* space = nullptr);

  // The object at hand is finished, and the next one begins on the bed: the nozzle is lifted over
  // all that stands, and goes down again where the next road begins. Nothing when no layer had
  // roads.
  void leave_object(const Sink& sink);

  // Ends the print: retracts, lifts the nozzle off the part, parks it (park_place.h), heaters and
  // fan off, end G-code.
  // Nothing when no layer had roads.
  void finish(const Sink& sink);

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
  void lay(const Slice& slice, const LaidLayer& laid, const Sink& sink, const TravelSpace* space);
  [[nodiscard]] bool joins_turn(const LaidRoad& road) const;
  void start_object(int object, const Sink& sink);
  void set_fan(double share, const Sink& sink);
  // 0: none is wanted.
  void set_acceleration(double mm_s2, const Sink& sink);
  void road(const LaidRoad& road, const Sink& sink);
  void join_turn(const WidthStretch& stretch, double speed, const Sink& sink);
  [[nodiscard]] double filament_per_mm(const WidthStretch& stretch) const;
  void lay(const LaidStretch& stretch, const Sink& sink);
  void lay(const RoadPiece& piece, RoadKind kind, double filament_per_mm, double speed,
           const Sink& sink);
  void lay_rising(const RoadPiece& piece, RoadKind kind, double filament_per_mm, double speed,
                  const Sink& sink);
  [[nodiscard]] bool is_over_objects() const;
  void travel(Point to, RoadKind kind, SliceBoundary& boundary, const Sink& sink);
  [[nodiscard]] std::vector<Point> way_to(Point to) const;
  [[nodiscard]] bool needs_retraction(const std::vector<Point>& way, RoadKind kind,
                                      SliceBoundary& boundary) const;
  void retract(const Sink& sink);
  void wipe(const Sink& sink);
  void unretract(const Sink& sink);
  void lift(Length to, const Sink& sink);

  Settings settings_;  // with the values from heights so far
  HeightActions actions_;
  LayerLaying laying_;
  double pressure_advance_s_;           // that the printer is left with; negative: as it is
  const TravelSpace* space_ = nullptr;  // of the layer at hand
  const LaidLayer* laid_ = nullptr;     // likewise
  const LaidRoad* last_ = nullptr;      // likewise
  int object_ = kNoObject;              // of the road at hand
  std::vector<std::string> object_lines_;
  MotionTotals totals_;
  MotionState state_;
  bool ended_ = false;
  Length top_;                      // of the layer
  Length level_;                    // of the road at hand, where it starts
  std::optional<SpiralRise> rise_;  // of the road at hand
  Length height_;
  LayerIndex index_ = 0;
  double speed_share_ = 1;  // of every speed (height_slowdown.h)
};

}  // namespace core
