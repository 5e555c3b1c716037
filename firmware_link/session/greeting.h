// How a conversation starts: when the greeting is sent, again and again, and what its answers mean.
//
//     banner ──quiet, or `start`──> greeting ──ok──> asking (M115) ──> settling ──> …
//        ▲                          │  ▲
//        └── reset seen             └──┘ refused, or no answer: greetings_max times
//
// The greeting is "\nN0M110*3\n". The end of line first finishes whatever half line the controller
// may hold. The number is that of the line itself, which Marlin sets as it reads it; "M110 N0"
// would set it when its turn in the queue comes, behind lines that an `ok` too many has let in,
// which then ran twice. All dialects get it numbered: those that number nothing read over it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware_link/dialects/dialect.h"       // Meaning
#include "firmware_link/session/life_signs.h"     // LifeSigns
#include "firmware_link/session/output_buffer.h"  // OutputBuffer
#include "firmware_link/session/session_types.h"  // SessionOptions
#include "firmware_link/wire/instant.h"           // Instant
#include "firmware_link/wire/reply.h"             // Reply

namespace firmware_link {

// How far a conversation has come. kGreeting comes again in mid-stream when the line numbers have
// run out.
enum class Phase {
  kBanner,    // the controller may say by itself that it has started
  kGreeting,  // an answer to the greeting is waited for
  kAsking,    // what it is has been asked (M115)
  kSettling,  // answers to questions that were asked twice have to come first
  kReadying,  // readiness.h
  kOpen,
};

class Greeting {
 public:
  explicit Greeting(Instant now) : since_(now) {}

  enum class Step {
    kWait,
    kGreet,
    kGreetLate,  // and an answer was waited for: worth telling, once
    kSettled,
    kGiveUp,
  };
  // REQUIRES: phase is kBanner, kGreeting or kSettling.
  [[nodiscard]] Step look(Phase phase, const SessionOptions& options, const LifeSigns& signs,
                          Instant now) const;

  // Puts a greeting, or before it the question for the last line of the host before us.
  // `phase`: the one that it is sent from. Nothing is put where there is no room, it comes again.
  void put(Phase phase, const SessionOptions& options, Instant now, OutputBuffer& output);

  // An answer came; true when it was the `ok` to the greeting.
  [[nodiscard]] bool accepted_by(const Reply& reply, Meaning meaning);

  // `start` was heard; false when it comes again and again.
  [[nodiscard]] bool started(Instant now);

  // The phases kAsking and kSettling start.
  void next_phase(Instant now) { since_ = now; }
  // M115 was sent long ago: its answer may have been damaged beyond recognition, and by now
  // something else is answered.
  [[nodiscard]] bool name_overdue(Instant now) const;
  [[nodiscard]] bool may_greet_again(const SessionOptions& options) const {
    return greetings_ < options.greetings_max;
  }
  // Another greeting is due in mid-stream.
  void forget_count() { greetings_ = 0; }

  // After kGiveUp: a sentence.
  [[nodiscard]] std::string reason() const;

  // The last line of the host before us, where the controller told it.
  [[nodiscard]] std::optional<std::int32_t> found_line() const { return found_line_; }

  // The host stood still for so long.
  void bridge(Duration gap, Instant now) { since_ = std::min(now, since_ + gap); }

 private:
  Instant since_;  // when the phase at hand started
  int greetings_ = 0;
  bool refused_ = false;
  bool skips_ok_ = false;  // the next one belongs to a refused line
  int starts_ = 0;
  bool asks_line_ = false;  // the greeting at hand asks for the line before us
  int lines_asked_ = 0;
  std::optional<std::int32_t> found_line_;
};

}  // namespace firmware_link
