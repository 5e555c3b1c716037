// Every answer in the table of firmware_link/README.md, byte for byte.
#include "firmware_link/virtual/virtual_controller.h"

#include <doctest/doctest.h>

#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "firmware_link/wire/limits.h"
#include "tests/firmware_link/controller_bench.h"

using namespace link_test;
using namespace std::chrono_literals;

TEST_CASE("the banner: 26 lines, no ok") {
  Bench bench;
  CHECK(bench.banner.substr(0, 95) ==
        "start\nMarlin bugfix-2.1.x\necho: Last Updated: 2024-10-12 | Author: (none, default "
        "config)\necho:");
  CHECK(count_of(bench.banner, "\n") == 26);
  CHECK(bench.banner.find("echo: Free Memory: 5455  PlannerBufferBytes: 1264\n"
                          "echo:Hardcoded Default Settings Loaded\necho:; Linear Units:\n") !=
        std::string::npos);
  CHECK(bench.banner.find("ok") == std::string::npos);
}

TEST_CASE("numbers and checksums") {
  Bench bench;
  CHECK(bench.say("M110 N0\n") == "ok\n");
  CHECK(bench.say("N1 M105*38\n") == "ok T:25.45 /0.00 B:25.45 /0.00 @:0 B@:0\n");
  CHECK(bench.say("N2 M105*36\n") == "Error:checksum mismatch, Last Line: 1\nResend: 2\nok\n");
  CHECK(bench.say(bench.numbered(2, "M107")) == "ok\n");
  CHECK(bench.say(bench.numbered(5, "M107")) ==
        "Error:Line Number is not Last Line Number+1, Last Line: 2\nResend: 3\nok\n");
  // The last number and the one before it are met with silence, the one before that isn't.
  CHECK(bench.say(bench.numbered(2, "M107")).empty());
  CHECK(bench.say(bench.numbered(1, "M107")).empty());
  CHECK(bench.say(bench.numbered(0, "M107")) ==
        "Error:Line Number is not Last Line Number+1, Last Line: 2\nResend: 3\nok\n");
  CHECK(bench.say("N3 M105\n") ==
        "Error:No Checksum with line number, Last Line: 2\nResend: 3\nok\n");
  // Without a number the checksum isn't looked at, and the counter stays.
  CHECK(bench.say("M105*36\n") == "ok T:25.45 /0.00 B:25.45 /0.00 @:0 B@:0\n");
  CHECK(bench.say("M107\n") == "ok\n");
  CHECK(bench.say(bench.numbered(3, "M107")) == "ok\n");
  CHECK(bench.say("\nN99999999 M105*23\n") ==
        "Error:Line Number is not Last Line Number+1, Last Line: 3\nResend: 4\nok\n");
  CHECK(bench.controller.totals().resends_asked == 5);
}

TEST_CASE("M110 sets the number from wherever it stands") {
  Bench bench;
  CHECK(bench.say("N10 M110*18\n") == "Line: 10\nok\n");
  CHECK(bench.controller.state().last_line == 10);
  CHECK(bench.say(bench.numbered(12, "M110 N50")) == "ok\n");
  CHECK(bench.say(bench.numbered(51, "M107")) == "ok\n");
  CHECK(bench.say("N-1 M110*15\n") == "Line: -1\nok\n");
  CHECK(bench.say(bench.numbered(0, "M107")) == "ok\n");
  // In a text too: any number is then accepted.
  CHECK(bench.say("N7 M117 see M110 there*99\n") == "ok\n");
  CHECK(bench.say(bench.numbered(8, "M107")) == "ok\n");
}

TEST_CASE("long lines are cut at 95 characters without a word") {
  Bench bench;
  const std::string longest = "M117 " + std::string(90, 'x');
  CHECK(bench.say("M117 " + std::string(145, 'x') + "\n") == "ok\n");
  CHECK(bench.executed.back() == longest);
  CHECK(bench.executed.back().size() == kLineBytesMax);
  const std::string cut = bench.numbered(1, "M117");
  std::string line = "N1 M117 " + std::string(140, 'x');
  line += "*" + std::to_string(checksum_of(line)) + "\n";
  for (int i = 0; i < 3; ++i) {
    CHECK(bench.say(line) == "Error:No Checksum with line number, Last Line: 0\nResend: 1\nok\n");
  }
}

TEST_CASE("what is met with silence, and what is unknown") {
  Bench bench;
  CHECK(bench.say("\n").empty());
  CHECK(bench.say("; a comment\n").empty());
  CHECK(bench.say("   \n") == "echo:Unknown command: \"\"\nok\n");
  CHECK(bench.say("FOO\n") == "echo:Unknown command: \"FOO\"\nok\n");
  CHECK(bench.say("G999\n") == "echo:Unknown command: \"G999\"\nok\n");
  CHECK(bench.say("m105\n") == "echo:Unknown command: \"m105\"\nok\n");
  CHECK(bench.say("(note)\n") == "echo:Unknown command: \"(note)\"\nok\n");
  CHECK(bench.say("M28 test.gco\n") == "echo:Unknown command: \"M28 test.gco\"\nok\n");
  CHECK(bench.say("N1 4 G4 P0*17\n").find("Error:checksum") == 0);
  CHECK(bench.say("4 G4 P0*55\n") == "echo:Unknown command: \"4 G4 P0\"\nok\n");
  CHECK(bench.say("T1\n") == "ok\n");
  CHECK(bench.say("T9\n") == "ok\n");
  CHECK(bench.say("M107\r") == "ok\n");
  CHECK(bench.say("M107\r\n") == "ok\n");
  CHECK(count_of(bench.say("M105 M105\n"), "ok") == 1);
  CHECK(bench.controller.totals().unknown_commands == 7);
}

TEST_CASE("talk") {
  Bench bench;
  CHECK(bench.say("M118 x\n") == "x\r\nok\n");
  CHECK(bench.say("M118 E1 x\n") == "echo:x\r\nok\n");
  CHECK(bench.say("M118 A1 action:cancel\n") == "//action:cancel\r\nok\n");
  CHECK(bench.say("M113\n") == "echo:M113 S2\nok\n");
  CHECK(bench.say("M999\n") == "Resend: 1\nok\nok\n");
  CHECK(bench.say("G2 X5 Y5\n") == "Error:G2/G3 bad parameters\nok\n");
  CHECK(bench.say("G1 E5\n") == "echo: cold extrusion prevented\nok\n");
  CHECK(bench.controller.state().e_mm == 5);
  CHECK(bench.controller.totals().filament_10nm == 0);
  const std::string about = bench.say("M115\n");
  CHECK(about.find("FIRMWARE_NAME:Marlin bugfix-2.1.x (") == 0);
  CHECK(about.find(" MACHINE_TYPE:3D Printer KINEMATICS:Cartesian EXTRUDER_COUNT:1 UUID:") !=
        std::string::npos);
  CHECK(count_of(about, "\nCap:") == 36);
  CHECK(count_of(about, ":1\nCap:") == 5);
  CHECK(about.substr(about.size() - 4) == "\nok\n");
}

TEST_CASE("waiting handlers say that they are busy every two seconds") {
  Bench bench;
  CHECK(bench.say("G4 S5\n").empty());
  CHECK(bench.pass(1900ms).empty());
  CHECK(bench.pass(100ms) == "echo:busy: processing\n");
  CHECK(bench.pass(2s) == "echo:busy: processing\n");
  CHECK(bench.pass(999ms).empty());
  CHECK(bench.pass(1ms) == "ok\n");
  CHECK(bench.say("M113 S0\n") == "ok\n");
  CHECK(bench.say("G4 P3000\n").empty());
  CHECK(bench.pass(3s) == "ok\n");
}

TEST_CASE("G28 tells the position that nobody asked for") {
  Bench bench;
  CHECK(bench.say("G28\n").empty());
  const std::string told = bench.pass(30s);
  CHECK(told.find("echo:busy: processing\n") == 0);
  const std::string end = "X:0.00 Y:0.00 Z:5.00 E:0.00 Count X:0 Y:0 Z:2000\nok\n";
  REQUIRE(told.size() > end.size());
  CHECK(told.substr(told.size() - end.size()) == end);
}

TEST_CASE("M112: read when a slot is free, in its turn when numbered, at once when listened for") {
  const std::string killed = "echo:M112 Shutdown\nError:Printer halted. kill() called!\n";
  SUBCASE("unnumbered") {
    Bench bench;
    CHECK(bench.say("G4 S10\nM107\nM107\n").empty());
    CHECK(bench.say("M112\n") == killed);
    CHECK(bench.controller.state().halted);
    CHECK(bench.say("M999\n").empty());
    bench.controller.reset(bench.now);
    CHECK(bench.hear() == bench.banner);
    CHECK(bench.say("M107\n") == "ok\n");
  }
  SUBCASE("behind four lines") {
    Bench bench;
    CHECK(bench.say("G4 S10\nM107\nM107\nM107\nM112\n").empty());
    CHECK(bench.pass(9s).find("kill") == std::string::npos);
    const std::string told = bench.pass(2s);
    CHECK(told.find(killed) != std::string::npos);
  }
  SUBCASE("numbered") {
    Bench bench;
    CHECK(bench.say("G4 S10\n" + bench.numbered(1, "M112")).empty());
    const std::string told = bench.pass(10s);
    CHECK(told.substr(told.size() - killed.size() - 3) == "ok\n" + killed);
  }
  SUBCASE("emergency parser") {
    VirtualControllerOptions options;
    options.emergency_parser = true;
    Bench bench(options);
    CHECK(bench.say("G4 S10\nM107\nM107\nM107\nM107\nM112\n") == killed);
    CHECK(bench.say("M115\n").empty());
  }
}

TEST_CASE("ADVANCED_OK") {
  VirtualControllerOptions options;
  options.advanced_ok = true;
  Bench bench(options);
  CHECK(bench.say(bench.numbered(1, "M107")) == "ok N1 P15 B3\n");
  CHECK(bench.say("M107\n") == "ok P15 B3\n");
  CHECK(bench.say("M105\n").find("ok T:") == 0);
  CHECK(bench.say(bench.numbered(9, "M107")).find("Resend: 2\nok\n") != std::string::npos);
}

TEST_CASE("a refused line takes all that has arrived with it, and the tail runs unnumbered") {
  VirtualControllerOptions options;
  options.baud = 115200;
  Bench bench(options);
  // Four slots are taken, so that what follows stays in the ring until the dwell is over.
  bench.send("G4 P500\nM107\nM107\nM107\n");
  CHECK(bench.pass(100ms).empty());
  bench.send("N1 M105*0\nN2 M106 S20*90\nN3 M106 S30*90\n");
  // The dwell ends; the first of these is refused, and the others are in the ring: flushed.
  const std::string told = bench.pass(1s);
  CHECK(count_of(told, "Resend: 1\n") == 1);
  CHECK(bench.executed.size() == 4);
  // Now one that is refused while the next is half on its way.
  bench.send("N1 M105*0\nM106 S20\n");
  const std::string after = bench.pass(1s);
  CHECK(count_of(after, "Resend: 1\n") == 1);
  CHECK(count_of(after, "ok\n") == 2);
}

TEST_CASE("random bytes never break it, and time always passes") {
  const auto seed = std::random_device{}();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const std::string alphabet = "GMTN0123456789 .-*;XYZEFSP\n\n\r";
  for (int round = 0; round < 300; ++round) {
    VirtualControllerOptions options;
    options.baud = random() % 2 == 0 ? 0 : 250000;
    options.advanced_ok = random() % 2 == 0;
    options.emergency_parser = random() % 2 == 0;
    Bench bench(options);
    for (int i = 0; i < 40; ++i) {
      std::string text;
      for (std::size_t n = random() % 60; n > 0; --n) {
        text.push_back(random() % 4 == 0 ? static_cast<char>(random())
                                         : alphabet[random() % alphabet.size()]);
      }
      (void)bench.controller.input(std::as_bytes(std::span(text.data(), text.size())), bench.now);
      (void)bench.pass(Duration(static_cast<std::int64_t>(random() % 3'000'000)));
    }
  }
}
