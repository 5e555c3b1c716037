// rind test as users meet it. The G-code is read here by itself: heights, temperatures, filament.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace {

// What was laid between two heights.
struct Block {
  double bottom = 0, top = 0, value = 0;
};

struct Move {
  double z = 0;
  double mm = 0;        // over the bed
  double filament = 0;  // forward or back
  double speed = 0;     // mm/s
};

struct Print {
  std::vector<Block> told;  // the table
  std::vector<Move> moves;
  std::vector<std::pair<double, double>> celsius;  // height of the next road, M104 and M109
  std::vector<std::pair<double, double>> advance;  // likewise, by whichever command
};

// The number behind `word`, as X in "G1 X3"; `otherwise` if it is not there.
double number_of(const std::string& line, const std::string& word, double otherwise) {
  const std::size_t at = line.find(" " + word);
  return at == std::string::npos ? otherwise : std::stod(line.substr(at + 1 + word.size()));
}

Print read_print(const std::string& path, const std::string& said) {
  Print print;
  std::istringstream table(said);
  for (std::string line; std::getline(table, line);) {
    Block block;
    if (std::sscanf(line.c_str(), "%lf to %lf mm %lf", &block.bottom, &block.top, &block.value) ==
        3)
      print.told.push_back(block);
  }
  std::ifstream file(path);
  double x = 0, y = 0, z = 0, feed = 0;
  std::vector<double> celsius, advance;  // of which no road was laid so far
  for (std::string line; std::getline(file, line);) {
    line = line.substr(0, line.find(';'));
    if (line.starts_with("M104") || line.starts_with("M109")) {
      celsius.push_back(number_of(line, "S", -1));
    }
    if (line.starts_with("M900")) advance.push_back(number_of(line, "K", -1));
    if (line.starts_with("M572")) advance.push_back(number_of(line, "S", -1));
    if (line.starts_with("SET_PRESSURE")) advance.push_back(number_of(line, "ADVANCE=", -1));
    if (!line.starts_with("G1") && !line.starts_with("G0")) continue;
    const double to_x = number_of(line, "X", x), to_y = number_of(line, "Y", y);
    z = number_of(line, "Z", z);
    feed = number_of(line, "F", feed);
    const Move move{z, std::hypot(to_x - x, to_y - y), number_of(line, "E", 0), feed / 60};
    x = to_x, y = to_y;
    print.moves.push_back(move);
    if (move.filament <= 0 || move.mm == 0) continue;
    for (const double value : celsius) print.celsius.emplace_back(z, value);
    for (const double value : advance) print.advance.emplace_back(z, value);
    celsius.clear(), advance.clear();
  }
  return print;
}

Print test_print(const test::TemporaryFolder& folder, const std::string& words) {
  const std::string path = folder.path("out.gcode");
  const test::ProgramRun run = test::rind("test " + words + " -o " + path);
  CAPTURE(run.output);
  REQUIRE_EQ(run.exit_code, 0);
  CHECK_FALSE(test::says(run, "mended"));
  return read_print(path, run.output);
}

constexpr double kLayer_mm = 0.2;

}  // namespace

TEST_CASE("temperature-tower: each block has its temperature from its first road on") {
  const test::TemporaryFolder folder;
  const Print print = test_print(
      folder, "temperature-tower --preset ender3 --filament pla --from 215 --to 205 --step 5");
  REQUIRE_EQ(print.told.size(), 3);
  // Those of the start come first: 215 °C on the first layer.
  std::map<double, double> last;
  for (const auto& [z, celsius] : print.celsius) last[z] = celsius;
  std::vector<std::pair<double, double>> changes(last.begin(), last.end());
  REQUIRE_GE(changes.size(), 3);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [z, celsius] = changes[changes.size() - 2 + i];
    CHECK_EQ(celsius, print.told[1 + i].value);
    CHECK(z == doctest::Approx(print.told[1 + i].bottom + kLayer_mm));
  }
  CHECK_EQ(print.told[0].value, 215);
  CHECK(print.told.back().top == doctest::Approx(print.moves[print.moves.size() / 2].z).epsilon(1));
}

TEST_CASE("retraction: every retraction within a block is as long as told") {
  const test::TemporaryFolder folder;
  for (const std::string preset : {"ender3", "klipper"}) {
    CAPTURE(preset);
    const Print print =
        test_print(folder, "retraction --from 0.5 --to 1.1 --step 0.3 --preset " + preset);
    REQUIRE_EQ(print.told.size(), 3);
    std::vector<int> found(3);
    double layer_z = 0;
    for (const Move& move : print.moves) {
      if (move.filament > 0 && move.mm > 0) layer_z = move.z;
      if (move.filament == 0 || move.mm > 0) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Block& block = print.told[i];
        // The way from one layer to the next belongs to both.
        if (layer_z < block.bottom + 1.5 * kLayer_mm || layer_z > block.top - kLayer_mm / 2)
          continue;
        CHECK(std::abs(move.filament) == doctest::Approx(block.value).epsilon(1e-3));
        ++found[i];
      }
    }
    // Two towers: two ways in each of 25 layers, there and back.
    for (const int count : found) CHECK_GE(count, 80);
  }
}

TEST_CASE("pressure-advance: each firmware is told in its own words, before the block") {
  const test::TemporaryFolder folder;
  for (const std::string preset : {"mini", "klipper", "duet"}) {
    CAPTURE(preset);
    const Print print =
        test_print(folder, "pressure-advance --from 0.02 --to 0.06 --step 0.02 --preset " + preset);
    REQUIRE_EQ(print.told.size(), 3);
    REQUIRE_EQ(print.advance.size(), 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(print.advance[i].second == doctest::Approx(print.told[i].value));
      CHECK(print.advance[i].first == doctest::Approx(print.told[i].bottom + kLayer_mm));
    }
  }
}

TEST_CASE("max-flow: as much filament is laid in a second as the block says") {
  const test::TemporaryFolder folder;
  const Print print =
      test_print(folder, "max-flow --preset ender3 --filament pla --from 8 --to 12 --step 2");
  REQUIRE_EQ(print.told.size(), 3);
  const double filament_mm2 = std::numbers::pi * 1.75 * 1.75 / 4;
  for (const Block& block : print.told) {
    CAPTURE(block.value);
    double slowest = 1e9, fastest = 0;
    for (const Move& move : print.moves) {
      if (move.filament <= 0 || move.mm < 20) continue;
      // A turn that rises ends a layer higher than it began.
      if (move.z < block.bottom + 0.6 || move.z > block.top - 0.3) continue;
      const double flow = move.filament * filament_mm2 / move.mm * move.speed;
      slowest = std::min(slowest, flow), fastest = std::max(fastest, flow);
    }
    // Feeds are whole millimetres a minute.
    CHECK(slowest == doctest::Approx(block.value).epsilon(0.005));
    CHECK(fastest == doctest::Approx(block.value).epsilon(0.005));
  }
}

TEST_CASE("flow: the wall is one road, as thick as told") {
  const test::TemporaryFolder folder;
  const Print print = test_print(folder, "flow --preset ender3 --filament pla --quality 0.2");
  const double filament_mm2 = std::numbers::pi * 1.75 * 1.75 / 4;
  int long_roads = 0;
  for (const Move& move : print.moves) {
    if (move.filament <= 0 || move.mm < 30 || move.z < 5 || move.z > 20) continue;
    const double area = move.filament * filament_mm2 / move.mm;
    // A bead with round sides.
    const double width = area / kLayer_mm + kLayer_mm * (1 - std::numbers::pi / 4);
    CHECK(width == doctest::Approx(0.45).epsilon(0.01));
    ++long_roads;
  }
  CHECK_GE(long_roads, 4 * 70);
}

TEST_CASE("every test is printed by the controller inside the program") {
  for (const std::string words :
       {"first-layer --preset delta", "temperature-tower --from 205 --to 200 --preset klipper",
        "retraction --from 0.4 --to 0.8 --step 0.4 --preset duet", "flow --preset mini",
        "pressure-advance --from 0 --to 0.02 --step 0.02 --preset mk3s",
        "max-flow --from 5 --to 6 --step 1 --preset voron02"}) {
    CAPTURE(words);
    const test::ProgramRun run = test::rind("test " + words + " --port virtual --virtual-speed 0");
    CAPTURE(run.output);
    CHECK_EQ(run.exit_code, 0);
    CHECK(test::says(run, "printed "));
    CHECK(test::says(run, "look for"));
  }
}

TEST_CASE("what the test itself sets is not overruled silently") {
  const test::TemporaryFolder folder;
  const std::string to = " -o " + folder.path("out.gcode");
  for (const std::string words :
       {"flow --scale 2", "max-flow --layer-height 0.2", "flow --at 20,20"}) {
    CAPTURE(words);
    const test::ProgramRun run = test::rind("test " + words + to);
    CHECK_EQ(run.exit_code, 3);
    CHECK(test::says(run, "leave it out"));
  }
  CHECK_EQ(test::rind("test flow -o " + folder.path("out.svg")).exit_code, 2);
  CHECK_EQ(test::rind("test flow --quiet -o " + folder.path("out.stl")).exit_code, 0);
  CHECK_EQ(test::content(folder.path("out.stl")).size(), 84 + 12 * 50);
}

TEST_CASE("actions of the user's own at heights are kept") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("out.gcode");
  const test::ProgramRun run =
      test::rind("test retraction --preset ender3 --at '7 M117 half' --quiet -o " + path);
  CHECK_EQ(run.exit_code, 0);
  CHECK_NE(test::content(path).find("M117 half"), std::string::npos);
}

TEST_CASE("a test that was interrupted is resumed from its own file") {
  const test::TemporaryFolder folder;
  const std::string journal = folder.path("test.journal");
  const std::string port = " --port virtual --virtual-speed 0";
  const test::ProgramRun stopped = test::run_program(
      "timeout --preserve-status -s INT 1.5 " + test::kRind +
      " test retraction --preset mk3s --port virtual --virtual-speed 200 --journal " + journal);
  CAPTURE(stopped.output);
  REQUIRE_EQ(stopped.exit_code, 5);
  if (!test::says(stopped, "to resume it")) return;  // before the first road, on a slow machine
  const test::ProgramRun resumed = test::rind("resume " + journal + port + " --yes");
  CAPTURE(resumed.output);
  CHECK_EQ(resumed.exit_code, 0);
  CHECK(test::says(resumed, "printed "));
}
