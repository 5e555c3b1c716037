// How a print ends.
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "firmware_link/session/link_step.h"
#include "firmware_link/wire/meat_pack.h"  // kMeatPackReset
#include "firmware_link/wire/reply.h"      // LineSplitter, read_reply
#include "host/printing/monitor.h"
#include "host/printing/port_clock.h"

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::FaultKind;
using firmware_link::Instant;
using firmware_link::SessionState;

constexpr int kWait_ms = 5;
// How long a controller that has faulted may take to accept the last bytes, and to tell that it has
// obeyed: what was in flight goes first.
constexpr double kLastWords_s = 2;
// And one that was stopped, to move what it had taken.
constexpr double kMovesEnd_s = 10;
constexpr double kConfirm_s = 3;

// What is true of a controller to which nothing was sent any more.
const char* left_alone(FaultKind kind) {
  return kind == FaultKind::kReset
             ? "nothing more was sent: a controller that starts anew has its heaters off; check "
               "the printer"
             : "nothing more was sent: a controller that has halted switches its heaters off; "
               "check the printer";
}

}  // namespace

std::vector<Command> Monitor::safe_sequence() const {
  using firmware_link::Heater;
  std::vector<Command> commands;
  const bool on_part = first_road_ > 0 && !pauses_.nozzle_z_um();
  if (on_part && settings_.retraction_mm > 0) {
    firmware_link::Move retract;
    retract.extruding = true;
    retract.e_10nm = -std::llround(settings_.retraction_mm * 1e5);
    retract.f_mm_min = std::llround(settings_.retraction_speed_mm_s * 60);
    commands.emplace_back(retract);
  }
  const std::optional<std::int64_t> z_um = history_.state_before(index_).z_um;
  if (on_part && z_um) {
    firmware_link::Move lift;
    lift.z_um = lifted_um(*z_um, machine_);
    lift.f_mm_min = std::llround(settings_.lift_speed_mm_s * 60);
    commands.emplace_back(lift);
  }
  commands.emplace_back(firmware_link::SetTemperature{Heater::kNozzle, 0, false});
  commands.emplace_back(firmware_link::SetTemperature{Heater::kBed, 0, false});
  commands.emplace_back(firmware_link::SetFan{0});
  return commands;
}

LinkOutcome Monitor::outcome(LinkEnd end) const {
  LinkOutcome outcome;
  outcome.end = end;
  if (first_road_ > 0) {
    outcome.layer = last_.layer;
    outcome.height = last_.top;
  }
  return outcome;
}

LinkOutcome Monitor::done() {
  if (journal() != nullptr) journal()->remove();
  return outcome(LinkEnd::kDone);
}

LinkOutcome Monitor::stop(LinkEnd end) {
  LinkOutcome result = outcome(end);
  result.reason = refused_;
  if (!given_) return result;  // nothing was heated or moved
  session_->stop_now(safe_sequence(), link_now());
  while (session_->state() != SessionState::kStopped) {
    if (options_.stop_count() > 1) return halt();
    firmware_link::step(*session_, *port_, link_now(), kWait_ms);
    tell_events();
    if (session_->state() != SessionState::kFaulted) continue;
    LinkOutcome halted = halt();
    halted.end = end == LinkEnd::kUserStopped ? end : LinkEnd::kFaulted;
    halted.reason = session_->reason();
    halted.measures = "the controller did not confirm the safe stop (" + session_->reason() +
                      "), so it was told to halt (M112); check that the heaters are off";
    return halted;
  }
  flush_output(kLastWords_s);
  note_acknowledged();
  all_moved_ = first_road_ > 0 && moves_end();
  close_journal(PrintState::kStopped);
  result.measures = result.layer > 0 ? "nozzle lifted, heaters and fan off" : "heaters and fan off";
  return result;
}

LinkOutcome Monitor::halt() {
  close_journal(PrintState::kReset);
  LinkOutcome result = outcome(LinkEnd::kUserHalted);
  constexpr int kAttempts = static_cast<int>(kLastWords_s * 1000) / kWait_ms;
  const firmware_link::Halt halted = firmware_link::halt(*session_, *port_, kWait_ms, kAttempts);
  switch (halted) {
    case firmware_link::Halt::kTold:
      result.measures = "controller halted (M112); it needs a reset";
      break;
    case firmware_link::Halt::kReset:
      result.measures = "controller told to halt (M112) and reset";
      break;
    case firmware_link::Halt::kMaybe:
      result.measures =
          "controller told to halt (M112); it has no emergency parser, so it may act late: switch "
          "it off";
      break;
    case firmware_link::Halt::kNotSent:
      result.measures = "the halt (M112) could not be sent: switch the printer off";
      break;
  }
  return result;
}

LinkOutcome Monitor::emergency(const std::string& reason) {
  LinkOutcome result = halt();
  result.end = LinkEnd::kFaulted;
  result.reason = "the link gave up: " + reason;
  return result;
}

LinkOutcome Monitor::faulted() {
  LinkOutcome result = outcome(LinkEnd::kFaulted);
  result.reason = session_->reason();
  if (!given_) return result;
  switch (fault_kind()) {
    case FaultKind::kPortLost:
      close_journal(PrintState::kPortLost);
      result.measures = "nothing more could be sent: check that the heaters are off";
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
  session_->stop_now(safe_sequence(), link_now());
  if (session_->output().empty()) {
    result.measures = left_alone(fault_kind());
    return result;
  }
  result.measures = sent_and_heard();
  return result;
}

// What has become of a safe sequence that nobody acknowledges line by line.
std::string Monitor::sent_and_heard() {
  flush_output(kLastWords_s);
  if (!session_->output().empty()) {
    return "nothing more could be sent: check that the heaters are off";
  }
  const double until_s = steady_seconds() + kConfirm_s;
  while (!session_->safe_confirmed() && steady_seconds() < until_s &&
         port_->state() == firmware_link::PortState::kOpen) {
    hear();
  }
  const bool lifted = first_road_ > 0 && !pauses_.nozzle_z_um();
  if (!session_->safe_confirmed()) {
    return std::string(lifted ? "heaters off and a lift were sent" : "heaters off was sent") +
           ", but not confirmed: check the printer";
  }
  return std::string(lifted ? "nozzle lifted and heaters off" : "heaters off") +
         ", as the controller confirms";
}

void Monitor::hear() {
  std::array<std::byte, 256> answer;
  const std::size_t count = port_->read(answer, kWait_ms);
  session_->input(std::span(answer).first(count), link_now());
}

// To a controller that may be there, and may have forgotten where it is: nothing moves.
std::string Monitor::heaters_off_unheard() {
  using firmware_link::Heater;
  if (port_->state() != firmware_link::PortState::kOpen) {
    return "nothing more could be sent: check that the heaters are off";
  }
  const std::array<Command, 3> off = {firmware_link::SetTemperature{Heater::kNozzle, 0, false},
                                      firmware_link::SetTemperature{Heater::kBed, 0, false},
                                      firmware_link::SetFan{0}};
  session_->stop_now(off, link_now());
  flush_output(kLastWords_s);
  return "heaters off was sent, but not confirmed: check the printer";
}

// After a safe stop: waits until all that was accepted has moved. False: not confirmed in time, or
// the user does not want to wait.
bool Monitor::moves_end() {
  // Past the session, which has nothing in flight any more. M114's answer, and not an `ok`, which
  // may be one too many.
  std::string words = session_->may_unpack() ? std::string(firmware_link::kMeatPackReset) : "";
  words += "M400\nM114\n";
  const int stops = options_.stop_count();
  const double until_s = steady_seconds() + kMovesEnd_s;
  std::span<const std::byte> to_write = std::as_bytes(std::span(words));
  firmware_link::LineSplitter lines;
  while (steady_seconds() < until_s && options_.stop_count() <= stops &&
         port_->state() == firmware_link::PortState::kOpen) {
    if (!to_write.empty()) to_write = to_write.subspan(port_->write(to_write));
    std::array<std::byte, 256> bytes{};
    std::span<const std::byte> answer = std::span(bytes).first(port_->read(bytes, kWait_ms));
    while (!answer.empty()) {
      answer = answer.subspan(lines.take(answer));
      const std::optional<std::string_view> line = lines.line();
      if (!line) continue;
      const firmware_link::Reply::Kind kind = firmware_link::read_reply(*line).kind;
      if (kind == firmware_link::Reply::Kind::kPosition) return true;
      if (kind == firmware_link::Reply::Kind::kStart) return false;
      if (kind == firmware_link::Reply::Kind::kHalted) return false;
    }
  }
  return false;
}

void Monitor::flush_output(double limit_s) {
  const double until_s = steady_seconds() + limit_s;
  while (!session_->output().empty() && port_->state() == firmware_link::PortState::kOpen &&
         steady_seconds() < until_s) {
    const Instant now = link_now();
    session_->written(port_->write(session_->output()), now);
    hear();
  }
}

}  // namespace host
