#include "host/printing/print_ending.h"

#include <optional>

#include "host/printing/port_clock.h"  // link_now
#include "host/printing/safe_moves.h"  // lift_off, park_move, heaters_off
#include "host/system/stage_clock.h"   // steady_seconds

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::FaultKind;
using firmware_link::SessionState;

// How long a controller that has faulted may take to accept the last bytes, and to confirm what it
// was told: what was in flight comes first.
constexpr double kLastBytes_s = 2;
constexpr double kConfirm_s = 3;
// How long one that was stopped may take to move what it had accepted.
constexpr double kMovesEnd_s = 10;

constexpr const char* kNothingSent = "nothing more could be sent: check that the heaters are off";

// What is true of a controller to which nothing was sent any more.
const char* left_alone(FaultKind kind) {
  return kind == FaultKind::kReset
             ? "nothing more was sent: a controller that restarts has its heaters off; check the "
               "printer"
             : "nothing more was sent: a controller that has halted switches its heaters off; "
               "check the printer";
}

const char* halt_text(firmware_link::Halt halted) {
  switch (halted) {
    case firmware_link::Halt::kTold:
      return "controller halted (M112); it needs a reset";
    case firmware_link::Halt::kReset:
      return "controller told to halt (M112) and reset";
    case firmware_link::Halt::kMaybe:
      return "controller told to halt (M112); it has no emergency parser, so it may act late: "
             "switch it off";
    case firmware_link::Halt::kNotSent:
      break;
  }
  return "the halt (M112) could not be sent: switch the printer off";
}

}  // namespace

bool PrintEnding::on_part() const {
  return parts_.commands.road_given() && !parts_.pauses.nozzle_z_um();
}

std::vector<Command> PrintEnding::safe_sequence() const {
  const core::Settings& machine = parts_.start.machine();
  const MachineState here = parts_.commands.state();
  std::vector<Command> commands;
  const auto add = [&commands](const std::vector<Command>& more) {
    commands.insert(commands.end(), more.begin(), more.end());
  };
  if (on_part()) {
    add(here.own_modes());
    add(lift_off(retraction_10nm(machine), lifted_from_um(here), machine));
    if (here.z_um && !here.shifted) commands.push_back(park_move(machine));
  }
  add(heaters_off());
  add(acceleration_given_back(here, machine));
  add(percents_given_back(here));
  return commands;
}

LinkOutcome PrintEnding::outcome(LinkEnd end) const {
  LinkOutcome outcome;
  outcome.end = end;
  if (parts_.commands.road_given()) {
    outcome.layer = parts_.commands.last().layer;
    outcome.height = parts_.commands.last().top;
  }
  return outcome;
}

void PrintEnding::close_journal(PrintState state) {
  if (!parts_.journal.keeps()) return;
  const LinkAccount account = account_of(parts_.link.session(), parts_.feed.told_feed());
  parts_.journal.close(state, account, parts_.start.machine());
}

LinkOutcome PrintEnding::done() {
  parts_.journal.remove();
  return outcome(LinkEnd::kDone);
}

LinkOutcome PrintEnding::stop(LinkEnd end, const std::string& reason) {
  LinkOutcome result = outcome(end);
  result.reason = reason;
  PrinterLink& link = parts_.link;
  if (!link.given()) return result;  // nothing was heated or moved
  firmware_link::Session& session = link.session();
  session.stop_now(safe_sequence(), link_now());
  while (session.state() != SessionState::kStopped) {
    if (parts_.control.stop_urgency() > 1) return halt();
    link.step(link_now());
    while (const auto event = session.next_event()) {
      parts_.reports.tell_event(*event, session, true);
    }
    if (session.state() != SessionState::kFaulted) continue;
    LinkOutcome halted = halt();
    halted.end = end == LinkEnd::kUserStopped ? end : LinkEnd::kFaulted;
    halted.reason = session.reason();
    halted.measures = "the controller did not confirm the safe stop (" + session.reason() +
                      "), so it was told to halt (M112); check that the heaters are off";
    return halted;
  }
  (void)link.flush(kLastBytes_s);
  parts_.reports.note_counts(session.statistics());
  if (parts_.commands.road_given() && link.moves_ended(kMovesEnd_s, parts_.control)) {
    parts_.journal.note_all_moved();
  }
  close_journal(PrintState::kStopped);
  result.measures = result.layer > 0 ? "nozzle lifted, heaters and fan off" : "heaters and fan off";
  return result;
}

LinkOutcome PrintEnding::halt() {
  close_journal(PrintState::kReset);
  LinkOutcome result = outcome(LinkEnd::kUserHalted);
  result.measures = halt_text(parts_.link.halt(kLastBytes_s));
  return result;
}

LinkOutcome PrintEnding::emergency(const std::string& reason) {
  LinkOutcome result = halt();
  result.end = LinkEnd::kFaulted;
  result.reason = "the link gave up: " + reason;
  return result;
}

LinkOutcome PrintEnding::not_resumed(const std::string& reason) {
  LinkOutcome result = outcome(LinkEnd::kFaulted);
  result.reason = reason;
  result.measures = "nothing was heated or moved";
  return result;
}

LinkOutcome PrintEnding::stop_waiting(LinkEnd end) {
  LinkOutcome result = outcome(end);
  if (end == LinkEnd::kFaulted) result.reason = "it did not come back in time";
  result.measures = kNothingSent;
  if (!parts_.link.port_open()) return result;
  parts_.link.session().stop_now(heaters_off(), link_now());
  (void)parts_.link.flush(kLastBytes_s);
  result.measures = "heaters off was sent, but not confirmed: check the printer";
  return result;
}

LinkOutcome PrintEnding::faulted() {
  firmware_link::Session& session = parts_.link.session();
  LinkOutcome result = outcome(LinkEnd::kFaulted);
  result.reason = session.reason();
  if (!parts_.link.given()) return result;
  const FaultKind kind = session.fault_kind();
  switch (kind) {
    case FaultKind::kPortLost:
      close_journal(PrintState::kPortLost);
      result.measures = kNothingSent;
      return result;
    case FaultKind::kHeater:
      result.measures = halt().measures;
      return result;
    case FaultKind::kReset:
    case FaultKind::kHalted:
      close_journal(PrintState::kReset);
      break;
    default:
      close_journal(PrintState::kLinkFault);
      break;
  }
  session.stop_now(safe_sequence(), link_now());
  result.measures = session.output().empty() ? left_alone(kind) : send_and_hear();
  return result;
}

// What has become of a safe sequence that nobody acknowledges line by line.
std::string PrintEnding::send_and_hear() {
  PrinterLink& link = parts_.link;
  if (!link.flush(kLastBytes_s)) return kNothingSent;
  const double until_s = steady_seconds() + kConfirm_s;
  const firmware_link::Session& session = link.session();
  while (!session.safe_confirmed() && steady_seconds() < until_s && link.port_open()) link.hear();
  const bool lifted = on_part();
  if (!session.safe_confirmed()) {
    return std::string(lifted ? "heaters off and a lift were sent" : "heaters off was sent") +
           ", but not confirmed: check the printer";
  }
  return std::string(lifted ? "nozzle lifted and heaters off" : "heaters off") +
         ", as the controller confirms";
}

}  // namespace host
