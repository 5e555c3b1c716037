#include "host/printing/reported_position.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace host {
namespace {

// M114 tells three decimals.
constexpr double kToldHalf_mm = 0.0011;

bool is_at(const std::optional<std::int64_t>& um, const std::optional<double>& told_mm) {
  return um && told_mm && std::abs(static_cast<double>(*um) * 1e-3 - *told_mm) <= kToldHalf_mm;
}

bool stands_at(const MachineState& here, const firmware_link::Position& told) {
  return is_at(here.x_um, told.x_mm) && is_at(here.y_um, told.y_mm) && is_at(here.z_um, told.z_mm);
}

}  // namespace

std::int64_t commands_sent(const JournalRecord& record) {
  const int lines = std::clamp(record.lines_more, 0, kJournalLinesMax);
  const std::uint32_t among =
      lines >= 32 ? record.line_kinds : record.line_kinds & ((std::uint32_t{1} << lines) - 1);
  return record.accepted + std::popcount(among);
}

ResumePoint resume_point_at(const JournalRecord& record, const ReportedPosition& told,
                            std::int64_t last,
                            const std::function<MachineState(std::int64_t)>& before) {
  if (record.state == PrintState::kReset) return {record.sure, told.homed};
  if (record.state == PrintState::kStopped) return {record.accepted, told.homed};
  for (std::int64_t command = record.accepted; command <= last; ++command) {
    if (stands_at(before(command), told.position)) return {command, told.homed};
  }
  const MachineState accepted = before(record.accepted);
  const bool parked = !accepted.position_known() || record.nozzle_z_um != accepted.z_um.value_or(0);
  if (parked && told.homed) return {record.accepted, true};
  return {record.sure, told.homed};
}

}  // namespace host
