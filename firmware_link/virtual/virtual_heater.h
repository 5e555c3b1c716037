// A heater of the virtual controller: warms at a constant rate, cools towards the room's warmth.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "firmware_link/wire/instant.h"  // Instant

namespace firmware_link {

class VirtualHeater {
 public:
  VirtualHeater(double ambient_celsius, double heating_celsius_s, Instant now)
      : ambient_(ambient_celsius), rate_(heating_celsius_s), celsius_(ambient_celsius), at_(now) {}

  // Gives no more warmth, whatever is asked of it.
  void break_down() { broken_ = true; }

  void set_target(double celsius) { target_ = celsius; }

  void advance(Instant now) {
    const double seconds = std::chrono::duration<double>(now - at_).count();
    at_ = now;
    if (target_ > celsius_ && !broken_) {
      celsius_ = std::min(target_, celsius_ + rate_ * seconds);
    } else {
      // Loses 1/200 of the difference a second.
      const double rest = broken_ ? ambient_ : std::max(target_, ambient_);
      celsius_ = std::max(rest, ambient_ + (celsius_ - ambient_) * std::exp(-seconds / 200));
    }
  }

  [[nodiscard]] double celsius() const { return celsius_; }
  [[nodiscard]] double target() const { return target_; }

  // What Marlin reports as @: the heater's power of 127.
  [[nodiscard]] int power() const {
    if (target_ <= ambient_ || target_ < celsius_) return 0;
    return target_ > celsius_ ? 127 : 48;
  }

 private:
  double ambient_;
  double rate_;
  double target_ = 0;
  double celsius_;
  Instant at_;
  bool broken_ = false;
};

}  // namespace firmware_link
