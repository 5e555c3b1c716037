// Klipper's states, as klippy's webhooks.py and idle_timeout.py keep them.
//
//     startup ──ready_after──> ready ──shut_down()──> shutdown        error: of its configuration
//                                │
//                                └── nothing moves for idle_timeout: motors and heaters off
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware_link/wire/instant.h"  // Instant

namespace firmware_link {

class VirtualKlipperState {
 public:
  enum class State { kStartup, kReady, kShutdown, kError };

  // `config_error`: why it is never ready; empty: no reason.
  void start(std::string_view config_error, Duration ready_after, Instant now);

  [[nodiscard]] bool ready() const { return state_ == State::kReady; }
  [[nodiscard]] bool starting() const { return state_ == State::kStartup; }
  [[nodiscard]] bool becomes_ready() const { return ready_at_.has_value(); }

  // True once, when its microcontrollers are found.
  [[nodiscard]] bool found(Instant now);

  // Shuts down for this reason; false when it had. `was_ready`: it says so by itself.
  [[nodiscard]] bool shut_down(std::string_view words, bool* was_ready);

  // A command that needs motors came.
  void wake() { idle_ = false; }
  // Looks at it now; true once, when it has been idle for so long. `busy`: it moves or has a
  // command.
  [[nodiscard]] bool falls_idle(bool busy, Duration idle_timeout, Instant now);
  // When something happens by itself.
  [[nodiscard]] std::optional<Instant> next(bool busy, Duration idle_timeout) const;

  // What STATUS tells: several lines where it is not ready.
  [[nodiscard]] std::string message() const;

 private:
  State state_ = State::kReady;
  std::string words_;                // why it is shut down, or never ready
  std::optional<Instant> ready_at_;  // when its microcontrollers are found
  bool idle_ = true;                 // motors and heaters are off, or will not be let go
  Instant moved_at_{};
};

}  // namespace firmware_link
