#include "host/printing/pause_control.h"

#include <utility>
#include <variant>

namespace host {

using firmware_link::Command;

void PauseControl::set_out(Phase phase, std::vector<Command> way) {
  phase_ = phase;
  z_given_ = false;
  way_.assign(way.begin(), way.end());
}

bool PauseControl::want_planned(std::int64_t command) {
  if (command == last_planned_) return false;
  last_planned_ = command;
  user_wants_ = true;
  return true;
}

void PauseControl::follow(std::vector<Command> way, std::int64_t nozzle_z_um) {
  set_out(Phase::kReturning, std::move(way));
  nozzle_z_um_ = nozzle_z_um;
}

std::optional<Command> PauseControl::next() {
  if (way_.empty()) return std::nullopt;
  Command command = way_.front();
  way_.pop_front();
  const auto* move = std::get_if<firmware_link::Move>(&command);
  if (move != nullptr && move->z_um) {
    nozzle_z_um_ = move->z_um;
    z_given_ = true;
  }
  return command;
}

bool PauseControl::advance(double now_s, const MachineState& here) {
  const bool wanted = user_wants_ || underrun_;
  switch (phase_) {
    case Phase::kPrinting:
      if (!wanted) return false;
      set_out(Phase::kLeaving, park_moves_.leave_part(here));
      return true;
    case Phase::kLeaving:
      phase_ = Phase::kAway;
      away_since_s_ = now_s;
      cooled_ = false;
      return true;
    case Phase::kAway:
      if (!wanted) {
        set_out(Phase::kReturning, park_moves_.come_back(here, cooled_));
        return true;
      }
      // Where nobody has told how hot it is to be, nobody could heat it again.
      if (!cooled_ && here.nozzle_tenths > 0 && now_s - away_since_s_ >= hot_s_) {
        cooled_ = true;
        way_.emplace_back(firmware_link::SetTemperature{firmware_link::Heater::kNozzle, 0, false});
      }
      return false;
    case Phase::kReturning:
      phase_ = Phase::kPrinting;
      nozzle_z_um_.reset();
      return true;
  }
  return false;
}

}  // namespace host
