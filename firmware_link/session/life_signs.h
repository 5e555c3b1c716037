// When a controller was last heard, by how much each answer proves; and whether the host itself
// stood still.
#pragma once

#include <algorithm>
#include <chrono>

#include "firmware_link/dialects/dialect.h"  // Meaning
#include "firmware_link/wire/instant.h"      // Instant
#include "firmware_link/wire/reply.h"        // Reply

namespace firmware_link {

class LifeSigns {
 public:
  explicit LifeSigns(Instant now)
      : turn_(now), byte_(now), line_(now), sense_(now), progress_(now) {}

  // A call told the time. Returns how long the host stood still (SIGSTOP, a suspended computer), 0
  // when it did not: all that waits is moved by that, because nothing that was due meanwhile is
  // held against the controller. A session is called every 50 ms.
  [[nodiscard]] Duration turn(Instant now) {
    const Duration gap = now - turn_;
    turn_ = std::max(now, turn_);
    if (gap <= kTurnMax) return Duration(0);
    for (Instant* since : {&byte_, &line_, &sense_, &progress_}) {
      *since = std::min(now, *since + gap);
    }
    return gap;
  }

  void bytes_heard(Instant now) { byte_ = now; }
  void heard(const Reply& reply, Meaning meaning, Instant now) {
    if (meaning != Meaning::kNoise) sense_ = now;
    if (reply.kind != Reply::Kind::kTemperatures) line_ = now;
    if (meaning == Meaning::kWorking || meaning == Meaning::kAcknowledge) progress_ = now;
  }

  // Something was sent to a controller that owed nothing, so its answer is waited for from now on.
  void expect_answer(Instant now) { sense_ = progress_ = now; }
  void expect_progress(Instant now) { progress_ = now; }
  void expect_sense(Instant now) { sense_ = now; }

  [[nodiscard]] Instant byte() const { return byte_; }
  // Any line but temperatures, which may come all the time.
  [[nodiscard]] Instant line() const { return line_; }
  // Any answer that makes sense.
  [[nodiscard]] Instant sense() const { return sense_; }
  // An acknowledgement, or a sign of work.
  [[nodiscard]] Instant progress() const { return progress_; }

 private:
  static constexpr Duration kTurnMax = std::chrono::seconds(2);

  Instant turn_;
  Instant byte_;
  Instant line_;
  Instant sense_;
  Instant progress_;
};

}  // namespace firmware_link
