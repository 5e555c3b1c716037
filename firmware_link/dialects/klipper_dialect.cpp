#include "firmware_link/dialects/klipper_dialect.h"

#include <chrono>

namespace firmware_link {
namespace {

// The first line of what it answers to anything while it looks for its microcontrollers.
constexpr std::string_view kStartingUp = "Printer is not ready";

}  // namespace

LinkRules KlipperDialect::rules() const {
  LinkRules rules;
  rules.numbered = false;
  rules.tells_position = true;
  rules.height_may_shift = true;
  rules.macros = true;
  rules.flavor = Flavor::kKlipper;
  rules.height_command = "SET_KINEMATIC_POSITION Z=";
  // A second, and what it looks ahead for junctions.
  rules.planned_time_max = std::chrono::milliseconds(2'500);
  // One slow move behind a full planner.
  rules.silence_max = std::chrono::minutes(15);
  rules.idle_talk_max = std::chrono::minutes(60);
  // Its [idle_timeout] is 600 s unless it was set otherwise.
  rules.keep_awake = std::chrono::seconds(20);
  return rules;
}

Meaning KlipperDialect::meaning_of(const Reply& reply) const {
  using Kind = Reply::Kind;
  switch (reply.kind) {
    case Kind::kOk:
      return Meaning::kAcknowledge;
    case Kind::kAlarm:
      if (reply.text.starts_with(kStartingUp)) return Meaning::kReset;
      return reply.text.find("hutdown") != std::string_view::npos ? Meaning::kFatal
                                                                  : Meaning::kAlarm;
    case Kind::kNote:
      // "Ready" is also the answer to anybody's question: nothing starts. "Printer is shutdown"
      // and "Printer is halted" end the long form of a reason.
      if (reply.text.starts_with("Klipper state: Disconnect")) return Meaning::kReset;
      if (reply.text.starts_with("Klipper state: Shutdown")) return Meaning::kShutDown;
      if (reply.text.starts_with("Printer is shutdown")) return Meaning::kShutDown;
      if (reply.text.starts_with("Printer is halted")) return Meaning::kShutDown;
      if (reply.text.starts_with("Unknown command")) return Meaning::kWarning;
      return Meaning::kAlive;
    case Kind::kTemperatures:  // each second in M109
      return Meaning::kWorking;
    case Kind::kUnknown:
    case Kind::kWait:
    case Kind::kResend:
    case Kind::kStart:
      return Meaning::kNoise;
    case Kind::kError:
    case Kind::kUnknownCommand:
      return Meaning::kWarning;
    case Kind::kHalted:  // a macro's words: it says by its state that it has halted
    case Kind::kBusy:
    case Kind::kAction:
    case Kind::kPosition:
    case Kind::kEcho:
    case Kind::kFirmwareName:
    case Kind::kCapability:
      return Meaning::kAlive;
  }
  return Meaning::kNoise;
}

bool KlipperDialect::becomes_ready(std::string_view reason) const {
  return reason.starts_with(kStartingUp);
}

// "Must home axis first", a delta's "Must home first".
bool KlipperDialect::lost_its_position(std::string_view alarm) const {
  return alarm.starts_with("Must home");
}

std::string_view KlipperDialect::remedy() const {
  return "mend the cause, then give Klipper a FIRMWARE_RESTART (in its web page or console)";
}

std::string_view KlipperDialect::no_height_command(const Capabilities& capabilities) const {
  if (capabilities.sets_position) return {};
  return "Klipper does not know any more how high the nozzle is (it was restarted, or stood idle), "
         "and has no command to be told: write [force_move] with enable_force_move: True into its "
         "configuration, give it a RESTART, then run rind resume";
}

// "SET_KINEMATIC_POSITION: Force a low-level kinematic position": there with [force_move]
// enable_force_move alone.
void KlipperDialect::note_command(std::string_view line, Capabilities& capabilities) const {
  if (line.starts_with("SET_KINEMATIC_POSITION")) capabilities.sets_position = true;
}

// M112 is looked for in what arrives, before lines have their turn. Arcs need [gcode_arcs], which
// cannot be asked for, so none are sent.
void KlipperDialect::amend(Capabilities& capabilities) const {
  capabilities.emergency_parser = true;
}

}  // namespace firmware_link
