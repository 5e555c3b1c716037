// What a session tells its host: what the controller says by itself, and what takes long.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "firmware_link/wire/limits.h"       // kEventsMax
#include "firmware_link/wire/ring_buffer.h"  // RingBuffer

namespace firmware_link {

struct SessionEvent {
  enum class Kind {
    kDialect,          // found out how it speaks; text: the dialect's name
    kPauseAsked,       // //action:pause: the printer's operator wants the host to pause
    kResumeAsked,      // //action:resume
    kCancelAsked,      // //action:cancel
    kPaused,           // //action:paused: the controller itself has paused (filament out …)
    kResumed,          // //action:resumed
    kWaits,            // an answer takes a while; text: what is waited for, as "homing (G28)"
    kWaitsForUser,     // busy: paused for user; a button at the printer, or M108
    kAction,           // another //action:; text: its words
    kWarning,          // an error that does not end the print, an unknown command; text: its words
    kResendsFrequent,  // a tenth of the lines is asked for again: look at cable and baud
    kNotReady,         // it answers but is not ready to print, and is waited for; text: its words
    kStopWaits,        // a stop waits until the command at hand ends; text: the command
    kFilamentCorrected,  // a line ran in part or twice: text says by how much, and it was put right
  };
  Kind kind = Kind::kWarning;
  std::string text;
};

// What a host action ("pause" of "//action:pause") asks for; kAction when it is another.
[[nodiscard]] SessionEvent::Kind kind_of_action(std::string_view action);

// The last kEventsMax events; older ones that nobody took are dropped and counted.
class EventQueue {
 public:
  void push(SessionEvent::Kind kind, std::string text) {
    if (events_.full()) {
      (void)events_.pop();
      ++dropped_;
    }
    events_.push({kind, std::move(text)});
  }

  [[nodiscard]] std::optional<SessionEvent> pop() {
    if (events_.empty()) return std::nullopt;
    return events_.pop();
  }

  [[nodiscard]] std::int64_t dropped() const { return dropped_; }

 private:
  RingBuffer<SessionEvent, kEventsMax> events_;
  std::int64_t dropped_ = 0;
};

}  // namespace firmware_link
