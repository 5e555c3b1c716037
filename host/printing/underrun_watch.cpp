#include "host/printing/underrun_watch.h"

namespace host {

UnderrunWatch::Action UnderrunWatch::look(double now_s, const Sight& sight) {
  const bool idle =
      !sight.command_waits && !sight.all_given && sight.road_given && sight.planner_blocks <= 1;
  if (!idle) {
    idle_since_s_.reset();
  } else if (!idle_since_s_) {
    idle_since_s_ = now_s;
  }
  if (underrun_s_ <= 0) return Action::kNone;
  if (sight.parked) {
    const bool enough = sight.ahead_s >= FeedThrottle::kAmple_s || sight.queue_half_full;
    return enough || !sight.more_to_come ? Action::kComeBack : Action::kNone;
  }
  if (!sight.road_given || !sight.streaming) return Action::kNone;
  if (sight.more_to_come && sight.printing && idle_since_s_ &&
      now_s - *idle_since_s_ >= underrun_s_) {
    return Action::kPark;
  }
  feed_percent_ = throttle_.percent(now_s, sight.ahead_s, sight.more_to_come);
  return Action::kNone;
}

}  // namespace host
