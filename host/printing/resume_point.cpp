#include "host/printing/resume_point.h"

#include <bit>

namespace host {
namespace {

// How many of the first `lines` lines after the last accepted one are commands of the print.
std::int64_t commands_in_flight(const JournalRecord& record, std::int32_t lines) {
  const std::uint32_t all = record.line_kinds;
  return std::popcount(lines >= kJournalLinesMax ? all : all & ((std::uint32_t{1} << lines) - 1));
}

ResumePoint without_line_numbers(const JournalRecord& record, bool same_boot) {
  const std::int64_t sent = record.accepted + commands_in_flight(record, record.lines_more);
  switch (record.state) {
    case PrintState::kReset:
      break;
    case PrintState::kStopped:
      return {record.accepted, false};
    case PrintState::kRunning:
      if (same_boot) return {sent, true};
      break;
    case PrintState::kPortLost:
    case PrintState::kLinkFault:
      return {sent, true};
  }
  return {record.sure, false};
}

}  // namespace

ResumePoint resume_point(const JournalRecord& record, const FoundController& found) {
  if (found.line && *found.line >= record.line && *found.line - record.line <= record.lines_more) {
    return {record.accepted + commands_in_flight(record, *found.line - record.line), true};
  }
  if (!found.numbers_lines) return without_line_numbers(record, found.same_boot);
  return {record.sure, false};
}

}  // namespace host
