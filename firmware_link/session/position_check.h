// Whether the controller is where it was sent: the question (M114), its answer, and when a
// difference is believed.
//
//     asked ──told the same──> agrees
//       │ ▲
//       │ └── another answer, or none: asked again, and no move goes before it (8 times at most)
//       └──── the same difference twice in a row: it is real
//
// An account may be damaged as any answer may. And an `ok` too many, such as the tail of a cut line
// gets, makes every answer seem to come late: the account before, or none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "firmware_link/session/position_watch.h"  // PositionWatch
#include "firmware_link/wire/reply.h"              // Position

namespace firmware_link {

class PositionCheck {
 public:
  enum class Outcome {
    kNone,  // no answer was due
    kAgrees,
    kAskAgain,
    kUnconfirmed,  // given up: each answer was another
    kPositionDiffers,
    kFilamentDiffers,
  };
  struct Result {
    Outcome outcome = Outcome::kNone;
    bool told = false;             // the controller has told a position
    std::string words;             // of kPositionDiffers: "at X1.00 Y2.00, not X3.00 Y2.00"
    std::int64_t excess_10nm = 0;  // of kFilamentDiffers: how much more the controller counts
  };

  // What the commands that were given so far lead to.
  [[nodiscard]] PositionWatch& watch() { return watch_; }
  [[nodiscard]] const PositionWatch& watch() const { return watch_; }

  // The question is the line `sequence`, behind all commands that were given.
  // `height_may_shift`: heights are not compared.
  void asked(std::int64_t sequence, bool height_may_shift);

  // The line of the question in flight.
  [[nodiscard]] std::optional<std::int64_t> in_flight() const;
  // Another line was put before the line `sequence`, which moves back.
  void moved_back(std::int64_t sequence);
  // Lines from `sequence` on are sent again: an answer to them is not the one.
  void repeated_from(std::int64_t sequence);

  // The controller tells where it is. Ignored when it was not asked.
  void told(const Position& position);

  // All lines before `acknowledged` are done with.
  [[nodiscard]] Result settle(std::int64_t acknowledged);

  // Whether a difference is being looked at, so that no command may go.
  [[nodiscard]] bool confirming() const { return confirming_; }

  // Forgets question and doubts; what was given stays.
  void drop();

  // The controller's count of filament is a float, and has got coarse: it is to be set back to 0.
  [[nodiscard]] bool count_is_coarse() const;

 private:
  struct Question {
    std::int64_t sequence = 0;
    PositionWatch::Expected expected;
    std::optional<Position> told;
  };

  void end_confirming();

  PositionWatch watch_;
  std::optional<Question> question_;
  bool confirming_ = false;
  std::optional<Position> told_last_;
  int doubts_ = 0;  // answers in a row that differed, or did not come
};

}  // namespace firmware_link
