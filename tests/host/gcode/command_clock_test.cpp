// Three clocks beside one another, in simulated time: that of a plan, that of a ready file, and the
// virtual controller, which plans by an arithmetic of its own.
#include "host/gcode/command_clock.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "host/gcode/ready_file.h"
#include "host/gcode/ready_scan.h"
#include "host/presets/presets.h"
#include "host/printing/virtual_machine.h"
#include "host/settings/whole_settings.h"
#include "tests/host/print_rig.h"
#include "tools/faults/controller_time.h"

namespace {

// What the estimate may be off by.
constexpr double kShareMax = 0.05;

host::PrintSettings settings_of(const std::string& preset) {
  host::SettingsRequest request;
  request.printer.preset = preset;
  const auto whole = host::whole_settings(request);
  if (!whole.ok()) FAIL(whole.error().message);
  return whole.value().settings;
}

double controller_seconds(const std::vector<std::string>& lines, const core::Settings& settings) {
  firmware_link::ControllerTime time(host::virtual_machine(settings));
  for (const std::string& line : lines) time.execute(line);
  return time.seconds();
}

double scanned_seconds(const std::vector<std::string>& lines, const core::Settings& settings) {
  const test::PartFolder folder;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const std::string path = folder.add_text("ready.gcode", text);
  const host::PrintPlan plan = print_test::open(settings, path);
  return plan.ready->summary().clock_s;
}

double clock_seconds(const std::vector<std::string>& lines, const core::Settings& settings) {
  host::CommandClock clock(settings);
  for (const std::string& line : lines) {
    const auto made = firmware_link::verbatim_from(line);
    REQUIRE(std::holds_alternative<firmware_link::Verbatim>(made));
    clock.add(std::get<firmware_link::Verbatim>(made));
  }
  return clock.seconds();
}

struct Sliced {
  std::vector<std::string> lines;
  double planned_s = 0;
};

Sliced sliced(const core::Settings& settings, const std::string& part) {
  host::GeometryStatistics statistics;
  Sliced result;
  result.lines = print_test::sliced_lines(settings, part, statistics);
  result.planned_s = statistics.time_s;
  return result;
}

// Short and long moves, corners of all kinds, and what changes how they are made.
std::vector<std::string> random_lines(unsigned seed, const std::vector<std::string>& changes) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(20, 80), turn(-0.4, 0.4);
  std::uniform_int_distribution<int> kind(0, 9), feed(600, 12'000);
  std::uniform_int_distribution<std::size_t> change(0, changes.size() - 1);
  std::vector<std::string> lines = {"G28", "G90", "M83", "G1 X50 Y50 Z5 F3000"};
  double heading = 0;
  for (int i = 0; i < 300; ++i) {
    const int what = kind(random);
    if (what == 0) lines.push_back(changes[change(random)]);
    if (what == 1) lines.push_back(fmt::format("G0 X{:.3f} Y{:.3f}", place(random), place(random)));
    if (what == 2) lines.emplace_back("G1 E-0.8 F2100");
    if (what == 3) lines.push_back(fmt::format("G1 Z{:.2f} F600", 5 + place(random) / 100));
    if (what == 4) lines.emplace_back("M400");
    lines.push_back(fmt::format("G1 F{}", feed(random)));
    lines.emplace_back("G91");
    lines.emplace_back("M83");
    for (int k = 0; k < 6 && what > 4; ++k) {
      heading += turn(random);
      lines.push_back(
          fmt::format("G1 X{:.3f} Y{:.3f} E0.05", std::cos(heading), std::sin(heading)));
    }
    lines.emplace_back("G90");
    lines.emplace_back("M83");
    lines.push_back(fmt::format("G1 X{:.3f} Y{:.3f} E0.2", place(random), place(random)));
  }
  return lines;
}

}  // namespace

TEST_CASE("plan, ready file and virtual controller tell the same time, for each printer's preset") {
  const test::PartFolder folder;
  const std::string files[] = {folder.add("box.stl", parts::box({0, 0, 0}, 12, 9, 1.2)),
                               folder.add("dome.stl", parts::dome(4))};
  int printers = 0;
  for (const host::PresetText& one : host::preset_texts()) {
    if (one.kind != host::PresetKind::kPrinter) continue;
    ++printers;
    const std::string preset(one.name);
    CAPTURE(preset);
    core::Settings settings = static_cast<const core::Settings&>(settings_of(preset));
    settings.wall_thickness = core::Length::from_mm(0.8);
    // Klipper draws none unless it is told to.
    if (settings.gcode_flavor == core::GcodeFlavor::kKlipper) settings.arc_fit_tolerance = {};
    for (const std::string& part : files) {
      CAPTURE(part);
      const Sliced made = sliced(settings, part);
      const double controller_s = controller_seconds(made.lines, settings);
      CHECK(made.planned_s == doctest::Approx(controller_s).epsilon(kShareMax));
      CHECK(scanned_seconds(made.lines, settings) ==
            doctest::Approx(controller_s).epsilon(kShareMax));
    }
  }
  CHECK(printers >= 18);
}

TEST_CASE("each printer's preset has limits: its machine's, or assumed ones, which plan names") {
  for (const host::PresetText& one : host::preset_texts()) {
    if (one.kind != host::PresetKind::kPrinter) continue;
    const std::string preset(one.name);
    CAPTURE(preset);
    const host::PrintSettings settings = settings_of(preset);
    const bool klipper = settings.gcode_flavor == core::GcodeFlavor::kKlipper;
    if (klipper) CHECK(settings.square_corner_speed_mm_s > 0);
    if (!klipper) {
      CHECK(settings.speed_max_xy_mm_s > 0);
      CHECK(settings.speed_max_z_mm_s > 0);
      CHECK(settings.acceleration_max_xy_mm_s2 > 0);
      // Only Marlin's defaults have a junction deviation.
      CHECK((settings.jerk_xy_mm_s > 0) == (preset != "marlin"));
    }
    const bool assumed = preset == "marlin" || preset == "duet";
    CHECK(settings.limits_assumed.empty() != assumed);
  }
}

TEST_CASE("what lines change about moving counts from the next move on") {
  const core::Settings marlin;
  core::Settings reprap, klipper;
  reprap.gcode_flavor = core::GcodeFlavor::kRepRapFirmware;
  klipper.gcode_flavor = core::GcodeFlavor::kKlipper;
  struct Case {
    core::Settings settings;
    std::vector<std::string> changes;
  };
  const Case cases[] = {
      {marlin,
       {"M204 S300", "M204 P2000 T500", "M204 P500", "M204 R800", "M201 X400 Y900 Z60 E500",
        "M203 X60 Y200 Z4 E20", "M205 J0.05", "M205 X12 Y5 Z0.3 E3", "M220 S30", "M220 S60"}},
      {reprap,
       {"M204 P900 T2000", "M201 X700 Y700", "M203 X4000 Y9000", "M566 X600 Y300 Z20 E90",
        "M220 S40"}},
      {klipper,
       {"M204 S700", "M204 P900 T350", "M204 P20", "SET_VELOCITY_LIMIT ACCEL=400",
        "SET_VELOCITY_LIMIT VELOCITY=50 ACCEL=2500", "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=12",
        "M220 S70"}}};
  for (const Case& one : cases) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      CAPTURE(seed);
      CAPTURE(one.changes.front());
      const std::vector<std::string> lines = random_lines(seed, one.changes);
      const double controller_s = controller_seconds(lines, one.settings);
      const double told_s = clock_seconds(lines, one.settings);
      CHECK(told_s == doctest::Approx(controller_s).epsilon(kShareMax));
      // Without them it would be another time.
      std::vector<std::string> unchanged = lines;
      std::erase_if(unchanged, [&one](const std::string& line) {
        return std::find(one.changes.begin(), one.changes.end(), line) != one.changes.end();
      });
      CHECK(std::abs(clock_seconds(unchanged, one.settings) - controller_s) > 0.1 * controller_s);
    }
  }
}

TEST_CASE("arcs, inches, pauses and places that were lost") {
  core::Settings settings;
  const std::vector<std::string> lines = {"G28",
                                          "G90",
                                          "M83",
                                          "G1 X50 Y50 Z5 F3000",
                                          "G2 X60 Y60 I10 J0 E1",
                                          "G3 X60 Y60 I-10 J0 E3",
                                          "G20",
                                          "G1 X3 Y1 F100",
                                          "G21",
                                          "G92 X0 Y0",
                                          "G1 X10 Y10 F3000",
                                          "G28 X Y",
                                          "G1 X5 Y5"};
  CHECK(clock_seconds(lines, settings) ==
        doctest::Approx(
            controller_seconds({"G28", "G90", "M83", "G1 X50 Y50 Z5 F3000", "G2 X60 Y60 I10 J0 E1",
                                "G3 X60 Y60 I-10 J0 E3", "G1 X76.2 Y25.4 F2540", "G92 X0 Y0",
                                "G1 X10 Y10 F3000", "G28 X Y", "G1 X5 Y5"},
                               settings))
            .epsilon(kShareMax));
  CHECK(clock_seconds({"G4 S2", "G4 P500"}, settings) == doctest::Approx(2.5));
}
