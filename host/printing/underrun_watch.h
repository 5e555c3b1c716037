// Whether geometry keeps up with the printer. While it falls behind the feed sinks
// (feed_throttle.h). With nothing left to lay the nozzle leaves the part (pause_control.h), and
// comes back when enough has gathered.
//
// A state machine: time is an argument.
#pragma once

#include <cstddef>
#include <optional>

#include "host/printing/feed_throttle.h"  // FeedThrottle

namespace host {

class UnderrunWatch {
 public:
  // `underrun_s`: how long nothing may be there to lay before the nozzle leaves; 0: for ever.
  explicit UnderrunWatch(double underrun_s) : underrun_s_(underrun_s) {}

  // What there is to see of the print.
  struct Sight {
    bool streaming = false;      // the session takes commands
    bool road_given = false;     // before the first road nothing stands on a part
    bool all_given = false;      // the end was given as well
    bool command_waits = false;  // one is there to be given
    bool more_to_come = false;   // geometry has not finished
    bool queue_half_full = false;
    std::size_t planner_blocks = 0;
    double ahead_s = 0;     // of motion, made by geometry and not given yet
    bool printing = false;  // neither paused nor on a way
    bool parked = false;    // this watch has sent the nozzle off the part
  };

  enum class Action { kNone, kPark, kComeBack };
  [[nodiscard]] Action look(double now_s, const Sight& sight);

  // Percent of the feed that geometry can follow.
  [[nodiscard]] int feed_percent() const { return feed_percent_; }

 private:
  double underrun_s_;
  FeedThrottle throttle_;
  int feed_percent_ = 100;
  std::optional<double> idle_since_s_;  // nothing to lay, and nothing in the planner
};

}  // namespace host
