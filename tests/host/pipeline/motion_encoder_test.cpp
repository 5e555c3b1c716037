#include "host/pipeline/motion_encoder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

#include "firmware_link/wire/line_codec.h"

using core::Length;
using firmware_link::Command;
using host::MotionEncoder;

namespace {

std::string text_of(const std::optional<Command>& command) {
  if (!command) return "";
  firmware_link::TextBuffer buffer;
  return std::string(firmware_link::encode(*command, buffer));
}

std::int64_t filament_10nm(const std::optional<Command>& command) {
  if (!command) return 0;
  return std::get<firmware_link::Move>(*command).e_10nm.value_or(0);
}

core::Point at_mm(double x, double y) {
  return {static_cast<std::int32_t>(Length::from_mm(x).units()),
          static_cast<std::int32_t>(Length::from_mm(y).units())};
}

}  // namespace

TEST_CASE("each motion has its command") {
  MotionEncoder encoder;
  CHECK_EQ(text_of(encoder.encode(core::LayerStart{})), "");
  CHECK_EQ(text_of(encoder.encode(core::RoadStart{})), "");
  CHECK_EQ(text_of(encoder.encode(core::Travel{at_mm(10.5, -3), 130})), "G0 X10.5 Y-3 F7800");
  CHECK_EQ(text_of(encoder.encode(core::Lift{Length::from_mm(0.2), 10})), "G0 Z0.2 F600");
  CHECK_EQ(text_of(encoder.encode(core::Extrude{at_mm(20, 7), 0.5, 60})), "G1 X20 Y7 E0.5 F3600");
  CHECK_EQ(text_of(encoder.encode(core::MoveFilament{-1, 40})), "G1 E-1 F2400");
  CHECK_EQ(text_of(encoder.encode(core::SetFan{1})), "M106 S255");
  CHECK_EQ(text_of(encoder.encode(core::SetFan{0})), "M107");
  CHECK_EQ(text_of(encoder.encode(core::SetAcceleration{800})), "M204 S800");
  CHECK_EQ(text_of(encoder.encode(core::SetPressureAdvance{0.03})), "M900 K0.03");
  CHECK_EQ(text_of(encoder.encode(core::SetNozzleTemperature{210, true})), "M109 S210");
  CHECK_EQ(text_of(encoder.encode(core::SetBedTemperature{60, false})), "M140 S60");
  CHECK_EQ(text_of(encoder.encode(core::Verbatim{"g28 ; home"})), "G28");
}

TEST_CASE("what the controller knows is not said again, until a user's line may have changed it") {
  MotionEncoder encoder;
  CHECK_EQ(text_of(encoder.encode(core::Travel{at_mm(1, 2), 60})), "G0 X1 Y2 F3600");
  CHECK_EQ(text_of(encoder.encode(core::Travel{at_mm(1, 5), 60})), "G0 Y5");
  CHECK_EQ(text_of(encoder.encode(core::Travel{at_mm(1, 5), 30})), "");
  CHECK_EQ(text_of(encoder.encode(core::Extrude{at_mm(3, 5), 0.1, 60})), "G1 X3 E0.1");
  CHECK_EQ(text_of(encoder.encode(core::Lift{Length::from_mm(1), 60})), "G0 Z1");
  CHECK_EQ(text_of(encoder.encode(core::Lift{Length::from_mm(1), 60})), "");
  CHECK_EQ(text_of(encoder.encode(core::Verbatim{"G28"})), "G28");
  CHECK_EQ(text_of(encoder.encode(core::Lift{Length::from_mm(1), 60})), "G0 Z1 F3600");
  CHECK_EQ(text_of(encoder.encode(core::Travel{at_mm(3, 5), 60})), "G0 X3 Y5");
}

TEST_CASE("positions are rounded to the nearest micrometre, halves away from zero") {
  MotionEncoder encoder;
  CHECK_EQ(text_of(encoder.encode(core::Travel{{10'004, 10'005}, 1})), "G0 X1 Y1.001 F60");
  CHECK_EQ(text_of(encoder.encode(core::Travel{{-10'004, -10'005}, 1})), "G0 X-1 Y-1.001");
}

TEST_CASE("rounding of filament never adds up") {
  constexpr std::uint32_t kSeed = 2'000;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  // Mostly below one unit (10 nm), so that each rounding by itself would be grossly wrong.
  std::uniform_real_distribution<double> filament_mm(0, 2e-5);
  std::uniform_int_distribution<std::int32_t> step(-30, 30);
  MotionEncoder encoder;
  core::Point at{0, 0};
  std::int64_t sent = 0;
  long double asked_mm = 0;
  for (int i = 0; i < 100'000; ++i) {
    at = {at.x + step(random), at.y + step(random)};
    const double mm = i % 1'000 == 0 ? -0.8 : filament_mm(random);
    asked_mm += mm;
    if (i % 1'000 == 0) {
      sent += filament_10nm(encoder.encode(core::MoveFilament{mm, 40}));
    } else {
      // Steps under half a micrometre give no command; their filament must not be lost either.
      sent += filament_10nm(encoder.encode(core::Extrude{at, mm, 60}));
    }
  }
  // The last move may be one that gave no command: its filament waits for the next.
  sent += filament_10nm(encoder.encode(core::Extrude{{at.x + 100'000, at.y}, 0, 60}));
  const double off = static_cast<double>(static_cast<long double>(sent) - asked_mm * 1e5L);
  CHECK_LE(std::abs(off), 1.0);
}

TEST_CASE("places count from the bed's corner, the controller from its own origin") {
  core::Settings settings;
  settings.bed_origin_x = Length::from_mm(-125);
  settings.bed_origin_y = Length::from_mm(-105.5);
  MotionEncoder encoder(settings);
  CHECK_EQ(text_of(encoder.encode(core::Travel{at_mm(125, 110), 60})), "G0 X0 Y4.5 F3600");
  CHECK_EQ(text_of(encoder.encode(
               core::ExtrudeArc{at_mm(127, 112), at_mm(125, 112), false, 3.1415, 0.25, 60})),
           "G3 X2 Y6.5 J2 E0.25");
}

TEST_CASE("an arc is told by its end, its centre from its begin, and which way round") {
  MotionEncoder encoder;
  (void)encoder.encode(core::Travel{at_mm(10, 5), 60});
  CHECK_EQ(text_of(encoder.encode(
               core::ExtrudeArc{at_mm(12, 7), at_mm(10, 7), false, 3.1415, 0.25, 60})),
           "G3 X12 Y7 J2 E0.25");
  CHECK_EQ(
      text_of(encoder.encode(core::ExtrudeArc{at_mm(10, 7), at_mm(11, 7), true, 3.1415, 0.25, 30})),
      "G2 X10 I-1 E0.25 F1800");
}

TEST_CASE("on the wire an arc's radius differs by less than 3 µm from begin to end") {
  std::mt19937 random(17);
  std::uniform_int_distribution<std::int32_t> place(-2'000'000, 2'000'000);
  std::uniform_real_distribution<double> angle(0, 6.28);
  std::uniform_real_distribution<double> radius(2'000, 2'000'000);
  double worst_um = 0;
  for (int i = 0; i < 20'000; ++i) {
    const core::Point centre{place(random), place(random)};
    const double r = radius(random);
    const auto on_it = [&] {
      const double a = angle(random);
      return core::Point{centre.x + static_cast<std::int32_t>(std::lround(r * std::cos(a))),
                         centre.y + static_cast<std::int32_t>(std::lround(r * std::sin(a)))};
    };
    const core::Point from = on_it(), to = on_it();
    if (std::hypot(from.x - to.x, from.y - to.y) < 100) continue;
    MotionEncoder encoder;
    (void)encoder.encode(core::Travel{from, 60});
    const MotionEncoder::State begin = encoder.state();
    const auto command = encoder.encode(core::ExtrudeArc{to, centre, false, 1, 1, 60});
    const auto& arc = *std::get<firmware_link::Move>(*command).arc;
    const auto x = static_cast<double>(*begin.x_um + arc.i_um);
    const auto y = static_cast<double>(*begin.y_um + arc.j_um);
    const double at_end = std::hypot(static_cast<double>(*encoder.state().x_um) - x,
                                     static_cast<double>(*encoder.state().y_um) - y);
    worst_um = std::max(worst_um, std::abs(at_end - std::hypot(arc.i_um, arc.j_um)));
  }
  CHECK_LT(worst_um, 3);
  CHECK_GT(worst_um, 1);
}

TEST_CASE("an object's first move says all that it needs, whatever was laid before it") {
  host::MotionEncoder encoder;
  const core::Travel travel{{100'000, 200'000}, 130};
  REQUIRE(encoder.encode(travel));
  CHECK_FALSE(encoder.encode(travel));
  CHECK_FALSE(encoder.encode(core::ObjectStart{1}));
  const auto again = encoder.encode(travel);
  REQUIRE(again);
  const firmware_link::Move* move = firmware_link::move_of(*again);
  REQUIRE(move != nullptr);
  CHECK(move->x_um == 10'000);
  CHECK(move->y_um == 20'000);
  CHECK(move->f_mm_min == 7'800);
}
