// The virtual controller's narrow places: planner, heaters, wire, receive ring.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/wire/limits.h"
#include "tests/firmware_link/controller_bench.h"

using namespace link_test;
using namespace std::chrono_literals;

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
  CHECK(bench.controller.totals().planner_underruns == 0);
  (void)bench.say("G1 X20\n");
  CHECK(bench.controller.totals().planner_underruns == 1);
  (void)bench.say("M400\n");
  (void)bench.pass(1s);
  (void)bench.say("G1 X30\n");
  CHECK(bench.controller.totals().planner_underruns == 1);
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

TEST_CASE("an arc is as long as it is round, ends where it should, and fills the planner") {
  Bench bench;
  CHECK(bench.say("G1 X100 Y50 F60000\n") == "ok\n");
  CHECK(bench.say("M400\n").empty());
  (void)bench.pass(10s);
  // Half a turn of radius 5, 15.7 mm: sixteen blocks, and fifteen fit.
  CHECK(bench.say("G3 X100 Y60 J5 F600\n").empty());
  CHECK(bench.controller.state().planner_blocks == 15);
  CHECK(bench.pass(200ms) == "ok\n");
  CHECK(bench.say("M114\n").substr(0, 16) == "X:100.00 Y:60.00");
  (void)bench.pass(10s);
  CHECK_FALSE(bench.controller.moving());
  const double straight = std::hypot(100, 50);
  CHECK(bench.controller.totals().distance_mm == doctest::Approx(straight + 5 * 3.14159265));
  CHECK(bench.controller.totals().planner_underruns == 0);
  CHECK(bench.say("G3 X100 Y60\n") == "Error:G2/G3 bad parameters\nok\n");
}

TEST_CASE("an arc that bulges off the bed is counted as a move off it") {
  Bench bench;
  CHECK(bench.say("G28\n").empty());
  (void)bench.pass(60s);
  (void)bench.say("G1 X3 Y50 F60000\n");
  (void)bench.say("G3 X3 Y54 J2\n");
  CHECK(bench.controller.totals().clamped_moves == 0);
  (void)bench.say("G3 X3 Y46 J-4\n");
  CHECK(bench.controller.totals().clamped_moves == 1);
}
