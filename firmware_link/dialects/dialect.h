// Plug point: how a kind of controller speaks. A variant is a file.
//
// The session counts, times and repeats. A dialect says by which rules, and what each answer means.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

#include "firmware_link/wire/capabilities.h"  // Capabilities
#include "firmware_link/wire/command.h"       // Flavor
#include "firmware_link/wire/instant.h"       // Duration
#include "firmware_link/wire/limits.h"        // kWindowLinesMax
#include "firmware_link/wire/reply.h"         // Reply

namespace firmware_link {

enum class Meaning {
  kNoise,         // means nothing, and does not prove that the controller lives
  kAlive,         // means nothing, but something answers
  kWorking,       // the command at hand takes its time: silence is no fault
  kAcknowledge,   // one line is done with
  kRefused,       // a line was not accepted; a request to repeat it and an empty `ok` follow
  kResend,        // reply.number is the line to send next; an empty `ok` follows
  kWarning,       // a line was accepted but did nothing
  kFilamentHeld,  // a line was accepted, and moved no filament: the nozzle is too cold
  kReset,         // the controller has just started
  kShutDown,      // print and controller are over; the reason comes next, or when it is asked for
  kAlarm,         // the print is over, but the controller still obeys
  kFatal,         // the print is over, and the controller too
};

struct LinkRules {
  // Lines carry a number and a checksum, and may be asked for again. Otherwise each line has
  // exactly one acknowledgement, and nothing is ever repeated.
  bool numbered = true;

  // Lines carry number and checksum though nothing is ever repeated. REQUIRES: !numbered.
  bool checksummed = false;

  // Its M114 tells the commanded position, in two decimals, without waiting for motion.
  bool tells_position = false;
  // Its user may shift heights at any time (SET_GCODE_OFFSET), and M114 shows the shift.
  bool height_may_shift = false;

  // Commands that are not a letter and a number are its user's macros, and may take long.
  bool macros = false;

  // How it spells what firmwares spell in different ways.
  Flavor flavor = Flavor::kMarlin;

  // Asks how far its axes go; empty: it cannot be asked.
  std::string_view travel_question = {};

  // Tells it how high its nozzle is: the height follows, in mm, with three decimals.
  std::string_view height_command = "G92 Z";

  // How much motion its planner holds at most, where it plans by time. 0: it counts blocks.
  Duration planned_time_max{};

  std::size_t window_lines = kWindowLinesMax;
  std::size_t window_bytes = kWindowBytesMax;

  // For lines that are answered at once (command_waits.h has the others): how long nothing at all
  // may be heard, and how long only what proves no work (temperatures).
  Duration silence_max{};
  Duration idle_talk_max{};

  // How often a paused print sends a wait of one millisecond, so that a controller does not switch
  // heaters and motors off for standing idle. 0: never.
  Duration keep_awake{};

  // How long an `ok` may be missing before the controller is asked for it. The second one counts
  // where its planner is taken to be empty, so that it has nothing to do but answer.
  Duration ask_after = std::chrono::seconds(5);
  Duration ask_after_idle = std::chrono::seconds(1);

  // How long it must be quiet after a Resend before a line is sent: each line that was in flight
  // may be answered with a Resend of its own.
  Duration quiet_after_resend{};
};

class Dialect {
 public:
  virtual ~Dialect() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual LinkRules rules() const = 0;
  [[nodiscard]] virtual Meaning meaning_of(const Reply& reply) const = 0;

  // Asks whether a controller is ready to print; one that is not answers with an alarm. Empty: one
  // that answers is ready.
  [[nodiscard]] virtual std::string_view state_question() const { return {}; }
  // Whether a controller that is not ready for this reason becomes ready by itself.
  [[nodiscard]] virtual bool becomes_ready(std::string_view reason) const {
    (void)reason;
    return false;
  }
  // Whether a move was refused because the controller does not know where it is.
  [[nodiscard]] virtual bool lost_its_position(std::string_view alarm) const {
    (void)alarm;
    return false;
  }
  // What a person does about a controller that has halted, as the end of a sentence; may be empty.
  [[nodiscard]] virtual std::string_view remedy() const { return {}; }

  // Why a controller that has lost its position cannot be told its height, and what its user does
  // about that; empty: it can (LinkRules::height_command).
  [[nodiscard]] virtual std::string_view no_height_command(const Capabilities& capabilities) const {
    (void)capabilities;
    return {};
  }

  // Asks which commands it knows, for note_command(); empty: nothing is to be asked.
  [[nodiscard]] virtual std::string_view commands_question() const { return {}; }
  // One line of the answer.
  virtual void note_command(std::string_view line, Capabilities& capabilities) const {
    (void)line;
    (void)capabilities;
  }

  // Puts in what this kind of firmware can do without ever saying so.
  virtual void amend(Capabilities& capabilities) const { (void)capabilities; }
};

}  // namespace firmware_link
