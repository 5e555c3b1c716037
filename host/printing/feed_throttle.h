// Slows the print down, little by little, while geometry falls behind it, so that the nozzle moves
// as long as there is anything to lay; where nothing is left it has to leave the part
// (pause_control.h).
//
//     feed %  100 ────────────╮            at kAmple_s of motion ahead and more: as fast as asked
//              25   ╶─────────╯            below: in proportion, never under kSlowest_percent
//                   0      kAmple_s ahead
#pragma once

#include <algorithm>
#include <cmath>

namespace host {

class FeedThrottle {
 public:
  static constexpr double kAmple_s = 4;
  static constexpr int kSlowest_percent = 25;
  static constexpr double kChangePeriod_s = 1;
  static constexpr int kStep_percent = 15;  // smaller changes are not worth a line

  // Percent of the feed. `ahead_s` of motion at full speed waits in the queue; nothing is slowed
  // before the queue was once well filled, or when all that will come is in it.
  int percent(double now_s, double ahead_s, bool more_to_come) {
    armed_ = armed_ || ahead_s >= kAmple_s;
    int wanted = 100;
    if (armed_ && more_to_come && ahead_s < kAmple_s) {
      wanted = std::max(kSlowest_percent, static_cast<int>(std::lround(100 * ahead_s / kAmple_s)));
    }
    if (now_s - changed_s_ < kChangePeriod_s) return percent_;
    const int difference = std::abs(wanted - percent_);
    if (difference < kStep_percent && !(wanted == 100 && difference > 0)) return percent_;
    // Up again by steps: what has just come may be all for a while.
    percent_ = std::min(wanted, percent_ + 2 * kStep_percent);
    changed_s_ = now_s;
    return percent_;
  }

 private:
  bool armed_ = false;
  int percent_ = 100;
  double changed_s_ = -1e9;
};

}  // namespace host
