// Why a controller has shut down, which it says only when it is asked, or a moment later.
//
//     "Klipper state: Shutdown" ──STATUS──> "!! Lost communication with MCU 'mcu'": shut down
//     "!! Must home axis first" ──1 s──> nothing: it refused a command
//                                  └──> "Klipper state: Disconnect": it is being restarted
//
// Klipper that is being restarted lets its motors go first, and refuses what comes then; that it is
// restarted, it says some milliseconds later.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "firmware_link/wire/instant.h"  // Instant

namespace firmware_link {

class ShutdownReason {
 public:
  // It says that it has shut down; false when it said so before.
  [[nodiscard]] bool shut_down(std::string_view words, Instant now) {
    if (shut_down_since_) return false;
    shut_down_since_ = now;
    words_ = std::string(words);
    return true;
  }

  // It refused a move because it does not know its position. True when nothing was waited for
  // before.
  [[nodiscard]] bool position_lost(std::string_view words, Instant now) {
    if (awaited()) return false;
    position_lost_since_ = now;
    words_ = std::string(words);
    return true;
  }

  // Whether a reason is waited for. Nothing is sent meanwhile.
  [[nodiscard]] bool awaited() const { return shut_down_since_ || position_lost_since_; }
  [[nodiscard]] bool is_shut_down() const { return shut_down_since_.has_value(); }
  [[nodiscard]] bool is_lost() const { return position_lost_since_.has_value(); }
  // What it said first.
  [[nodiscard]] const std::string& words() const { return words_; }

  // Whether the wait is over. `in_flight`: a line is, and ends before a reason is told.
  [[nodiscard]] bool over(bool in_flight, Instant now) const {
    if (!shut_down_since_) return now - *position_lost_since_ > kWait;
    return now - *shut_down_since_ > (in_flight ? kWaitBehindLine : kWait);
  }

  // The host stood still for so long.
  void bridge(Duration gap, Instant now) {
    for (std::optional<Instant>* since : {&shut_down_since_, &position_lost_since_}) {
      if (*since) *since = std::min(now, **since + gap);
    }
  }

 private:
  // The reason comes within milliseconds, as the answer to our question; where something was in
  // flight, that ends first (a homing took more than a second).
  static constexpr Duration kWait = std::chrono::seconds(1);
  static constexpr Duration kWaitBehindLine = std::chrono::seconds(3);

  std::optional<Instant> shut_down_since_;
  std::optional<Instant> position_lost_since_;
  std::string words_;
};

}  // namespace firmware_link
