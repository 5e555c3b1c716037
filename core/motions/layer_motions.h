// The motions of one layer's roads: begin() goes to where the first one starts, rest() lays them.
//
//     begin   what differs between two layers before the roads, (ObjectStart), (retract) Lift
//             Travel (return), SetFan, SetAcceleration
//     rest    for each road: the same, where it is not the first; RoadStart Extrude …
//
// What rest() gives does not depend on what was laid before the layer (laid_body.h).
#pragma once

#include <optional>
#include <vector>

#include "core/geometry.h"                 // Point
#include "core/motions/laid_layer.h"       // LaidLayer
#include "core/motions/nozzle_motions.h"   // NozzleMotions
#include "core/motions/slice_boundary.h"   // SliceBoundary
#include "core/motions/spiral_rise.h"      // SpiralRise
#include "core/motions/width_stretches.h"  // WidthStretch
#include "core/regions/region.h"           // Region
#include "core/roads/road.h"               // RoadKind
#include "core/roads/travel_space.h"       // TravelSpace
#include "core/settings.h"                 // Settings
#include "core/slices/slice.h"             // Slice
#include "core/units.h"                    // LayerIndex, Length

namespace core {

// A layer, and the slice that travels in it cross.
struct LayerPlace {
  LayerIndex index = 0;
  Length bottom, height;
  const Region& region;

  [[nodiscard]] Length top() const { return bottom + height; }
};

class LayerMotions {
 public:
  // `settings`: with the values from heights so far. `space`: null: ways are straight. All outlive
  // it. REQUIRES: the layer has roads.
  LayerMotions(const Settings& settings, const LayerPlace& place, const LaidLayer& laid,
               const TravelSpace* space, MotionState& state, MotionTotals& totals,
               const MotionSink& sink);

  void begin();
  // REQUIRES: begin() was called, or the state is as behind it.
  void rest();

 private:
  [[nodiscard]] Length level_of(const LaidRoad& road) const;
  [[nodiscard]] double acceleration_of(const LaidStretch& stretch) const;
  void arrive(const LaidRoad& road);
  [[nodiscard]] bool joins_turn(const LaidRoad& road) const;
  void start_object(int object);
  void road(const LaidRoad& road);
  void join_turn(const WidthStretch& stretch, double speed);
  [[nodiscard]] double filament_per_mm(const WidthStretch& stretch) const;
  void lay(const LaidStretch& stretch);
  void lay(const RoadPiece& piece, RoadKind kind, double filament_per_mm, double speed);
  void lay_rising(const RoadPiece& piece, RoadKind kind, double filament_per_mm, double speed);
  [[nodiscard]] bool is_over_objects() const;
  void travel(Point to, RoadKind kind);
  [[nodiscard]] std::vector<Point> way_to(Point to) const;
  [[nodiscard]] bool needs_retraction(const std::vector<Point>& way, RoadKind kind);

  const Settings& settings_;
  const LayerPlace place_;
  const LaidLayer& laid_;
  const TravelSpace* space_;
  MotionState& state_;
  MotionTotals& totals_;
  const MotionSink& sink_;
  NozzleMotions nozzle_;
  SliceBoundary boundary_;
  const LaidRoad* last_ = nullptr;
  int object_ = kNoObject;          // of the road at hand
  Length level_;                    // of the road at hand, where it starts
  std::optional<SpiralRise> rise_;  // of the road at hand
};

}  // namespace core
