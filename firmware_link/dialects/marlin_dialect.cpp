#include "firmware_link/dialects/marlin_dialect.h"

#include <chrono>

namespace firmware_link {

LinkRules MarlinDialect::rules() const {
  LinkRules rules;
  rules.numbered = true;
  rules.tells_position = true;
  rules.travel_question = "M211";
  // Three busy lines missing in a row.
  rules.silence_max = std::chrono::seconds(6);
  // Builds without busy lines still report temperatures each second while they heat.
  rules.idle_talk_max = std::chrono::seconds(120);
  rules.quiet_after_resend = std::chrono::milliseconds(100);
  return rules;
}

Meaning MarlinDialect::meaning_of(const Reply& reply) const {
  using Kind = Reply::Kind;
  switch (reply.kind) {
    case Kind::kOk:
      return Meaning::kAcknowledge;
    case Kind::kResend:
      return Meaning::kResend;
    case Kind::kError:
      // "checksum mismatch, Last Line: 1" and its kin; other errors (a bad arc) don't stop it.
      return reply.text.find("Last Line:") != std::string_view::npos ? Meaning::kRefused
                                                                     : Meaning::kWarning;
    case Kind::kBusy:
      return Meaning::kWorking;
    case Kind::kUnknownCommand:
      return Meaning::kWarning;
    case Kind::kStart:
      return Meaning::kReset;
    case Kind::kHalted:
      return Meaning::kFatal;
    case Kind::kAlarm:
      return Meaning::kAlarm;
    case Kind::kEcho:
      // "cold extrusion prevented", "too long extrusion prevented"
      return reply.text.find("extrusion prevented") != std::string_view::npos
                 ? Meaning::kFilamentHeld
                 : Meaning::kAlive;
    case Kind::kTemperatures:
    case Kind::kAction:
    case Kind::kPosition:
    case Kind::kNote:
    case Kind::kFirmwareName:
    case Kind::kCapability:
      return Meaning::kAlive;
    // `wait` says that nothing is to be done: with a line in flight, one of both got lost.
    case Kind::kWait:
    case Kind::kUnknown:
      return Meaning::kNoise;
  }
  return Meaning::kNoise;
}

}  // namespace firmware_link
