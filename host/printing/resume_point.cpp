#include "host/printing/resume_point.h"

#include <bit>

namespace host {
namespace {

// Of the first `lines` lines behind the last accepted one.
std::int64_t commands_in_flight(const JournalRecord& record, std::int32_t lines) {
  const std::uint32_t all = record.line_kinds;
  return std::popcount(lines >= kJournalLinesMax ? all : all & ((std::uint32_t{1} << lines) - 1));
}

}  // namespace

ResumePoint resume_point(const JournalRecord& record, const FoundController& found) {
  const std::int64_t sent = record.accepted + commands_in_flight(record, record.lines_more);
  if (found.line && *found.line >= record.line && *found.line - record.line <= record.lines_more) {
    return {record.accepted + commands_in_flight(record, *found.line - record.line), true};
  }
  switch (record.state) {
    case PrintState::kReset:
      return {record.sure, false};
    case PrintState::kStopped:
      return {record.accepted, false};
    case PrintState::kRunning:
      if (!found.same_boot) return {record.sure, false};
      return {sent, !found.numbers_lines};
    case PrintState::kPortLost:
    case PrintState::kLinkFault:
      if (!found.numbers_lines) return {sent, true};
      return {record.accepted, false};
  }
  return {record.sure, false};
}

}  // namespace host
