// Whether a controller that answers is also ready to print, and where it is: for those that are a
// program on a computer (Klipper).
//
//     state? ──ready──────────────────────────────────────────> ready
//      ▲  │ └──ready, to resume──> position? commands? homed? ──┘
//      └──┘ not ready yet: each second, up to ready_wait
//
// A pure state machine: the session sends each question when it is told to ask.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "firmware_link/dialects/dialect.h"   // Dialect
#include "firmware_link/wire/capabilities.h"  // Capabilities
#include "firmware_link/wire/instant.h"       // Instant
#include "firmware_link/wire/reply.h"         // Reply, Position

namespace firmware_link {

class Readiness {
 public:
  enum class Step {
    kWait,
    kAsk,  // question() is to be sent
    kReady,
    kNotReady,  // as kWait; words() are new, and worth telling
    kFault,     // reason() says why
  };

  // Starts with the question for the controller's state.
  void start(Instant now);

  // The question at hand. COSTS: one string.
  [[nodiscard]] std::string question(const Dialect& dialect) const;
  // It is sent, for the first time or again.
  void asks();

  // A line came that is no `ok`.
  void heard(const Reply& reply, const Dialect& dialect, Capabilities& capabilities);

  // The `ok` to the question at hand came. `to_resume`: its position is wanted, too.
  [[nodiscard]] Step answered(const Dialect& dialect, bool to_resume, Instant now);

  [[nodiscard]] Step tick(Duration ready_wait, Instant now);

  // What the controller said, when it was not ready.
  [[nodiscard]] const std::string& words() const { return words_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }

  // Where it was commanded to last, and whether it knows that it is there.
  [[nodiscard]] const std::optional<Position>& found_position() const { return found_position_; }
  [[nodiscard]] std::optional<bool> found_homed() const { return found_homed_; }

  // The host stood still for so long.
  void bridge(Duration gap, Instant now) { since_ = std::min(now, since_ + gap); }

 private:
  enum class Query { kState, kPosition, kCommands, kAbsolute, kHomed };

  [[nodiscard]] Step ask(Query query);
  [[nodiscard]] Step state_told(const Dialect& dialect, bool to_resume, Instant now);

  Query query_ = Query::kState;
  Instant since_{};
  std::string alarm_;               // in the answer at hand
  std::string words_;               // why it was not ready, as it was told to the host
  std::optional<Instant> ask_due_;  // when its state is asked for again
  std::string reason_;
  std::optional<Position> found_position_;
  std::optional<bool> found_homed_;
};

}  // namespace firmware_link
