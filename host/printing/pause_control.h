// When the print leaves the part, waits, and comes back: because somebody wants it so, or because
// geometry has fallen behind and the nozzle must not stand on the part.
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

  // The ways from now on.
  void set_park_moves(const ParkMoves& park_moves) { park_moves_ = park_moves; }

  // Goes a way that is not a pause's: `way` ends where the print goes on. `nozzle_z_um`: how high
  // the nozzle is.
  void go(std::vector<firmware_link::Command> way, std::int64_t nozzle_z_um);

  // --- what follows ---

  [[nodiscard]] Phase phase() const { return phase_; }
  [[nodiscard]] bool printing() const { return phase_ == Phase::kPrinting; }

  // The next command of the way, if any.
  [[nodiscard]] std::optional<firmware_link::Command> next();

  // Whether turn() would do anything. REQUIRES: next() gave nothing.
  [[nodiscard]] bool turn_due() const {
    return phase_ != Phase::kPrinting || user_wants_ || underrun_;
  }

  // To be called whenever next() gives nothing; true when the phase has changed. `here`: how the
  // machine is set by the print's commands so far.
  bool turn(double now_s, const MachineState& here);

  // How high the way's commands so far have sent the nozzle; nothing: no way is gone.
  [[nodiscard]] std::optional<std::int64_t> nozzle_z_um() const { return nozzle_z_um_; }
  // Whether it may be there, or still where it was before: it is on its way up or down.
  [[nodiscard]] bool height_in_doubt() const {
    return z_given_ && (phase_ == Phase::kLeaving || phase_ == Phase::kReturning);
  }

 private:
  void set_out(Phase phase, std::vector<firmware_link::Command> way);

  ParkMoves park_moves_;
  double hot_s_;
  bool user_wants_ = false;
  bool underrun_ = false;
  bool cooled_ = false;
  double away_since_s_ = 0;
  Phase phase_ = Phase::kPrinting;
  std::deque<firmware_link::Command> way_;
  std::optional<std::int64_t> nozzle_z_um_;
  bool z_given_ = false;  // by this way
};

}  // namespace host
