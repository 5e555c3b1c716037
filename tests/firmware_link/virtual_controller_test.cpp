// Every answer in the table of firmware_link/README.md, byte for byte.
#include "firmware_link/virtual_controller.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "firmware_link/limits.h"
#include "firmware_link/line_codec.h"

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

struct Bench {
  Instant now{};
  std::vector<std::string> executed;
  VirtualController controller;

  explicit Bench(VirtualControllerOptions options = {})
      : controller(with_sink(options), Instant{}) {
    banner = hear();
  }

  VirtualControllerOptions with_sink(VirtualControllerOptions options) {
    options.executed = [this](const ExecutedCommand& command) {
      executed.emplace_back(command.text);
    };
    return options;
  }

  std::string hear() {
    controller.advance(now);
    std::string text;
    std::array<std::byte, 100> buffer;
    while (const std::size_t count = controller.output(buffer)) {
      for (std::size_t i = 0; i < count; ++i) text.push_back(static_cast<char>(buffer[i]));
    }
    return text;
  }

  void send(const std::string& text) {
    CHECK(controller.input(std::as_bytes(std::span(text.data(), text.size())), now) == text.size());
  }

  std::string say(const std::string& text) {
    send(text);
    return hear();
  }

  std::string pass(Duration duration) {
    now += duration;
    return hear();
  }

  std::string numbered(int number, const std::string& text) {
    LineBuffer buffer;
    return std::string(number_line(number, text, buffer)) + "\n";
  }

  std::string banner;
};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace

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

TEST_CASE("a move is acknowledged when it is planned, M114 tells its end, M400 waits for it") {
  Bench bench;
  CHECK(bench.say("G1 X100 F600\n") == "ok\n");
  CHECK(bench.say("M114\n") == "X:100.00 Y:0.00 Z:0.00 E:0.00 Count X:8000 Y:0 Z:0\nok\n");
  CHECK(bench.controller.moving());
  CHECK(bench.say("M400\n").empty());
  const std::string told = bench.pass(11s);
  CHECK(count_of(told, "echo:busy: processing\n") == 5);
  CHECK(told.substr(told.size() - 4) == "\nok\n");
  CHECK_FALSE(bench.controller.moving());
  CHECK(bench.controller.totals().distance_mm == doctest::Approx(100));
}

TEST_CASE("the sixteenth move in the planner holds its ok back") {
  Bench bench;
  std::string told;
  for (int i = 1; i <= 15; ++i) {
    told += bench.say("G1 X" + std::to_string(i % 2 * 100) + " F6000\n");
  }
  CHECK(told.size() == 15 * 3);
  CHECK(bench.say("G1 X0.5\n").empty());
  CHECK(bench.pass(800ms).empty());
  CHECK(bench.pass(300ms) == "ok\n");
  CHECK(bench.controller.totals().planner_blocks_max == 15);
}

TEST_CASE("heating: a report each second with a leading blank, ten seconds of rest, then ok") {
  Bench bench;
  const std::string first = bench.say("M109 S40\n");
  CHECK(first == " T:25.45 /40.00 B:25.45 /0.00 @:127 B@:0 W:?\n");
  CHECK(bench.pass(1s) == " T:29.60 /40.00 B:25.45 /0.00 @:127 B@:0 W:?\n");
  const std::string told = bench.pass(30s);
  for (int rest = 9; rest >= 0; --rest) {
    CHECK(count_of(told, " W:" + std::to_string(rest) + "\n") == 1);
  }
  CHECK(told.find("echo:busy: processing\n") != std::string::npos);
  CHECK(told.substr(told.size() - 3) == "ok\n");
  // What must cool down isn't waited for.
  CHECK(bench.say("M109 S30\n").find("ok\n") != std::string::npos);
  CHECK(bench.say("M140 S60\n") == "ok\n");
  CHECK(bench.controller.state().bed_target_celsius == 60);
  CHECK(bench.say("M155 S1\n") == "ok\n");
  const std::string report = bench.pass(1s);
  CHECK(report.substr(0, 3) == " T:");
  CHECK(count_of(report, "\n") == 1);
  CHECK(bench.say("M155 S0\n") == "ok\n");
  CHECK(bench.pass(5s).empty());
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

TEST_CASE("more than the ring holds is lost without a word") {
  Bench bench;
  std::string text = "G4 S1\n";
  for (int i = 0; i < 40; ++i) text += "M118 u" + std::to_string(i) + "\n";
  bench.send(text);
  CHECK(bench.controller.totals().receive_bytes_lost > 0);
  CHECK(bench.controller.totals().receive_bytes_max == kControllerReceiveBytes);
  const std::string told = bench.pass(5s);
  CHECK(told.find("u39\r\n") == std::string::npos);
}

TEST_CASE("end stops clamp once homed; positions, filament and modes add up") {
  VirtualControllerOptions options;
  options.extrude_celsius_min = 0;
  Bench bench(options);
  CHECK(bench.say("G1 X-5 F30000\n") == "ok\n");
  CHECK(bench.controller.state().x_mm == -5);
  bench.send("G28\n");
  (void)bench.pass(60s);
  (void)bench.say("G1 X250 Y-3\n");
  CHECK(bench.controller.state().x_mm == 200);
  CHECK(bench.controller.state().y_mm == 0);
  CHECK(bench.controller.totals().clamped_moves == 1);
  (void)bench.say("M83\n");
  (void)bench.say("G1 X100 Z7 E1.5\n");
  (void)bench.say("G1 X90 E0.25\n");
  (void)bench.say("G91\nG1 X-10 E-1\nG90\nG92 E0\nG1 E2\nM106 S300\n");
  CHECK(bench.controller.state().x_mm == 80);
  CHECK(bench.controller.totals().filament_10nm == 275'000);
  CHECK(bench.controller.totals().z_mm_max == 7);
  CHECK(bench.controller.state().fan == 255);
}

TEST_CASE("the planner counts when it runs dry, unless a pause was asked for") {
  Bench bench;
  (void)bench.say("G1 X10 F6000\n");
  (void)bench.pass(1s);
  CHECK(bench.controller.totals().planner_starvations == 0);
  (void)bench.say("G1 X20\n");
  CHECK(bench.controller.totals().planner_starvations == 1);
  (void)bench.say("M400\n");
  (void)bench.pass(1s);
  (void)bench.say("G1 X30\n");
  CHECK(bench.controller.totals().planner_starvations == 1);
  CHECK(bench.controller.totals().planner_low > 0us);
}

TEST_CASE("short segments in a straight line run through, a corner is taken from rest") {
  const auto time_of = [](const std::vector<std::string>& lines) {
    Bench bench;
    for (const std::string& line : lines) (void)bench.say(line + "\n");
    Duration time{0};
    for (; bench.controller.moving(); time += 1ms) (void)bench.pass(1ms);
    return std::chrono::duration<double>(time).count();
  };
  // 100 mm at 100 mm/s with 3000 mm/s²: 1 s and twice half of 33 ms for the ramps.
  CHECK(time_of({"G1 X100 F6000"}) == doctest::Approx(1.033).epsilon(0.005));
  std::vector<std::string> straight;
  for (int i = 1; i <= 10; ++i) straight.push_back("G1 X" + std::to_string(10 * i) + " F6000");
  CHECK(time_of(straight) == doctest::Approx(1.033).epsilon(0.005));
  CHECK(time_of({"G1 X50 F6000", "G1 Y50"}) == doctest::Approx(1.067).epsilon(0.005));
}

TEST_CASE("a wire with a baud takes its time, and a full one takes no more") {
  VirtualControllerOptions options;
  options.baud = 9600;
  Bench bench(options);
  bench.send("M107\n");
  CHECK(bench.pass(5ms).empty());
  CHECK(bench.pass(1ms) == "ok\n");
  const std::string much(10'000, ';');
  const std::size_t taken =
      bench.controller.input(std::as_bytes(std::span(much.data(), much.size())), bench.now);
  CHECK(taken == 4096);
}

TEST_CASE("answers that nobody reads make it stand still, nothing grows") {
  Bench bench;
  for (int i = 0; i < 200; ++i) bench.send("M115\n");
  const std::string told = bench.hear();
  CHECK(told.size() <= 8192);
  CHECK(bench.hear().find("FIRMWARE_NAME") != std::string::npos);
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
