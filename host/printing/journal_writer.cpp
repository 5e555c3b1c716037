#include "host/printing/journal_writer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "host/printing/safe_moves.h"  // lifted_um
#include "host/system/stage_clock.h"   // steady_seconds

namespace host {
namespace {

// No line of a controller comes after this one.
constexpr std::int32_t kNoLine = std::numeric_limits<std::int32_t>::max() - kJournalLinesMax;

}  // namespace

void JournalWriter::start_session(std::int64_t sure, bool position_known) {
  sure_base_ = sure;
  position_known_ = position_known;
}

// All before the command that is returned was executed, whatever becomes of the planner. Nothing:
// it is farther back than the history.
std::optional<std::int64_t> JournalWriter::sure_before(std::int64_t accepted,
                                                       const LinkAccount& account) const {
  if (all_moved_) return accepted;
  const CommandHistory& history = commands_.history();
  // A command was accepted behind the way back, which has emptied the planner.
  std::int64_t sure = account.accepted > 0 ? commands_.session_first() : sure_base_;
  if (account.planned_s > 0) {
    sure = std::max(sure,
                    history.executed_before(accepted, account.planned_s).value_or(history.begin()));
  } else {
    sure = std::max(sure, history.executed_before(accepted, account.planner_blocks).value_or(sure));
  }
  // Nothing is laid before the first road.
  sure = std::max(sure, commands_.first_road() - 1);
  if (sure < history.begin() || sure > accepted) return std::nullopt;
  return sure;
}

std::optional<JournalRecord> JournalWriter::record(PrintState state,
                                                   const LinkAccount& account) const {
  const CommandHistory& history = commands_.history();
  const std::int64_t accepted = commands_.session_first() + account.accepted;
  if (!commands_.road_given() || accepted > history.end() || accepted < history.begin()) {
    return std::nullopt;
  }
  const std::optional<std::int64_t> sure = sure_before(accepted, account);
  if (!sure) return std::nullopt;
  const HistoryMark mark = history.mark_before(*sure);
  if (!mark.checkpoint) return std::nullopt;
  JournalRecord record;
  record.checkpoint = *mark.checkpoint;
  record.sure = *sure;
  record.sure_hash = mark.hash;
  record.accepted = accepted;
  record.machine = history.state_before(accepted);
  record.nozzle_z_um =
      pauses_.nozzle_z_um().value_or(record.machine.z_um.value_or(history.last_z_um(accepted)));
  record.state = state;
  record.layers = layers_.load();
  if (objects_ != nullptr) record.cancelled = objects_->cancelled();
  record.last_planned = pauses_.last_planned();
  // The user's own lines may have moved the nozzle.
  record.height_in_doubt = pauses_.height_in_doubt() || !record.machine.z_um;
  record.line = kNoLine;
  // A controller that was reset is told its height on the way back. Until that way is done, it must
  // not be taken for one that knows its position.
  if (!position_known_ && account.accepted == 0) return record;
  record.line = account.line;
  record.lines_more = account.lines_more;
  record.line_kinds = account.line_kinds;
  return record;
}

bool JournalWriter::keeps() const {
  return !suspended_ && commands_.road_given() && control_.journal() != nullptr;
}

void JournalWriter::keep(const LinkAccount& account) {
  if (!keeps()) return;
  const std::optional<JournalRecord> now = record(PrintState::kRunning, account);
  if (!now) return;
  std::string bytes = record_bytes(*now, 0);
  if (bytes == written_) return;
  Journal& journal = *control_.journal();
  journal.note(*now, sync_pace_.due(steady_seconds(), now->sure));
  written_ = std::move(bytes);
  if (!journal.failed().empty() && !complained_) {
    complained_ = true;
    reporter_.note("warning", journal.path() + ": " + journal.failed() +
                                  "; the print continues, but could not be resumed from here");
  }
}

void JournalWriter::close(PrintState state, const LinkAccount& account,
                          const core::Settings& machine) {
  if (control_.journal() == nullptr || suspended_) return;
  std::optional<JournalRecord> last = record(state, account);
  if (!last) return;
  if (state == PrintState::kStopped && last->machine.z_um && !pauses_.nozzle_z_um()) {
    last->nozzle_z_um = lifted_um(*lifted_from_um(last->machine), machine);
  }
  close(*last);
}

void JournalWriter::close(const JournalRecord& last) {
  if (Journal* journal = control_.journal()) journal->note_last(last);
}

void JournalWriter::renumber(JournalRecord left, std::int64_t accepted, std::int64_t nozzle_z_um) {
  Journal* journal = control_.journal();
  if (journal == nullptr) return;
  left.accepted = accepted;
  left.line = kNoLine;
  left.lines_more = 0;
  left.line_kinds = 0;
  left.nozzle_z_um = nozzle_z_um;
  left.height_in_doubt = false;
  journal->renumber(left);
}

void JournalWriter::remove() {
  if (Journal* journal = control_.journal()) journal->remove();
}

}  // namespace host
