// Every preset: read, named, and printed with to a controller that has its bed and its end stops.
#include "host/presets/presets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/pipeline/user_gcode.h"
#include "host/settings/whole_settings.h"
#include "host/system/exit_codes.h"
#include "tests/host/print_rig.h"
#include "tests/support/gcode_machine.h"

using host::PresetKind;
using print_test::Rig;

namespace {

core::Settings settings_with(const std::string& printer, const std::string& filament,
                             const std::string& quality) {
  host::SettingsRequest request;
  request.printer = {"none", printer, filament, quality, {}};
  if (!printer.empty()) request.printer.printer.clear();
  const auto whole = host::whole_settings(request);
  if (!whole.ok()) FAIL(whole.error().message);
  REQUIRE(host::check_user_gcode(whole.value().settings).ok());
  if (!printer.empty()) CHECK(whole.value().bed_known);
  return static_cast<const core::Settings&>(whole.value().settings);
}

std::vector<std::string> names_of(PresetKind kind) {
  std::vector<std::string> names;
  for (const host::PresetText& one : host::preset_texts()) {
    if (one.kind == kind) names.emplace_back(one.name);
  }
  return names;
}

firmware_link::VirtualControllerOptions controller_of(const core::Settings& settings) {
  firmware_link::VirtualControllerOptions machine;
  machine.height_z_mm = settings.axis_z.mm();
  if (settings.gcode_flavor == core::GcodeFlavor::kKlipper) {
    machine.dialect = firmware_link::VirtualDialect::kKlipper;
  } else if (settings.gcode_flavor == core::GcodeFlavor::kRepRapFirmware) {
    machine.dialect = firmware_link::VirtualDialect::kRepRap;
  }
  return machine;
}

bool pushes_filament(const std::string& line) {
  const std::size_t e = line.find(" E");
  return line.starts_with("G1 ") && e != std::string::npos && line[e + 2] != '-' &&
         (line.find(" X") != std::string::npos || line.find(" Y") != std::string::npos);
}

// The print, paused and resumed on its way.
void check_printed(const std::string& name, const core::Settings& settings,
                   const std::string& part) {
  CAPTURE(name);
  // Not every program that shows a file knows them.
  CHECK_NE(settings.arcs, core::ArcUse::kOn);
  Rig rig(settings, part, controller_of(settings));
  rig.options.banner_wait_s = 0.05;
  std::int64_t roads = 0;
  bool purged = false, paused = false;
  std::vector<host::UserRequest> requests;
  rig.control.request = [&]() -> std::optional<host::UserRequest> {
    if (requests.empty()) return std::nullopt;
    const host::UserRequest first = requests.front();
    requests.erase(requests.begin());
    return first;
  };
  rig.on_executed = [&] {
    if (!rig.executed.empty() && pushes_filament(rig.executed.back())) ++roads;
    // No road of the part is laid before the fan is set for it.
    if (!rig.executed.empty() && rig.executed.back().starts_with("M107") && roads > 0 && !paused) {
      purged = true;
    }
    if (roads == 40 && !paused) {
      paused = true;
      requests = {host::UserRequest::kPause, host::UserRequest::kResume};
    }
  };
  const host::PrintOutcome outcome = rig.print();
  CAPTURE(outcome.message);
  CHECK_EQ(outcome.exit_code, host::kExitDone);
  CHECK(purged);
  CHECK(paused);
  const auto& totals = rig.port->controller().totals();
  CHECK_EQ(totals.clamped_moves, 0);
  CHECK_EQ(totals.unknown_commands, 0);
  CHECK_EQ(totals.cold_extrusions, 0);
}

}  // namespace

TEST_CASE("each preset has a title, and every combination fits together") {
  const auto printers = names_of(PresetKind::kPrinter);
  const auto filaments = names_of(PresetKind::kFilament);
  const auto qualities = names_of(PresetKind::kQuality);
  for (const host::PresetText& one : host::preset_texts()) {
    const auto preset = host::find_preset(one.kind, one.name);
    if (!preset.ok()) FAIL(preset.error().message);
    CAPTURE(one.name);
    CHECK_FALSE(preset.value().title.empty());
    const bool any_size = preset.value().title.starts_with("any printer");
    CHECK_EQ(preset.value().measured, !any_size);
  }
  for (const std::string& printer : printers) {
    for (const std::string& filament : filaments) {
      for (const std::string& quality : qualities) {
        (void)settings_with(printer, filament, quality);
      }
    }
  }
  CHECK_GE(printers.size(), 15);
  CHECK_EQ(std::set<std::string>(filaments.begin(), filaments.end()).count("petg"), 1);
}

TEST_CASE("each printer's purge lays filament on both of its lines, whatever a macro left behind") {
  for (const std::string& name : names_of(PresetKind::kPrinter)) {
    CAPTURE(name);
    const std::vector<std::string> start = settings_with(name, "pla", "0.2").start_gcode;
    for (const bool absolute : {true, false}) {
      test::GcodeMachine machine;
      machine.run(absolute ? "M82" : "M83");
      int lines = 0;
      for (const std::string& command : start) {
        const double before = machine.filament_mm;
        machine.run(command);
        if (pushes_filament(command)) {
          ++lines;
          CHECK_GT(machine.filament_mm - before, 3);
          CHECK_LT(machine.filament_mm - before, 12);
        }
      }
      CHECK_EQ(lines, 2);
    }
  }
}

TEST_CASE("each printer's preset: a part is printed within its bed, after a purge") {
  const test::PartFolder folder;
  const std::string part = folder.add("box.stl", parts::box({0, 0, 0}, 8, 8, 1));
  for (const std::string& name : names_of(PresetKind::kPrinter)) {
    check_printed(name, settings_with(name, "pla", "0.2"), part);
  }
}
