// Plug point: how a kind of controller speaks. A variant is a file.
//
// The session does all the counting, timing and repeating; a dialect only says by which rules, and
// what an answer means to a sender.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

#include "firmware_link/wire/capabilities.h"  // Capabilities
#include "firmware_link/wire/instant.h"       // Duration
#include "firmware_link/wire/limits.h"        // kWindowLinesMax
#include "firmware_link/wire/reply.h"         // Reply

namespace firmware_link {

enum class Meaning {
  kNoise,         // means nothing, and doesn't even prove that the controller lives
  kAlive,         // means nothing, but something answers
  kWorking,       // the command at hand takes its time: silence is not to be feared
  kAcknowledge,   // one line is done with
  kRefused,       // a line was not accepted; a request to repeat it and an empty `ok` follow
  kResend,        // reply.number is the line to go on from; an empty `ok` follows
  kWarning,       // a line was accepted but did nothing
  kFilamentHeld,  // a line was accepted, and moved no filament: the nozzle is too cold
  kReset,         // the controller has just begun its life
  kShutDown,      // the print is over, and the controller too; why, it says next, or when asked
  kAlarm,         // the print is over, but the controller still obeys
  kFatal,         // the print is over, and the controller too
};

struct LinkRules {
  // Lines carry a number and a checksum, and may be asked for again. Without, each line has
  // exactly one acknowledgement, and nothing is ever repeated.
  bool numbered = true;

  // Lines carry number and checksum though nothing is ever repeated. REQUIRES: !numbered.
  bool checksummed = false;

  // Its M114 tells what it was commanded, in two decimals, without waiting for motion.
  bool tells_position = false;
  // Its user may shift heights at any time, which M114 then shows (SET_GCODE_OFFSET).
  bool height_may_shift = false;

  // Words that are not a letter and a number are its user's macros, and may take their time.
  bool macros = false;

  // Asks how far its axes go; empty: it cannot be asked.
  std::string_view travel_question = {};

  // Tells it how high its nozzle is: the height follows, in mm, with three decimals.
  std::string_view height_command = "G92 Z";

  // How much motion its planner holds at most, where it plans by time. 0: it counts blocks.
  Duration planned_time_max{};

  std::size_t window_lines = kWindowLinesMax;
  std::size_t window_bytes = kWindowBytesMax;

  // How long nothing at all may be heard while a line is in flight that is answered at once
  // (command_waits.h tells of others), and how long only signs of life that don't prove work
  // (temperatures).
  Duration silence_max{};
  Duration idle_talk_max{};

  // How often a paused print moves nothing for a millisecond, where a controller that stands idle
  // switches heaters and motors off. 0: never.
  Duration keep_awake{};

  // How long an `ok` may be missing before the controller is asked for it, which is not held
  // against it; the same where its planner is taken to be empty, so that it has nothing to do but
  // answer.
  Duration ask_after = std::chrono::seconds(5);
  Duration ask_after_idle = std::chrono::seconds(1);

  // After a Resend, how long it must be quiet before anything is sent again, because lines that
  // were in flight may be answered too, each with a Resend of its own.
  Duration quiet_after_resend{};
};

class Dialect {
 public:
  virtual ~Dialect() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual LinkRules rules() const = 0;
  [[nodiscard]] virtual Meaning meaning_of(const Reply& reply) const = 0;

  // What to ask a controller that answers whether it is ready to print, too; empty: it is. What is
  // not ready answers with an alarm.
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
