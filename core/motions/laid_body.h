// The roads of a layer as motions, from where the first one starts, made in any thread before the
// layer's turn. Where the print stands then as they take it to stand, they are what MotionBuilder
// would give; so layers of the same roads share them.
#pragma once

#include <optional>

#include "core/motions/laid_layer.h"      // LaidLayer
#include "core/motions/layer_motions.h"   // LayerPlace
#include "core/motions/motion_state.h"    // MotionState, MotionTotals
#include "core/motions/nozzle_motions.h"  // MotionSink
#include "core/roads/travel_space.h"      // TravelSpace
#include "core/settings.h"                // Settings

namespace core {

struct LaidBody {
  MotionState before, after;      // of these, what changes within a layer
  MotionTotals totals;            // of the roads alone
  std::optional<Length> top;      // the only one that they are for; nothing: any
  double acceleration_share = 1;  // of every acceleration (height_slowdown.h)
};

// How the print stands at the first road, as far as the body depends on it.
[[nodiscard]] MotionState state_at_first_road(const Settings& settings, const LayerPlace& place,
                                              const LaidLayer& laid);

// The motions go to the sink. `settings`: with the values from heights that the pace counts.
// Nothing for a spiral, whose turns begin where the one below ended. COSTS: O(n log n) for the
// roads' points. May be called by several threads at once. REQUIRES: the layer has roads.
[[nodiscard]] std::optional<LaidBody> lay_body(const Settings& settings, const LayerPlace& place,
                                               const LaidLayer& laid, const TravelSpace* space,
                                               const MotionSink& sink);

// Whether a print that stands so, at the first road of this layer, goes on with these motions.
[[nodiscard]] bool fits(const LaidBody& body, const MotionState& now, const LayerPlace& place,
                        const Settings& settings);

// Puts the print to where the motions leave it.
void end_body(const LaidBody& body, MotionState& now, MotionTotals& totals);

}  // namespace core
