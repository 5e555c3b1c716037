#include "host/printing/pause_control.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/host/machine_samples.h"

using firmware_link::Command;
using host::PauseControl;
using print_test::in_a_road;
using print_test::texts_of;

namespace {

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("a pause leaves, waits, lets the nozzle cool, and comes back when nobody wants it") {
  const core::Settings settings;
  const host::ParkMoves park_moves(settings, {5'000, 5'000});
  const host::MachineState here = in_a_road();
  PauseControl pauses(park_moves, 100);
  CHECK_FALSE(pauses.advance_due());
  const auto drain = [&pauses] {
    std::vector<Command> way;
    while (const auto command = pauses.next()) way.push_back(*command);
    return texts_of(way);
  };
  pauses.want_pause(true);
  pauses.set_underrun(true);
  REQUIRE(pauses.advance(0, here));
  CHECK(drain() == texts_of(park_moves.leave_part(here)));
  CHECK_EQ(pauses.nozzle_z_um(), 12'400);
  REQUIRE(pauses.advance(1, here));
  CHECK(pauses.phase() == PauseControl::Phase::kAway);
  pauses.want_pause(false);  // geometry still has nothing
  CHECK_FALSE(pauses.advance(2, here));
  CHECK(drain().empty());
  CHECK_FALSE(pauses.advance(101, here));
  CHECK(drain() == Texts{"M104 S0"});
  CHECK_FALSE(pauses.advance(300, here));
  CHECK(drain().empty());
  pauses.set_underrun(false);
  REQUIRE(pauses.advance(301, here));
  CHECK(drain() == texts_of(park_moves.come_back(here, true)));
  REQUIRE(pauses.advance(302, here));
  CHECK(pauses.printing());
  CHECK_FALSE(pauses.nozzle_z_um().has_value());
}

TEST_CASE("before the first road a pause only waits") {
  const host::ParkMoves park_moves(core::Settings(), {5'000, 5'000});
  PauseControl pauses(park_moves, 100);
  pauses.want_pause(true);
  CHECK(pauses.advance(0, {}));
  CHECK_FALSE(pauses.next().has_value());
  CHECK(pauses.advance(0, {}));
  pauses.want_pause(false);
  CHECK(pauses.advance(1, {}));
  CHECK_FALSE(pauses.next().has_value());
  CHECK(pauses.advance(1, {}));
  CHECK(pauses.printing());
}

TEST_CASE("other moves are followed as a way back, and the height is in doubt while they go") {
  PauseControl pauses(host::ParkMoves(core::Settings(), {5'000, 5'000}), 100);
  firmware_link::Move lift;
  lift.z_um = 9'000;
  pauses.follow({lift, firmware_link::SetFan{0}}, 2'400);
  CHECK(pauses.phase() == PauseControl::Phase::kReturning);
  CHECK_EQ(pauses.nozzle_z_um(), 2'400);
  CHECK_FALSE(pauses.height_in_doubt());
  REQUIRE(pauses.next().has_value());
  CHECK_EQ(pauses.nozzle_z_um(), 9'000);
  CHECK(pauses.height_in_doubt());
  REQUIRE(pauses.next().has_value());
  REQUIRE(pauses.advance(0, in_a_road()));
  CHECK(pauses.printing());
  CHECK_FALSE(pauses.height_in_doubt());
}
