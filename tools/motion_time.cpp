// Says how long the virtual controller moves for a G-code file, beside what `rind plan` says of it.
//
//     rind slice part.stl -o part.gcode --printer none --set ...
//     motion_time part.gcode --preset ender3
//
// It plays the file in simulated time. Heating, homing and pauses are left out.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <string>

#include "host/printing/virtual_machine.h"
#include "host/settings/whole_settings.h"
#include "tools/faults/controller_time.h"

int main(int argc, char** argv) {
  CLI::App app("Plays G-code to the virtual controller in simulated time.");
  std::string path, preset;
  app.add_option("file", path, "G-code")->required();
  app.add_option("--preset", preset, "the machine: a printer of `rind presets`");
  CLI11_PARSE(app, argc, argv);

  host::SettingsRequest request;
  request.printer.preset = preset;
  if (preset.empty()) request.printer.printer = "none";
  const auto whole = host::whole_settings(request);
  if (!whole.ok()) {
    fmt::print(stderr, "{}\n", whole.error().message);
    return 3;
  }
  std::ifstream file(path);
  if (!file) {
    fmt::print(stderr, "{} can't be read\n", path);
    return 3;
  }
  firmware_link::VirtualControllerOptions machine = host::virtual_machine(whole.value().settings);
  firmware_link::ControllerTime time(machine);
  std::string line;
  while (std::getline(file, line)) time.execute(line);
  fmt::print("{:.1f} s of motion, {} commands, {:.1f} mm of filament\n", time.seconds(),
             time.totals().commands, time.totals().filament_mm());
}
