// When the nozzle leaves the part, waits, and comes back: because the user has asked for a pause,
// or because geometry has fallen behind and the nozzle must not stand on the part.
//
//     printing ──wanted──▶ leaving ──▶ away ──not wanted──▶ returning ──▶ printing
//                   (park_moves.h)          │
//                                       └─ after hot_s: nozzle off; the bed stays warm, or the
//                                          part would come loose
//
// A state machine: time is an argument, and commands come out one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "firmware_link/wire/command.h"   // Command
#include "host/printing/machine_state.h"  // MachineState
#include "host/printing/park_moves.h"     // ParkMoves

namespace host {

class PauseControl {
 public:
  enum class Phase { kPrinting, kLeaving, kAway, kReturning };

  // `hot_s`: how long a paused nozzle stays hot.
  PauseControl(const ParkMoves& park_moves, double hot_s)
      : park_moves_(park_moves), hot_s_(hot_s) {}

  // --- requests; any order, any time ---
  void want_pause(bool wanted) { user_wants_ = wanted; }
  void set_underrun(bool underrun) { underrun_ = underrun; }
  [[nodiscard]] bool pause_wanted() const { return user_wants_; }
  [[nodiscard]] bool underrun() const { return underrun_; }

  // A pause that the print itself has before this command. False: it was wanted once already, also
  // by the print that this one resumes (`last_planned`).
  bool want_planned(std::int64_t command);
  void set_last_planned(std::int64_t command) { last_planned_ = command; }
  [[nodiscard]] std::int64_t last_planned() const { return last_planned_; }

  // Which moves are made from now on.
  void set_park_moves(const ParkMoves& park_moves) { park_moves_ = park_moves; }

  // Makes other moves than those of a pause: they end where the print resumes. `nozzle_z_um`: how
  // high the nozzle is.
  void follow(std::vector<firmware_link::Command> way, std::int64_t nozzle_z_um);

  // --- what follows ---

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool printing() const { return phase_ == Phase::kPrinting; }

  // The next command of the moves off the part or back, if any.
  [[nodiscard]] std::optional<firmware_link::Command> next();

  // Whether advance() would do anything. REQUIRES: next() gave nothing.
  [[nodiscard]] bool advance_due() const {
    return phase_ != Phase::kPrinting || user_wants_ || underrun_;
  }

  // To be called whenever next() gives nothing. True when the phase has changed. `here`: the
  // machine as the print's commands so far have set it.
  bool advance(double now_s, const MachineState& here);

  // The height to which these moves have sent the nozzle so far; nothing: it is on the part.
  [[nodiscard]] std::optional<std::int64_t> nozzle_z_um() const { return nozzle_z_um_; }
  // Whether the nozzle is moving up or down, so that it may not be at that height yet.
  [[nodiscard]] bool height_in_doubt() const {
    return z_given_ && (phase_ == Phase::kLeaving || phase_ == Phase::kReturning);
  }

 private:
  void set_out(Phase phase, std::vector<firmware_link::Command> way);

  ParkMoves park_moves_;
  double hot_s_;
  bool user_wants_ = false;
  bool underrun_ = false;
  std::int64_t last_planned_ = -1;  // the command; -1: none
  bool cooled_ = false;
  double away_since_s_ = 0;
  Phase phase_ = Phase::kPrinting;
  std::deque<firmware_link::Command> way_;
  std::optional<std::int64_t> nozzle_z_um_;
  bool z_given_ = false;  // by the moves of this phase
};

}  // namespace host
