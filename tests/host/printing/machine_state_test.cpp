#include "host/printing/machine_state.h"

#include <doctest/doctest.h>

#include <variant>

#include "tests/host/machine_samples.h"

using firmware_link::Heater;
using firmware_link::Move;
using print_test::in_a_road;

namespace {

Move filament(std::int64_t by_10nm) {
  Move move;
  move.e_10nm = by_10nm;
  return move;
}

}  // namespace

TEST_CASE("a command changes what it names and nothing else") {
  host::MachineState state = in_a_road();
  Move move;
  move.x_um = 7;
  state.apply(move);
  CHECK_EQ(state.x_um, 7);
  CHECK_EQ(state.y_um, 60'500);
  CHECK_EQ(state.f_mm_min, 3'600);
  move = {};
  move.f_mm_min = 900;
  state.apply(move);
  CHECK_EQ(state.f_mm_min, 900);
  state.apply(firmware_link::SetTemperature{Heater::kBed, 0, false});
  CHECK_EQ(state.bed_tenths, 0);
  CHECK_EQ(state.nozzle_tenths, 2'100);
  state.apply(firmware_link::SetTemperature{Heater::kNozzle, 1'950, true});
  CHECK_EQ(state.nozzle_tenths, 1'950);
  state.apply(firmware_link::SetFan{3});
  CHECK_EQ(state.fan, 3);
  CHECK(state.ways_of_moving().empty());
  const auto flavor = firmware_link::Flavor::kKlipper;
  state.apply(firmware_link::SetAcceleration{flavor, 800});
  state.apply(firmware_link::SetPressureAdvance{flavor, 4'500});
  CHECK_EQ(print_test::texts_of(state.ways_of_moving()),
           std::vector<std::string>{"SET_PRESSURE_ADVANCE ADVANCE=0.045", "M204 S800"});
  CHECK_EQ(state.z_um, 2'400);
}

TEST_CASE("filament counts as drawn back where it moves alone or is wiped, and never as negative") {
  host::MachineState state = in_a_road();
  state.apply(filament(-100'000));
  CHECK_EQ(state.drawn_back_10nm, 100'000);
  state.apply(filament(40'000));
  CHECK_EQ(state.drawn_back_10nm, 60'000);
  state.apply(filament(500'000));
  CHECK_EQ(state.drawn_back_10nm, 0);
  Move wipe = filament(-30'000);
  wipe.x_um = 1;
  state.apply(wipe);
  CHECK_EQ(state.drawn_back_10nm, 30'000);
  state.apply(filament(30'000));
  Move road = filament(30'000);
  road.x_um = 2;
  state.apply(road);
  CHECK_EQ(state.drawn_back_10nm, 0);
}

TEST_CASE("the highest road is known, not the highest move") {
  host::MachineState state = in_a_road();
  Move move = filament(30'000);
  state.apply(move);
  CHECK_EQ(state.highest_laid_um, 0);
  move.x_um = 1;
  state.apply(move);
  CHECK_EQ(state.highest_laid_um, 2'400);
  Move lift;
  lift.z_um = 30'000;
  state.apply(lift);
  CHECK_EQ(state.highest_laid_um, 2'400);
  move.z_um = 600;
  state.apply(move);
  CHECK_EQ(state.highest_laid_um, 2'400);
}

TEST_CASE("after user G-code the position and the feed are unknown, the heaters as they were") {
  host::MachineState state = in_a_road();
  state.apply(std::get<firmware_link::Verbatim>(firmware_link::verbatim_from("G28")));
  CHECK_FALSE(state.position_known());
  CHECK_FALSE(state.f_mm_min.has_value());
  CHECK_EQ(state.nozzle_tenths, 2'100);
  CHECK_EQ(state.fan, 255);
}

TEST_CASE("a checkpoint tells how the machine is before its layer") {
  core::Settings settings;
  host::Checkpoint checkpoint;
  checkpoint.encoder.x_um = 1'000;
  checkpoint.encoder.z_um = 400;
  checkpoint.motions.nozzle_celsius = 205;
  checkpoint.motions.bed_celsius = 60;
  checkpoint.motions.fan = 0.5;
  host::MachineState state = host::state_at(checkpoint, settings);
  CHECK_EQ(state.x_um, 1'000);
  CHECK_FALSE(state.position_known());
  CHECK_EQ(state.nozzle_tenths, 2'050);
  CHECK_EQ(state.bed_tenths, 600);
  CHECK_EQ(state.fan, 128);
  CHECK_EQ(state.drawn_back_10nm, 0);
  CHECK_EQ(state.highest_laid_um, 0);
  checkpoint.motions.highest = core::Length::from_mm(12.4);
  CHECK_EQ(host::state_at(checkpoint, settings).highest_laid_um, 12'400);
  checkpoint.motions.retracted = true;
  CHECK_EQ(host::state_at(checkpoint, settings).drawn_back_10nm, 100'000);
}
