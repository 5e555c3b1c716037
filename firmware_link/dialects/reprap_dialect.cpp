#include "firmware_link/dialects/reprap_dialect.h"

#include <chrono>

namespace firmware_link {

LinkRules RepRapDialect::rules() const {
  LinkRules rules;
  rules.numbered = false;
  rules.checksummed = true;
  rules.window_lines = 1;
  rules.flavor = Flavor::kRepRapFirmware;
  // One slow move behind a full planner.
  rules.silence_max = std::chrono::minutes(15);
  rules.idle_talk_max = std::chrono::minutes(60);
  return rules;
}

Meaning RepRapDialect::meaning_of(const Reply& reply) const {
  using Kind = Reply::Kind;
  switch (reply.kind) {
    case Kind::kOk:
      return Meaning::kAcknowledge;
    case Kind::kError:
      // "Error: Heating fault on heater 1, temperature rising too slowly"
      return reply.text.find("eating fault") != std::string_view::npos ? Meaning::kAlarm
                                                                       : Meaning::kWarning;
    case Kind::kHalted:
      return Meaning::kFatal;
    case Kind::kAlarm:
      return Meaning::kAlarm;
    case Kind::kBusy:
      return Meaning::kWorking;
    case Kind::kUnknownCommand:
      return Meaning::kWarning;
    case Kind::kStart:
      return Meaning::kReset;
    case Kind::kResend:
    case Kind::kWait:
    case Kind::kUnknown:
      return Meaning::kNoise;
    case Kind::kTemperatures:
    case Kind::kAction:
    case Kind::kPosition:
    case Kind::kEcho:
    case Kind::kNote:
    case Kind::kFirmwareName:
    case Kind::kCapability:
      return Meaning::kAlive;
  }
  return Meaning::kNoise;
}

void RepRapDialect::amend(Capabilities& capabilities) const {
  capabilities.emergency_parser = true;  // M112 is looked for in what arrives
  capabilities.arcs = true;
}

}  // namespace firmware_link
