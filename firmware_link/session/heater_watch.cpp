#include "firmware_link/session/heater_watch.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace firmware_link {
namespace {

std::string complaint(const char* name, const char* what, double celsius, double target,
                      Duration time) {
  char text[160];
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time).count();
  std::snprintf(text, sizeof text, "%s %s: %.1f C where %.1f C was asked for, over %lld s", name,
                what, celsius, target, static_cast<long long>(seconds));
  return text;
}

}  // namespace

HeaterWatchLimits nozzle_watch_limits() {
  HeaterWatchLimits limits;
  limits.rise_time = std::chrono::seconds(60);
  limits.fall_celsius = 20;
  limits.fall_time = std::chrono::seconds(60);
  return limits;
}

HeaterWatchLimits bed_watch_limits() {
  HeaterWatchLimits limits;
  limits.rise_time = std::chrono::seconds(240);
  limits.fall_celsius = 15;
  limits.fall_time = std::chrono::seconds(120);
  return limits;
}

std::optional<std::string> HeaterWatch::heard(double celsius, double target, Instant now) {
  if (!std::isfinite(celsius) || !std::isfinite(target)) return std::nullopt;
  if (heard_at_ && now - *heard_at_ > kUnheardMax) {
    const Duration uncounted = now - *heard_at_ - kUnheardMax;
    if (since_) *since_ += uncounted;
    if (low_since_) *low_since_ += uncounted;
  }
  heard_at_ = now;
  if (target != target_) {
    restart();
    target_ = target;
  }
  if (target <= 0) return std::nullopt;
  if (celsius >= target - limits_.near_celsius) {
    reached_ = true;
    since_.reset();
    low_since_.reset();
    return std::nullopt;
  }
  if (reached_) {
    if (celsius > target - limits_.fall_celsius) {
      low_since_.reset();
    } else if (!low_since_) {
      low_since_ = now;
    } else if (now - *low_since_ > limits_.fall_time) {
      return complaint(name_, "has lost its heat", celsius, target, now - *low_since_);
    }
    return std::nullopt;
  }
  if (!since_ || celsius >= base_celsius_ + limits_.rise_celsius) {
    since_ = now;
    base_celsius_ = celsius;
    return std::nullopt;
  }
  if (now - *since_ <= limits_.rise_time) return std::nullopt;
  return complaint(name_, "does not get warmer", celsius, target, now - *since_);
}

}  // namespace firmware_link
