// Printers' files: what they may hold, what is refused, where they are looked for, and what counts
// of a preset, a file and the command line.
#include "host/presets/printer_file.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "host/settings/whole_settings.h"
#include "tests/support/temporary_folder.h"

namespace {

constexpr const char* kText =
    "# mine\n"
    "[printer]\n"
    "preset = ender3\n"
    "filament = petg  \n"
    "quality = 0.3\n"
    "port = /dev/ttyUSB0\n"
    "baud = 250000\n"
    "\n"
    "[rind]\n"
    "bed_x = 230\n";

std::string refusal(const std::string& text) {
  const auto read = host::read_printer(text, "p.ini");
  return read.ok() ? "" : read.error().message;
}

// $XDG_CONFIG_HOME for as long as it lives.
struct Configuration {
  test::TemporaryFolder folder;

  Configuration() {
    setenv("XDG_CONFIG_HOME", std::filesystem::absolute(folder.path("")).c_str(), 1);
  }
  ~Configuration() { setenv("XDG_CONFIG_HOME", "/nonexistent", 1); }  // as tests/main.cpp

  void add(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(host::printer_folder());
    std::ofstream(host::printer_path(name)) << text;
  }
};

host::PrintSettings settings_of(const host::SettingsRequest& request) {
  const auto whole = host::whole_settings(request);
  if (!whole.ok()) FAIL(whole.error().message);
  return whole.value().settings;
}

}  // namespace

TEST_CASE("a printer's file is read, and written so that it is read again") {
  const auto read = host::read_printer(kText, "p.ini");
  REQUIRE(read.ok());
  const host::PrinterFile& printer = read.value();
  CHECK_EQ(printer.preset, "ender3");
  CHECK_EQ(printer.filament, "petg");
  CHECK_EQ(printer.port, "/dev/ttyUSB0");
  CHECK_EQ(printer.baud, 250'000);
  const auto again = host::read_printer(host::written_printer(printer), "q.ini");
  REQUIRE(again.ok());
  CHECK_EQ(again.value().quality, "0.3");
  CHECK_EQ(again.value().baud, 250'000);
  host::SettingsRequest request;
  request.printer.given = again.value();
  CHECK_EQ(settings_of(request).bed_x.mm(), 230);
  CHECK_EQ(settings_of(request).bed_y.mm(), 220);
}

TEST_CASE("what is wrong in a printer's file is told with its line") {
  CHECK_EQ(refusal("[printer]\npreset = ender3\nprot = x\n").find("p.ini:3: \"prot\" is not known"),
           0);
  CHECK_EQ(refusal("[printer]\npreset ender3\n").find("p.ini:2: neither"), 0);
  CHECK_EQ(refusal("[printer]\nport = a\nport = b\n"), "p.ini:3: \"port\" is there twice");
  CHECK_EQ(refusal("[printer]\nbaud = fast\n").find("p.ini: baud = fast"), 0);
  CHECK_NE(refusal(std::string("[printer]\nport = \0", 18)), "");
  host::SettingsRequest request;
  request.printer.given = host::read_printer("[printer]\n\n[rind]\nbed_z = 3\n", "p.ini").value();
  CHECK_EQ(host::whole_settings(request).error().message.find("p.ini:4: "), 0);
  request.printer.given = host::read_printer("[printer]\npreset = ender4\n", "p.ini").value();
  CHECK_EQ(host::whole_settings(request).error().message.find(
               "p.ini: there is no printer preset \"ender4\"; there are cr10, "),
           0);
}

TEST_CASE("printer.ini is used if none is named; --printer none and presets do without") {
  const Configuration configuration;
  host::SettingsRequest request;
  CHECK_EQ(settings_of(request).bed_x.mm(), 300);
  CHECK_FALSE(host::whole_settings(request).value().bed_known);
  configuration.add("printer", kText);
  configuration.add("big", "[printer]\npreset = cr10\n");
  CHECK_EQ(settings_of(request).bed_x.mm(), 230);
  CHECK(host::whole_settings(request).value().bed_known);
  CHECK_EQ(settings_of(request).nozzle_celsius, 240);
  CHECK_EQ(settings_of(request).layer_height.mm(), 0.3);
  // What is typed counts more.
  request.printer.filament = "PLA";
  request.printer.quality = "0.1mm";
  request.assignments = {{"bed_x", "231"}};
  CHECK_EQ(settings_of(request).nozzle_celsius, 210);
  CHECK_EQ(settings_of(request).layer_height.mm(), 0.1);
  CHECK_EQ(settings_of(request).bed_x.mm(), 231);
  request = {};
  request.printer.printer = "big";
  CHECK_EQ(settings_of(request).bed_x.mm(), 300);
  CHECK_EQ(settings_of(request).axis_z.mm(), 400);
  request.printer.printer = "none";
  CHECK_EQ(settings_of(request).axis_z.mm(), 0);
  request.printer.preset = "mini";
  CHECK_EQ(settings_of(request).bed_x.mm(), 180);
  request.printer.printer = "big";
  CHECK_FALSE(host::whole_settings(request).ok());
  request = {};
  request.printer.printer = "small";
  const std::string missing = host::whole_settings(request).error().message;
  CHECK_NE(missing.find("there are big, printer"), std::string::npos);
  CHECK_EQ(missing.find("--preset"), std::string::npos);
  request.printer.printer = "mk3s";
  const std::string preset = host::whole_settings(request).error().message;
  CHECK_NE(preset.find("a preset has this name: --preset mk3s"), std::string::npos);
  request.printer.printer = "../big";
  CHECK_NE(host::whole_settings(request).error().message.find("is no printer's name"),
           std::string::npos);
}
