#include "host/printing/safe_moves.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/motions/motion_builder.h"
#include "host/pipeline/motion_encoder.h"
#include "tests/host/machine_samples.h"

using core::Length;
using firmware_link::Command;
using print_test::texts_of;

namespace {

using Texts = std::vector<std::string>;

Texts safe_sequence(std::int64_t draw_back_10nm, std::optional<std::int64_t> z_um,
                    const core::Settings& settings) {
  Texts texts = texts_of(host::lift_off(draw_back_10nm, z_um, settings));
  if (z_um) texts.push_back(texts_of({host::park_move(settings)}).front());
  for (const std::string& text : texts_of(host::heaters_off())) texts.push_back(text);
  return texts;
}

core::Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x * core::kUnitsPerMm)),
          static_cast<std::int32_t>(std::lround(y * core::kUnitsPerMm))};
}

}  // namespace

TEST_CASE("what is not known is left out of a safe sequence, and the heaters never are") {
  const core::Settings settings;
  const Texts off = {"M104 S0", "M140 S0", "M107"};
  CHECK(texts_of(host::heaters_off()) == off);
  CHECK(safe_sequence(0, std::nullopt, settings) == off);
  CHECK(texts_of(host::lift_off(100'000, std::nullopt, settings)) == Texts{"G1 E-1 F2400"});
  CHECK(texts_of(host::lift_off(-5, 2'400, settings)) == Texts{"G0 Z12.4 F600"});
  CHECK(texts_of(host::lift_off(100'000, 2'400, settings)) ==
        Texts{"G1 E-1 F2400", "G0 Z12.4 F600"});
}

TEST_CASE("the nozzle is lifted by park_lift, never down, never over the axis") {
  core::Settings settings;
  CHECK_EQ(host::lifted_um(2'400, settings), 12'400);
  settings.park_lift = Length::from_mm(0);
  CHECK_EQ(host::lifted_um(2'400, settings), 2'400);
  settings.park_lift = Length::from_mm(50);
  settings.axis_z = Length::from_mm(30);
  CHECK_EQ(host::lifted_um(2'400, settings), 30'000);
  CHECK_EQ(host::lifted_um(31'000, settings), 31'000);
}

// core's end of a print and the host's are two pieces of code: core makes motions, the host has
// only what was sent.
TEST_CASE("a stop makes the very moves that the end of a print makes") {
  for (const double axis_mm : {0.0, 5.0, 400.0}) {
    CAPTURE(axis_mm);
    const bool own_place = axis_mm == 400;
    core::Settings settings;
    settings.axis_z = Length::from_mm(axis_mm);
    settings.park_lift = Length::from_mm(7.5);
    settings.bed_origin_x = Length::from_mm(-100);
    if (own_place) settings.park_x = settings.park_y = Length::from_mm(120);
    settings.end_gcode.clear();
    settings.default_acceleration_mm_s2 = axis_mm == 400 ? 1'200 : 0;
    settings.solid_acceleration_mm_s2 = axis_mm == 400 ? 700 : 0;
    core::MotionBuilder builder(settings);
    host::MotionEncoder encoder(settings);
    host::MachineState machine;
    std::vector<Command> commands;
    const auto sink = [&](const core::Motion& motion) {
      if (const auto command = encoder.encode(motion)) commands.push_back(*command);
    };
    core::Slice slice;
    slice.height = Length::from_mm(0.2);
    slice.region = {};
    const core::Road road{
        core::RoadKind::kSolid, Length::from_mm(0.45), false, {at_mm(1, 1), at_mm(6, 1)}};
    builder.layer(slice, {road}, sink);
    for (const Command& command : commands) machine.apply(command);
    commands.clear();
    builder.finish(sink);
    Texts stop = safe_sequence(host::retraction_10nm(settings), machine.z_um, settings);
    for (const std::string& text : texts_of(host::acceleration_given_back(machine, settings))) {
      stop.push_back(text);
    }
    CHECK(texts_of(commands) == stop);
    CHECK_EQ(texts_of(commands)[2], own_place ? "G0 X20 Y120 F7800" : "G0 X-95 Y5 F7800");
    CHECK_EQ(stop.back(), axis_mm == 400 ? "M204 S1200" : "M107");
  }
}
