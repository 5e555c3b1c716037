// Which answer is waited for, since when, and what is to be done about it.
//
//     sent ── ask ──── ask ──────── ask ─ …          an `ok` may be lost: the controller is asked
//       └──── silent ──> resynchronise, a few times  numbered lines, and nothing at all is heard
//       └──── tell ──────────────────────────> give up, each wait has its limit
//
// A pure state machine: the session asks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "firmware_link/dialects/dialect.h"       // LinkRules
#include "firmware_link/session/command_waits.h"  // CommandWait
#include "firmware_link/wire/instant.h"           // Instant

namespace firmware_link {

class SilenceWatch {
 public:
  enum class Step { kWait, kAsk, kResynchronise, kGiveUp };

  // What is in flight, and what was heard last.
  struct Sight {
    std::int64_t head = -1;    // sequence of the oldest line in flight; -1: only a question is
    std::string_view text;     // of the line that is waited for
    CommandWait command;       // likewise
    Instant last_life;         // any answer that makes sense
    Instant last_progress;     // an acknowledgement, or work being done
    Duration planner_time{0};  // how long what is planned takes at most
    bool stands = false;       // its planner is taken to be empty: the nozzle stands on the part
    int questions = 0;         // lines in flight that are questions
    bool may_ask = false;      // a question fits
    bool may_resynchronise = false;
  };

  // `limit`: each wait's limit is at least that (SessionOptions::wait_limit).
  explicit SilenceWatch(Duration limit) : limit_(limit) {}

  [[nodiscard]] Step look(const LinkRules& rules, const Sight& sight, Instant now);

  // The host stood still for so long.
  void bridge(Duration gap, Instant now) {
    began_ = std::min(now, began_ + gap);
    last_ask_ = std::min(now, last_ask_ + gap);
  }
  // Nothing is waited for.
  void over() { head_ = kNothing; }
  // A sign of work came for the line at hand.
  void worked() { works_ = worked_once_ = true, asks_ = 0; }
  // It is told how often to say that it is busy (M113): perhaps never.
  void may_be_silent() { worked_once_ = false; }
  // An answer came.
  void answered() { works_ = false, asks_ = 0; }
  // The question that look() wanted was asked.
  void asked(Instant now) { ++asks_, last_ask_ = now; }

  // The controller waits for a button, or for M108.
  void await_user(bool awaited) { user_awaited_ = awaited; }
  [[nodiscard]] bool user_awaited() const { return user_awaited_; }

  [[nodiscard]] bool works() const { return works_; }
  // Questions since the last answer.
  [[nodiscard]] int asks() const { return asks_; }

  // Once for each wait that takes a while: what is waited for, as "homing (G28)".
  [[nodiscard]] bool tells_wait(const Sight& sight, Instant now);
  [[nodiscard]] static std::string what_of(const Sight& sight);
  // After kGiveUp: a sentence.
  [[nodiscard]] const std::string& reason() const { return reason_; }

 private:
  static constexpr std::int64_t kNothing = -2;

  [[nodiscard]] Step look_long(const LinkRules& rules, const Sight& sight, Instant now);
  [[nodiscard]] Step look_prompt(const LinkRules& rules, const Sight& sight, Instant now);
  [[nodiscard]] bool ask_due(Duration patience, const Sight& sight, Instant now) const;
  [[nodiscard]] Step give_up(std::string why);

  Duration limit_;
  std::int64_t head_ = kNothing;
  Instant began_{};  // since when head_ is the oldest
  Instant last_ask_{};
  int asks_ = 0;
  bool works_ = false;        // busy lines came for the line at hand
  bool worked_once_ = false;  // this controller says when it is busy
  bool user_awaited_ = false;
  bool told_ = false;
  std::string reason_;
};

}  // namespace firmware_link
