#include "host/printing/print_recovery.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "core/check.h"
#include "host/gcode/set_up_lines.h"
#include "host/printing/port_clock.h"         // link_now
#include "host/printing/reported_position.h"  // commands_sent, resume_point_at
#include "host/system/stage_clock.h"          // steady_seconds

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::Instant;

// A controller that was alone for longer may have switched its motors off.
constexpr double kMotorsHold_s = 60;

}  // namespace

PrintRecovery::PrintRecovery(const Parts& parts, std::optional<Resumption> resumption)
    : parts_(parts), resumption_(std::move(resumption)), searching_(resumption_.has_value()) {
  parts_.journal.suspend(searching_);
}

void PrintRecovery::end_search() {
  searching_ = false;
  parts_.journal.suspend(pending());
}

bool PrintRecovery::find_start() {
  const JournalRecord& left = resumption_->record;
  PrintCommands& commands = parts_.commands;
  if (!history_started_) {
    const QueuedCommand* first = commands.peek();
    if (first == nullptr) {
      // All had been executed already.
      if (commands.ended()) end_search();
      return !searching_;
    }
    RIND_CHECK(first->before != nullptr);
    commands.start_at(left.sure, *first->before,
                      {std::make_shared<const Checkpoint>(left.checkpoint), left.sure_hash});
    history_started_ = true;
  }
  const firmware_link::Session& session = parts_.link.session();
  if (session.found_position() && !commands.fill_history(commands_sent(left))) return false;
  const ResumePoint point = point_of(left, resumption_->same_boot);
  failure_ = height_unknown(point);
  if (!failure_.empty()) return false;
  commands.resume(left.sure, point.command);
  commands.set_first_road(left.sure);
  start_point_ = point;
  end_search();
  parts_.journal.start_session(left.sure, point.position_known);
  parts_.journal.renumber(left, std::max(point.command, left.sure), resumption_->nozzle_z_um);
  const bool told = session.found_line() || session.found_position();
  parts_.reporter.note(
      "resume",
      fmt::format("resuming after command {} of the print{}", point.command,
                  point.position_known && told ? ", which the controller confirms" : ""),
      {{"command", point.command}});
  return true;
}

bool PrintRecovery::start_way_back(Instant now) {
  if (!start_point_) return false;
  const ResumePoint point = *std::exchange(start_point_, std::nullopt);
  parts_.journal.suspend(false);
  set_out(point, resumption_->nozzle_z_um, false, now);
  return true;
}

bool PrintRecovery::possible() const {
  if (!parts_.commands.road_given() || pending()) return false;
  const CommandHistory& history = parts_.commands.history();
  return parts_.commands.state().position_known() || history.end() == history.begin();
}

std::optional<PrintRecovery::Failure> PrintRecovery::resume_after_fault(const JournalRecord& left,
                                                                        double fault_s) {
  ResumePoint point = point_of(left, true);
  if (const std::string unknown = height_unknown(point); !unknown.empty()) {
    return Failure{unknown, "nothing was heated or moved any more"};
  }
  const CommandHistory& history = parts_.commands.history();
  point.command = std::clamp(point.command, history.begin(), history.end());
  std::int64_t z_um = left.nozzle_z_um;
  if (!point.position_known) {
    const std::optional<std::int64_t> told =
        parts_.control.nozzle_height(z_um, left.height_in_doubt);
    if (!told) {
      return Failure{{},
                     "its heaters are off; nobody said where the nozzle is, so nothing was moved"};
    }
    z_um = *told;
  }
  parts_.commands.resume(point.command, point.command);
  parts_.journal.start_session(left.sure, point.position_known);
  parts_.journal.renumber(left, point.command, z_um);
  set_out(point, z_um, steady_seconds() - fault_s < kMotorsHold_s, link_now());
  parts_.reporter.note(
      "resume",
      fmt::format("the controller is back{}; resuming after command {} of the print",
                  point.position_known ? "" : ", and has forgotten its position", point.command),
      {{"command", point.command}});
  return std::nullopt;
}

// REQUIRES: what was sent is in the history, as far as there is any.
ResumePoint PrintRecovery::point_of(const JournalRecord& left, bool same_boot) const {
  const firmware_link::Session& session = parts_.link.session();
  const CommandHistory& history = parts_.commands.history();
  const std::optional<firmware_link::Position>& position = session.found_position();
  if (session.numbers_lines() || !position || left.accepted < history.begin() ||
      left.accepted > history.end()) {
    return resume_point(left, {session.found_line(), session.numbers_lines(), same_boot});
  }
  const std::int64_t last = std::max(left.accepted, std::min(commands_sent(left), history.end()));
  return resume_point_at(
      left, {*position, session.found_homed().value_or(false)}, last,
      [&history](std::int64_t command) { return history.state_before(command); });
}

// Of a ready file: the place before the command that all was set up for that the print needs.
const FilePlace* PrintRecovery::file_before(std::int64_t command) const {
  const HistoryMark mark = parts_.commands.history().mark_before(command);
  return mark.checkpoint ? mark.checkpoint->file.get() : nullptr;
}

// Why a controller that has lost its position cannot be told its height, or what else it has
// forgotten; empty: it can, or need not be told.
std::string PrintRecovery::height_unknown(const ResumePoint& point) const {
  if (point.position_known) return {};
  if (const FilePlace* file = file_before(point.command)) {
    const MachineState here = parts_.commands.history().state_before(point.command);
    if (here.shifted) {
      return fmt::format(
          "line {} of the file is reached in coordinates that the file has moved, "
          "and the controller has forgotten them",
          file->lines);
    }
    if (here.nozzle_tenths == 0) {
      return "the controller has forgotten how hot the nozzle was, and no line of the file that "
             "rind knows has told it";
    }
  }
  const firmware_link::Session& session = parts_.link.session();
  return std::string(session.dialect().no_height_command(session.capabilities()));
}

// `still_hot`: in the print that was interrupted, and not long ago.
std::vector<Command> PrintRecovery::way_back(const ResumePoint& point, std::int64_t nozzle_z_um,
                                             bool still_hot) const {
  const MachineState here = parts_.commands.history().state_before(point.command);
  const ParkMoves& moves = parts_.start.park_moves();
  const bool from_here = still_hot && point.position_known;
  const std::string_view height_command =
      point.position_known ? std::string_view() : parts_.link.session().rules().height_command;
  const FilePlace* file = file_before(point.command);
  const std::vector<std::string> set_up =
      file != nullptr ? SetUpLines(file->set_up).lines() : std::vector<std::string>();
  std::vector<Command> way =
      from_here ? moves.leave_part(here) : moves.restart(here, nozzle_z_um, height_command, set_up);
  // What is accepted behind it shows that all before it was executed (JournalWriter::record()).
  if (from_here) way.push_back(command_of("M400"));
  const std::vector<Command> back = moves.come_back(here, false);
  way.insert(way.end(), back.begin(), back.end());
  return way;
}

void PrintRecovery::set_out(const ResumePoint& point, std::int64_t nozzle_z_um, bool still_hot,
                            Instant now) {
  parts_.pauses.follow(way_back(point, nozzle_z_um, still_hot), nozzle_z_um);
  parts_.link.session().hold(true, now);
}

}  // namespace host
