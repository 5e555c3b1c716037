// What lines of a ready file mean, in whatever modes; what is sent of them; what is not.
#include "host/gcode/line_meaning.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "firmware_link/wire/line_codec.h"  // checksum_of
#include "host/gcode/set_up_lines.h"

using firmware_link::Effect;
using firmware_link::Flavor;
using firmware_link::PlaceAfter;
using host::GcodeModes;
using host::LineMeaning;
using host::MeaningRules;

namespace {

LineMeaning read(const std::string& text, GcodeModes& modes, const MeaningRules& rules = {}) {
  const auto meaning = host::meaning_of(text, rules, modes);
  if (!meaning.ok()) FAIL(text << ": " << meaning.error().message);
  REQUIRE(meaning.value().has_value());
  return *meaning.value();
}

std::string why_not(const std::string& text, const MeaningRules& rules = {}) {
  GcodeModes modes;
  const auto meaning = host::meaning_of(text, rules, modes);
  return meaning.ok() ? "" : meaning.error().message;
}

std::string sent(const std::string& text) {
  GcodeModes modes;
  return std::string(read(text, modes).line.words.text());
}

GcodeModes after(const std::vector<std::string>& lines, Flavor flavor = Flavor::kMarlin) {
  GcodeModes modes;
  MeaningRules rules;
  rules.flavor = flavor;
  for (const std::string& line : lines) (void)read(line, modes, rules);
  return modes;
}

}  // namespace

TEST_CASE("whatever the modes, the moves are those of the truth") {
  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto whole = [&random](int most) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most;
  };
  for (int program = 0; program < 200; ++program) {
    GcodeModes modes;
    (void)read("G1 X0 Y0 Z0 F1500", modes);
    std::array<std::int64_t, 3> truth_um{};
    std::int64_t count_10nm = 0;
    bool relative = false, relative_filament = false, inches = false;
    for (int line = 0; line < 60; ++line) {
      switch (random() % 8) {
        case 0:
          relative = random() % 2 == 0;
          relative_filament = relative;  // as Marlin has it
          (void)read(relative ? "G91" : "G90", modes);
          continue;
        case 1:
          relative_filament = random() % 2 == 0;
          (void)read(relative_filament ? "M83" : "M82", modes);
          continue;
        case 2:
          inches = random() % 2 == 0;
          (void)read(inches ? "G20" : "G21", modes);
          continue;
        case 3:
          count_10nm = inches ? 0 : whole(500'000);
          (void)read(fmt::format("G92 E{:.5f}", static_cast<double>(count_10nm) * 1e-5), modes);
          continue;
        default:
          break;
      }
      // In inches by steps of 1/100 inch, so that nothing is rounded.
      const std::int64_t step = inches ? 254 : 1;
      const double unit = inches ? 1 / 25.4 : 1;
      std::string text = "G1";
      std::array<std::int64_t, 3> to = truth_um;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (random() % 3 == 0) continue;
        const std::int64_t by = whole(20'000) * step;
        to[axis] += by;
        const auto shown = static_cast<double>(relative ? by : to[axis]) * 1e-3 * unit;
        text += fmt::format(" {}{:.7f}", "XYZ"[axis], shown);
      }
      const std::int64_t filament = whole(300'000);
      const double told = static_cast<double>(relative_filament ? filament : count_10nm + filament);
      text += fmt::format(" E{:.7f}", told * 1e-5 * unit);
      CAPTURE(text);
      const LineMeaning meaning = read(text, modes);
      truth_um = to;
      const std::int64_t rounding = inches ? 3 : 0;
      CHECK_LE(std::abs(*modes.x_um - truth_um[0]), rounding);
      CHECK_LE(std::abs(*modes.y_um - truth_um[1]), rounding);
      CHECK_LE(std::abs(*modes.z_um - truth_um[2]), rounding);
      CHECK_LE(std::abs(*meaning.line.move.e_10nm - filament), 200 * rounding);
      // What the controller has rounded itself; the truth goes on from there.
      truth_um = {*modes.x_um, *modes.y_um, *modes.z_um};
      count_10nm = modes.e_count_10nm;
    }
  }
}

TEST_CASE("words are sent as they are, without numbers and comments") {
  CHECK_EQ(sent("G1 X10.500 Y.25E.03"), "G1 X10.500 Y.25E.03");
  CHECK_EQ(sent("  G1 X1  Y2 "), "G1 X1  Y2");
  CHECK_EQ(sent("g1 x5 (note) y6"), "G1 X5  Y6");
  CHECK_EQ(sent("M117 Layer (3) of 9"), "M117 Layer (3) of 9");
  CHECK_EQ(sent("m862.6 p\"Input shaper\""), "M862.6 P\"Input shaper\"");
  const std::string numbered = "N12 G1 X3";
  CHECK_EQ(sent(fmt::format("{}*{}", numbered, firmware_link::checksum_of(numbered))), "G1 X3");
  CHECK_EQ(sent("N7 G28"), "G28");
  CHECK_NE(why_not("N12 G1 X3*1").find("checksum"), std::string::npos);
  GcodeModes modes;
  for (const char* nothing : {"", "   ", "%", "(only a note)", "// a note", "@pause", "N5"}) {
    const auto meaning = host::meaning_of(nothing, {}, modes);
    REQUIRE(meaning.ok());
    CHECK_FALSE(meaning.value().has_value());
  }
}

TEST_CASE("what does harm is refused unless it is allowed") {
  CHECK_NE(why_not("M500").find("--allow-gcode M500"), std::string::npos);
  CHECK_NE(why_not("G1 X5 M500").find("M500"), std::string::npos);
  MeaningRules allowed;
  allowed.allowed = {"M500"};
  CHECK_EQ(why_not("M500", allowed), "");
  CHECK_NE(why_not("M112", allowed), "");
  CHECK_NE(why_not("M117 " + std::string(90, 'x')).find("95 characters"), std::string::npos);
  CHECK_NE(why_not("M117 gr\xC3\xBC\xC3\x9F").find("printable"), std::string::npos);
  CHECK_NE(why_not("=7"), "");
}

TEST_CASE("temperatures, fan, factors, tools") {
  const GcodeModes modes = after({"M104 S210.5", "M140 S60", "M106 S128", "M220 S95", "M221 S103",
                                  "M106 P1 S9", "M104 T1 S99"});
  CHECK_EQ(modes.nozzle_tenths, 2105);
  CHECK_EQ(modes.bed_tenths, 600);
  CHECK_EQ(modes.fan, 128);
  CHECK_EQ(modes.feed_percent, 95);
  CHECK_EQ(modes.flow_percent, 103);
  CHECK_EQ(after({"T1", "M104 S200"}).tool, 1);
  CHECK_EQ(after({"T1", "M104 T1 S200"}).nozzle_tenths, 2000);
  CHECK_EQ(after({"M109 R215", "M107"}).nozzle_tenths, 2150);
  CHECK_EQ(after({"SET_HEATER_TEMPERATURE HEATER=extruder TARGET=230"}).nozzle_tenths, 2300);
}

TEST_CASE("where the nozzle is: lost by homing, kept by a change of filament") {
  GcodeModes modes = after({"G90", "M83", "G1 X5 Y6 Z7 F600"});
  CHECK_EQ(modes.x_um, 5'000);
  (void)read("G28 X", modes);
  CHECK_FALSE(modes.x_um);
  CHECK_EQ(modes.y_um, 6'000);
  (void)read("G1 X1", modes);
  (void)read("M600", modes);
  CHECK_EQ(modes.x_um, 1'000);
  CHECK_EQ(read("M600", modes).line.place, PlaceAfter::kAsBefore);
  // Nobody knows what a macro does, but the file relies on it once roads are laid.
  (void)read("PRINT_START BED=60", modes);
  CHECK_FALSE(modes.x_um);
  (void)read("G1 X1 Y2 Z3 E1", modes);
  (void)read("TIMELAPSE_TAKE_FRAME", modes);
  CHECK_EQ(modes.x_um, 1'000);
  (void)read("G92 X0", modes);
  CHECK_FALSE(modes.x_um);
  CHECK(modes.shifted);
  (void)read("G28", modes);
  CHECK_FALSE(modes.shifted);
  // Relative moves from nowhere lead nowhere.
  (void)read("G91", modes);
  (void)read("G1 X5", modes);
  CHECK_FALSE(modes.x_um);
}

TEST_CASE("a file may print objects one after another: its highest road is known") {
  const GcodeModes modes = after({"G90", "M83", "G28", "G0 X5 Y6 Z7 F600", "G1 X9 E1", "G0 Z40",
                                  "G0 X90", "G0 Z0.2", "G1 X99 E1"});
  CHECK_EQ(modes.z_um, 200);
  CHECK_EQ(modes.highest_laid_um, 7'000);
}

TEST_CASE("G90 behind M83 means two things") {
  const std::vector<std::string> lines = {"M83", "G90"};
  CHECK(after(lines).modes == 0);
  CHECK(after(lines, Flavor::kKlipper).modes == Effect::kRelativeFilament);
  CHECK(after(lines).filament_mode_unclear);
  CHECK_FALSE(after({"G90", "M83"}).filament_mode_unclear);
}

TEST_CASE("an arc is as long as it is") {
  GcodeModes modes = after({"G1 X10 Y0 F600"});
  const auto length = [&](const std::string& text) {
    GcodeModes from = modes;
    return read(text, from).line.move.arc->length_um;
  };
  CHECK_EQ(length("G3 X0 Y10 I-10 J0 E1"), std::lround(5'000 * std::acos(-1)));
  CHECK_EQ(length("G2 X0 Y10 I-10 J0 E1"), std::lround(15'000 * std::acos(-1)));
  CHECK_EQ(length("G2 I-10"), std::lround(20'000 * std::acos(-1)));
  CHECK_EQ(length("G3 X0 Y10 R10"), std::lround(5'000 * std::acos(-1)));
}

TEST_CASE("lines that set up are kept as few, and told again whole") {
  host::SetUpLines lines;
  for (const char* line :
       {"M204 P800", "M900 K0.05", "M204 T1500", "M204 P900", "M220 S90", "G18", "G17",
        "SET_PRESSURE_ADVANCE ADVANCE=0.1", "SET_PRESSURE_ADVANCE SMOOTH_TIME=0.02 ADVANCE=0.2"}) {
    lines.add(line);
  }
  CHECK_EQ(lines.lines(),
           std::vector<std::string>{"M900 K0.05", "M204 P900 T1500", "M220 S90", "G17",
                                    "SET_PRESSURE_ADVANCE ADVANCE=0.2 SMOOTH_TIME=0.02"});
  CHECK_EQ(host::SetUpLines(lines.text()).lines(), lines.lines());
  CHECK_FALSE(lines.left_out());
  for (int i = 0; i < 100; ++i) {
    lines.add(fmt::format("SET_VELOCITY_LIMIT A{}={}", i, std::string(30, '1')));
  }
  CHECK(lines.left_out());
  CHECK_LE(lines.text().size(), host::kSetUpBytesMax);
}
