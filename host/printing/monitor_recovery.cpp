// The journal, and going on: after `rind resume`, a lost port, a controller's reset.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <thread>
#include <utility>

#include "firmware_link/session/link_step.h"
#include "host/printing/monitor.h"
#include "host/printing/port_clock.h"
#include "host/printing/told_place.h"

namespace host {
namespace {

using firmware_link::Command;
using firmware_link::FaultKind;
using firmware_link::SessionState;

constexpr int kWait_ms = 5;
constexpr auto kReopenPause = std::chrono::milliseconds(200);
// A controller that was alone for longer may have let its motors go.
constexpr double kMotorsHold_s = 60;

// Stands for a port that has gone, so that the one who owns it may close it.
class GonePort final : public firmware_link::BytePort {
 public:
  [[nodiscard]] std::size_t write(std::span<const std::byte>) override { return 0; }
  [[nodiscard]] std::size_t read(std::span<std::byte>, int) override { return 0; }
  [[nodiscard]] firmware_link::PortState state() const override {
    return firmware_link::PortState::kLost;
  }
};

// No line of a controller is behind this one.
constexpr std::int32_t kNoLine = std::numeric_limits<std::int32_t>::max() - kJournalLinesMax;

}  // namespace

// Of what has been accepted, all before this was executed, whatever becomes of the planner.
// Nothing: no road was accepted, or it is farther back than the history.
std::optional<std::int64_t> Monitor::sure_before(std::int64_t accepted) const {
  if (all_moved_) return accepted;
  const std::int32_t told_free = session_->capabilities().planner_blocks;
  const std::size_t blocks = std::clamp(static_cast<std::size_t>(std::max(told_free, 0)) + 1,
                                        firmware_link::kPlannerBlocks, kPlannerBlocksMax);
  // A command that was accepted behind the way back: that way has emptied the planner.
  std::int64_t sure = session_->accepted() > 0 ? session_base_ : sure_base_;
  const std::chrono::duration<double> planned_max = session_->rules().planned_time_max;
  if (planned_max.count() > 0) {
    const double seconds = planned_max.count() * std::max(1.0, feed_percent_ / 100.0);
    sure = std::max(sure, history_.executed_before(accepted, seconds).value_or(history_.begin()));
  } else {
    sure = std::max(sure, history_.executed_before(accepted, blocks).value_or(sure));
  }
  // Nothing is laid before the first road.
  sure = std::max(sure, first_road_ - 1);
  if (sure < history_.begin() || sure > accepted) return std::nullopt;
  return sure;
}

std::optional<JournalRecord> Monitor::record(PrintState state) const {
  const std::int64_t accepted = session_base_ + session_->accepted();
  if (first_road_ == 0 || accepted > history_.end() || accepted < history_.begin())
    return std::nullopt;
  const std::optional<std::int64_t> sure = sure_before(accepted);
  if (!sure) return std::nullopt;
  const HistoryMark mark = history_.mark_before(*sure);
  if (!mark.checkpoint) return std::nullopt;
  JournalRecord record;
  record.checkpoint = *mark.checkpoint;
  record.sure = *sure;
  record.sure_hash = mark.hash;
  record.accepted = accepted;
  record.machine = history_.state_before(accepted);
  record.nozzle_z_um = pauses_.nozzle_z_um().value_or(record.machine.z_um.value_or(0));
  record.state = state;
  record.layers = options_.layers();
  record.height_in_doubt = pauses_.height_in_doubt();
  record.line = kNoLine;
  // A controller on its way back has its height told in midst of it: until that way is behind it,
  // nobody may take it for one that knows.
  if (!place_known_ && session_->accepted() == 0) return record;
  record.line = session_->accepted_line();
  std::int64_t commands = accepted;
  while (record.lines_more < kJournalLinesMax) {
    const auto through = session_->commands_through_line(record.line + record.lines_more + 1);
    if (!through) break;
    const bool is_command = session_base_ + *through > commands;
    record.line_kinds |= (is_command ? std::uint32_t{1} : 0) << record.lines_more;
    ++record.lines_more;
    commands = session_base_ + *through;
  }
  return record;
}

// Before bytes leave: whatever the controller may get is in the journal.
void Monitor::keep_journal() {
  if (session_->state() != SessionState::kStreaming &&
      session_->state() != SessionState::kFinishing) {
    return;
  }
  if (starting_ || go_on_at_ || first_road_ == 0 || journal() == nullptr) return;
  const std::optional<JournalRecord> now = record(PrintState::kRunning);
  if (!now) return;
  std::string bytes = record_bytes(*now, 0);
  if (bytes == journaled_) return;
  journal()->note(*now, sync_pace_.due(steady_seconds(), now->sure));
  journaled_ = std::move(bytes);
  const std::string& failed = journal()->failed();
  if (!failed.empty() && !journal_complained_) {
    journal_complained_ = true;
    reporter_.note("warning", journal()->path() + ": " + failed +
                                  "; the print goes on, but could not be resumed from here");
  }
}

// What the controller's line numbers meant holds no longer: not in any record.
void Monitor::forget_lines(JournalRecord left, std::int64_t accepted, std::int64_t nozzle_z_um) {
  if (journal() == nullptr) return;
  left.accepted = accepted;
  left.line = kNoLine;
  left.lines_more = 0;
  left.line_kinds = 0;
  left.nozzle_z_um = nozzle_z_um;
  left.height_in_doubt = false;
  journal()->renumber(left);
}

void Monitor::close_journal(PrintState state) {
  if (journal() == nullptr || starting_ || go_on_at_) return;
  std::optional<JournalRecord> last = record(state);
  if (!last) return;
  if (state == PrintState::kStopped && last->machine.z_um && !pauses_.nozzle_z_um()) {
    last->nozzle_z_um = lifted_um(*last->machine.z_um, machine_);
  }
  journal()->note_last(*last);
}

// Finds where to go on, once geometry has shown that it computes the same print; false: not yet.
bool Monitor::start_resumed() {
  const Resumption& resumption = *options_.resumption;
  const JournalRecord& left = resumption.record;
  if (!history_started_) {
    if (peek() == nullptr) {
      // All had been executed already.
      if (queue_.drained() && !queue_.closed()) starting_ = false;
      return !starting_;
    }
    RIND_CHECK(waiting_ && waiting_->before != nullptr);
    history_.begin_at(left.sure, *waiting_->before,
                      {std::make_shared<const Checkpoint>(left.checkpoint), left.sure_hash});
    index_ = sure_base_ = left.sure;
    history_started_ = true;
  }
  if (session_->found_place() && !history_reaches(commands_sent(left))) return false;
  const ResumePoint point = point_of(left, resumption.same_boot);
  unplaced_ = height_unknown(point);
  if (!unplaced_.empty()) return false;
  index_ = left.sure;
  go_on_at_ = point;
  skip_until_ = session_base_ = point.command;
  place_known_ = point.lives;
  first_road_ = left.sure;
  starting_ = false;
  forget_lines(left, std::max(skip_until_, left.sure), resumption.nozzle_z_um);
  const bool told = session_->found_line() || session_->found_place();
  reporter_.note("resume",
                 fmt::format("going on behind command {} of the print{}", skip_until_,
                             point.lives && told ? ", which the controller confirms" : ""),
                 {{"command", skip_until_}});
  return true;
}

// `at_once`: in the print that was interrupted, so that all is still hot.
std::vector<Command> Monitor::way_back(const ResumePoint& point, std::int64_t nozzle_z_um,
                                       bool at_once) const {
  const MachineState here = history_.state_before(point.command);
  const bool in_place = at_once && point.lives;
  std::vector<Command> way =
      in_place ? park_moves_.leave_part(here)
               : park_moves_.begin_anew(
                     here, nozzle_z_um,
                     point.lives ? std::string_view() : session_->rules().height_command);
  // What is accepted behind it tells that all before it was executed (sure_before()).
  if (in_place) way.push_back(command_of("M400"));
  const std::vector<Command> back = park_moves_.come_back(here, false);
  way.insert(way.end(), back.begin(), back.end());
  return way;
}

bool Monitor::recoverable() const {
  const FaultKind kind = session_->fault_kind();
  if (options_.lost_port.wait_s <= 0 || first_road_ == 0 || starting_ || go_on_at_) return false;
  if (!history_.state_before(index_).placed() && history_.end() > history_.begin()) return false;
  return kind == FaultKind::kReset ||
         (kind == FaultKind::kPortLost && options_.lost_port.reopen != nullptr);
}

std::optional<LinkOutcome> Monitor::recover() {
  const bool reset = session_->fault_kind() == FaultKind::kReset;
  const std::optional<JournalRecord> left =
      record(reset ? PrintState::kReset : PrintState::kPortLost);
  if (!left) return faulted();
  if (journal() != nullptr) journal()->note_last(*left);
  const LinkOutcome at_fault = outcome(LinkEnd::kFaulted);
  const std::string reason = session_->reason();
  const double since_s = steady_seconds();
  reporter_.note("fault",
                 reset ? reason
                       : fmt::format("{}; waiting {:.0f} s for it to come back", reason,
                                     options_.lost_port.wait_s),
                 {{"kind", std::string(reset ? "reset" : "port_lost")}, {"layer", last_.layer}});
  past_ = statistics_;
  if (std::optional<LinkOutcome> end = reconnect(reset, since_s + options_.lost_port.wait_s)) {
    if (end->end == LinkEnd::kFaulted) end->reason = reason + "; " + end->reason;
    end->layer = at_fault.layer;
    end->height = at_fault.height;
    return end;
  }
  ResumePoint point = point_of(*left, true);
  if (const std::string unknown = height_unknown(point); !unknown.empty()) {
    LinkOutcome end = at_fault;
    end.reason = reason + "; " + unknown;
    end.measures = "nothing was heated or moved any more";
    return end;
  }
  point.command = std::clamp(point.command, history_.begin(), history_.end());
  std::int64_t z_um = left->nozzle_z_um;
  if (!point.lives) {
    const bool asks = options_.lost_port.nozzle_height &&
                      !(left->height_in_doubt && options_.lost_port.takes_height);
    const auto told = asks ? options_.lost_port.nozzle_height(z_um) : std::nullopt;
    if (!told) {
      LinkOutcome end = at_fault;
      end.reason = reason;
      end.measures = "its heaters are off; nobody said where the nozzle is, so nothing was moved";
      return end;
    }
    z_um = *told;
  }
  session_base_ = index_ = skip_until_ = point.command;
  sure_base_ = left->sure;
  place_known_ = point.lives;
  forget_lines(*left, point.command, z_um);
  finish_said_ = unchecked_road_ = false;
  feed_percent_ = 100;
  const bool at_once = steady_seconds() - since_s < kMotorsHold_s;
  pauses_.go(way_back(point, z_um, at_once), z_um);
  session_->hold(true, link_now());
  ++statistics_.recoveries;
  reporter_.note("resume",
                 fmt::format("the controller is back{}; going on behind command {} of the print",
                             point.lives ? "" : ", and has forgotten where it was", point.command),
                 {{"command", point.command}});
  return std::nullopt;
}

// A new session over the port that came back; an outcome when none came about in time.
std::optional<LinkOutcome> Monitor::reconnect(bool reset, double until_s) {
  static GonePort gone;
  bool open = reset && port_->state() == firmware_link::PortState::kOpen;
  while (true) {
    if (stop_asked() || queue_.closed() || steady_seconds() > until_s) {
      const bool wanted = stop_asked();
      LinkOutcome end = outcome(wanted            ? LinkEnd::kUserStopped
                                : queue_.closed() ? LinkEnd::kGeometryEnded
                                                  : LinkEnd::kFaulted);
      if (end.end == LinkEnd::kFaulted) end.reason = "it did not come back in time";
      end.measures = heaters_off_unheard();
      return end;
    }
    take_requests(link_now());
    report_progress();
    if (!open) {
      // Held open, it could not come back under its name.
      port_ = &gone;
      reopened_.reset();
      std::unique_ptr<firmware_link::BytePort> again =
          options_.lost_port.reopen ? options_.lost_port.reopen() : nullptr;
      if (!again) {
        std::this_thread::sleep_for(kReopenPause);
        continue;
      }
      reopened_ = std::move(again);
      port_ = reopened_.get();
    }
    begin_session(true);
    while (session_->state() == SessionState::kConnecting && !stop_asked() &&
           steady_seconds() <= until_s) {
      firmware_link::step(*session_, *port_, link_now(), kWait_ms);
      tell_events();
    }
    if (session_->state() == SessionState::kStreaming) return std::nullopt;
    open = port_->state() == firmware_link::PortState::kOpen;
  }
}

}  // namespace host
