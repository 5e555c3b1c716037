// What can go wrong between a host and a controller, by name. Each scenario says how it may end:
// with all motions executed exactly once and in order, or with a safe stop for one of the reasons
// that it names, and no other.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "firmware_link/session/session_types.h"       // FaultKind
#include "firmware_link/virtual/virtual_controller.h"  // VirtualDialect
#include "firmware_link/wire/instant.h"                // Duration
#include "tools/faults/damaged_wire.h"                 // WireDamage

namespace firmware_link {

// What happens once, at a line that the seed chooses.
enum class Mishap {
  kNone,
  kReset,        // the board's reset button, a brown-out
  kUnplug,       // the port is gone for good
  kReplug,       // the port is gone for some seconds; the controller lives on
  kKill,         // somebody's M112
  kRunaway,      // the controller's own thermal protection
  kDeadHeaters,  // heaters that never rise, and nothing in the controller that would notice
  kMute,         // hears and says nothing more
  kBusy,         // one command takes minutes, with busy lines
  kUserPause,    // the same, waiting for a button
  kShutdown,     // Klipper: lost communication with a microcontroller
  kAlarm,        // Klipper: a move out of range
  kHostActions,  // //action:pause, then //action:resume
  kNotReady,     // Klipper: it answers, and finds its microcontrollers later
  kDownBefore,   // Klipper: it has shut down before we come
  kRestart,      // Klipper: somebody's RESTART
  kHostStands,   // the host's clock jumps ahead: it was stopped, or suspended
  kStopHoming,   // the print is stopped in a long G28, about which some say nothing
  kLostAnswer,   // the `ok` to a command with Scenario::word is lost, or damaged
  kJump,         // the count of lines jumps back
  kDumbReset,    // the board resets, and its `start` is damaged
  kSilentWork,   // a command with Scenario::word takes minutes, and the controller says nothing
  kBusyForEver,  // one command never ends, with busy lines
  kChatter,      // ten lines of log a second, from the beginning
  kNoise,        // nothing but noise, from the beginning
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
  std::string_view line_end = "\n";  // of what the controller says
  std::string_view says;             // what the reason of its end must hold
  bool may_finish = true;
  std::uint32_t faults = 0;    // bits of fault_bit()
  bool about_answers = false;  // scenario_answers.h
  // A command that comes into the print, if it isn't in it, and has its mishap.
  std::string_view word;
  bool every_move_extrudes = false;
  std::size_t mishap_after = 8;  // lines; the first ones greet
  // How long the nozzle may stand on the part for want of a line (VirtualControllerTotals).
  Duration stood_max{1'500'000};
};

[[nodiscard]] constexpr std::uint32_t fault_bit(FaultKind kind) {
  return std::uint32_t{1} << static_cast<unsigned>(kind);
}

[[nodiscard]] std::span<const Scenario> scenarios();

// nullptr when there is none of that name.
[[nodiscard]] const Scenario* find_scenario(std::string_view name);

}  // namespace firmware_link
