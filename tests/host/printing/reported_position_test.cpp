#include "host/printing/reported_position.h"

#include <doctest/doctest.h>

#include <vector>

namespace {

host::MachineState at(std::int64_t x_um, std::int64_t z_um = 300) {
  host::MachineState state;
  state.x_um = x_um;
  state.y_um = 7'000;
  state.z_um = z_um;
  return state;
}

host::ReportedPosition told(double x_mm, double z_mm, bool homed) {
  host::ReportedPosition told;
  told.position.x_mm = x_mm;
  told.position.y_mm = 7;
  told.position.z_mm = z_mm;
  told.homed = homed;
  return told;
}

}  // namespace

TEST_CASE("which lines were taken is known by the place, and nothing else") {
  host::JournalRecord record;
  record.sure = 50;
  record.accepted = 100;
  record.lines_more = 4;
  record.line_kinds = 0b1011;
  record.nozzle_z_um = 300;
  record.state = host::PrintState::kPortLost;
  CHECK_EQ(host::commands_sent(record), 103);
  const std::vector<host::MachineState> places = {at(1'000), at(2'000), at(2'000), at(4'000)};
  const auto before = [&](std::int64_t command) {
    return places.at(static_cast<std::size_t>(command - 100));
  };
  const auto point = [&](const host::ReportedPosition& where) {
    return host::resume_point_at(record, where, 103, before);
  };
  CHECK_EQ(point(told(1, 0.3, true)).command, 100);
  CHECK_EQ(point(told(2, 0.3, true)).command, 101);  // the first of two alike
  CHECK_EQ(point(told(4, 0.3, true)).command, 103);
  CHECK(point(told(4, 0.3, true)).position_known);
  CHECK_FALSE(point(told(4, 0.3, false)).position_known);  // it stood idle
  CHECK_EQ(point(told(4, 0.3, false)).command, 103);
  CHECK_EQ(point(told(0, 0, false)).command, 50);  // restarted
  CHECK_FALSE(point(told(0, 0, false)).position_known);
  CHECK_EQ(point(told(9, 0.3, true)).command, 50);  // homed by hand
  record.nozzle_z_um = 5'300;                       // parked
  CHECK_EQ(point(told(5, 5.3, true)).command, 100);
  CHECK_EQ(point(told(0, 0, false)).command, 50);
  record.state = host::PrintState::kStopped;
  CHECK_EQ(point(told(1, 5.3, true)).command, 100);
  CHECK_EQ(point(told(0, 0, false)).command, 100);
  record.state = host::PrintState::kReset;
  CHECK_EQ(point(told(0, 0, false)).command, 50);
}
