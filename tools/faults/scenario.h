// Faults between a host and a controller, by name. Each scenario says how it may end: with all
// motions executed once and in order, or with a safe stop for one of its reasons, and no other.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "firmware_link/session/session_types.h"       // FaultKind
#include "firmware_link/virtual/virtual_controller.h"  // VirtualDialect
#include "firmware_link/wire/instant.h"                // Duration
#include "tools/faults/damaged_wire.h"                 // WireDamage

namespace firmware_link {

// A fault that happens once, at a line that the seed chooses.
enum class Mishap {
  kNone,
  kReset,        // the board's reset button, a brown-out
  kUnplug,       // the port vanishes for good
  kReplug,       // the port vanishes for some seconds; the controller keeps running
  kKill,         // somebody's M112
  kRunaway,      // the controller's own thermal protection
  kDeadHeaters,  // heaters that never rise, and nothing in the controller that would notice
  kMute,         // the controller receives and sends nothing more
  kBusy,         // one command takes minutes, with busy lines
  kUserPause,    // the same, waiting for a button
  kShutdown,     // Klipper: lost communication with a microcontroller
  kAlarm,        // Klipper: a move out of range
  kHostActions,  // //action:pause, then //action:resume
  kNotReady,     // Klipper: it answers, and finds its microcontrollers later
  kDownBefore,   // Klipper: it was shut down before the host connects
  kRestart,      // Klipper: somebody's RESTART
  kHostStands,   // the host's clock jumps ahead: it was stopped, or suspended
  kStopHoming,   // the print is stopped during a long G28, in which some firmwares are silent
  kLostAnswer,   // the `ok` to a command with Scenario::word is lost, or damaged
  kJump,         // the count of lines jumps back
  kDumbReset,    // the board resets, and its `start` is damaged
  kSilentWork,   // a command with Scenario::word takes minutes, and the controller is silent
  kBusyForEver,  // one command never ends, with busy lines
  kChatter,      // ten lines of log a second, from the start
  kNoise,        // only noise, from the start
};

struct Scenario {
  std::string_view name;
  std::string_view what;
  VirtualDialect dialect = VirtualDialect::kMarlin;
  WireDamage down;  // host -> controller
  WireDamage up;
  Mishap mishap = Mishap::kNone;
  bool meatpack = false;
  bool advanced_ok = false;
  std::string_view line_end = "\n";  // of the controller's lines
  std::string_view says;             // text that the reason of its end must contain
  bool may_finish = true;
  std::uint32_t faults = 0;    // bits of fault_bit()
  bool about_answers = false;  // scenario_answers.h
  // The command at which the mishap happens; it is added to the print if it is not in it.
  std::string_view word;
  bool every_move_extrudes = false;
  std::size_t mishap_after = 8;  // lines; the first ones greet
  // How long the nozzle may stand on the part for lack of a line (VirtualControllerTotals).
  Duration stood_max{1'500'000};
};

[[nodiscard]] constexpr std::uint32_t fault_bit(FaultKind kind) {
  return std::uint32_t{1} << static_cast<unsigned>(kind);
}

[[nodiscard]] std::span<const Scenario> scenarios();

// Null if there is no scenario with that name.
[[nodiscard]] const Scenario* find_scenario(std::string_view name);

}  // namespace firmware_link
