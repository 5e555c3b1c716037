// Motions that every part of a print makes: fan, acceleration, height, and filament drawn back.
// Each is left out where the print stands so already.
#pragma once

#include <functional>

#include "core/motions/laid_layer.h"    // LaidRoad
#include "core/motions/motion.h"        // Motion
#include "core/motions/motion_state.h"  // MotionState, MotionTotals
#include "core/settings.h"              // Settings
#include "core/units.h"                 // Length

namespace core {

using MotionSink = std::function<void(const Motion&)>;

class NozzleMotions {
 public:
  // All outlive it.
  NozzleMotions(const Settings& settings, MotionState& state, MotionTotals& totals,
                const MotionSink& sink)
      : settings_(settings), state_(state), totals_(totals), sink_(sink) {}

  void set_fan(double share);
  // 0: none is wanted.
  void set_acceleration(double mm_s2);
  void lift(Length to);
  // `last`: the road that the nozzle stands at the end of, to be wiped along; null: none.
  void retract(const LaidRoad* last = nullptr);
  void unretract();

 private:
  void wipe(const LaidRoad& last);

  const Settings& settings_;
  MotionState& state_;
  MotionTotals& totals_;
  const MotionSink& sink_;
};

}  // namespace core
