#include "firmware_link/dialects/klipper_dialect.h"

#include <chrono>

namespace firmware_link {
namespace {

bool begins(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

}  // namespace

LinkRules KlipperDialect::rules() const {
  LinkRules rules;
  rules.numbered = false;
  // One slow move behind a full planner; a bed that heats, a long homing, in silence.
  rules.silence_max = std::chrono::minutes(15);
  rules.silence_waiting_max = std::chrono::minutes(60);
  rules.idle_talk_max = std::chrono::minutes(60);
  return rules;
}

Meaning KlipperDialect::meaning_of(const Reply& reply) const {
  using Kind = Reply::Kind;
  switch (reply.kind) {
    case Kind::kOk:
      return Meaning::kAcknowledge;
    case Kind::kAlarm: {
      const bool shut_down = reply.text.find("hutdown") != std::string_view::npos ||
                             reply.text.find("not ready") != std::string_view::npos;
      return shut_down ? Meaning::kFatal : Meaning::kAlarm;
    }
    case Kind::kNote:
      if (begins(reply.text, "Klipper state: Ready")) return Meaning::kReset;
      if (begins(reply.text, "Klipper state:")) return Meaning::kFatal;
      if (begins(reply.text, "Unknown command")) return Meaning::kWarning;
      return Meaning::kAlive;
    case Kind::kHalted:
      return Meaning::kFatal;
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

// M112 is looked for in what arrives, before lines have their turn. Arcs need [gcode_arcs], which
// cannot be asked for, so none are sent.
void KlipperDialect::amend(Capabilities& capabilities) const {
  capabilities.emergency_parser = true;
}

}  // namespace firmware_link
