// A signal ends every command soon, whatever it computes or waits for, and no file is left.
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"
#include "tests/support/running_program.h"

namespace fs = std::filesystem;
using test::kRind;
using test::PartFolder;
using test::RunningProgram;

namespace {

// Far above kStopGrace_ms, for slow machines; far below the layers of holed_plate().
constexpr double kSoon_s = 5;

std::size_t files_in(const PartFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder.file("")), fs::directory_iterator{}));
}

// Hundreds of thousands of edges in each layer: one takes very long.
std::string holed_plate(const PartFolder& folder) {
  std::vector<parts::Part> all{parts::box({0, 0, 0}, 250, 250, 2)};
  constexpr int kHoles = 240;
  constexpr double kPitch = 250.0 / kHoles;
  for (int i = 0; i < kHoles * kHoles; ++i) {
    const double x = (0.25 + i % kHoles) * kPitch, y = (0.25 + i / kHoles) * kPitch;
    all.push_back(parts::edited(parts::box({x, y, 0}, kPitch / 2, kPitch / 2, 2),
                                [](const parts::Facet& facet, std::int64_t) {
                                  return std::vector<parts::Facet>{parts::flipped(facet)};
                                }));
  }
  return folder.add("plate.stl", parts::together(std::move(all)));
}

}  // namespace

TEST_CASE("whoever waits for a pipe ends with code 5, and leaves no file") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", parts::box({1, 1, 0}, 8, 6, 4));
  const std::string pipe = folder.file("pipe"), out = folder.file("out.gcode");
  REQUIRE_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::size_t files = files_in(folder);
  const std::vector<std::vector<std::string>> commands = {
      {"slice", pipe, "-o", out},
      {"slice", "-", "-o", out},
      {"slice", part, "-o", pipe, "--format", "gcode"},
      {"slice", part, "-o", out, "--profile", pipe},
      {"plan", pipe},
      {"plan", "-", "--json"},
      {"show", pipe, "--layer", "1", "-o", folder.file("a.svg")},
      {"print", pipe, "--port", "virtual"},
      {"print", "-", "--port", "virtual", "--sorted", "yes"}};
  const std::vector<int> signals = {SIGTERM, SIGINT, SIGHUP};
  for (std::size_t i = 0; i < commands.size(); ++i) {
    std::vector<std::string> words = commands[i];
    CAPTURE(words);
    words.insert(words.begin(), kRind);
    RunningProgram program(words);
    // It is waiting by then, or will see the signal before it does.
    RunningProgram::pause(0.3);
    program.tell(signals[i % signals.size()]);
    const std::optional<int> code = program.end(kSoon_s);
    CAPTURE(program.said());
    REQUIRE(code.has_value());
    CHECK_EQ(*code, 5);
    CHECK_NE(program.said().find("stopped"), std::string::npos);
    CHECK_EQ(files_in(folder), files);
  }
}

TEST_CASE("a layer that takes very long is told meanwhile, and does not keep a signal waiting") {
  const PartFolder folder;
  const std::string plate = holed_plate(folder), out = folder.file("out.gcode");
  const std::size_t files = files_in(folder);
  const std::vector<std::vector<std::string>> commands = {
      {"slice", plate, "-o", out, "--json", "--jobs", "1"},
      {"print", plate, "--port", "virtual", "--json", "--jobs", "1"}};
  for (std::vector<std::string> words : commands) {
    CAPTURE(words);
    words.insert(words.begin(), kRind);
    RunningProgram program(words);
    const bool told = program.wait_for("\"event\":\"slow_layer\"", 120);
    CAPTURE(program.said());
    REQUIRE(told);
    program.tell(SIGTERM);
    program.tell(SIGHUP);
    const std::optional<int> code = program.end(kSoon_s);
    REQUIRE(code.has_value());
    CHECK_EQ(*code, 5);
    CHECK_NE(program.said().find("\"layer\":1,"), std::string::npos);
    CHECK_NE(program.said().find("\"edges\":"), std::string::npos);
    CHECK_NE(program.said().find("\"exit_code\":5"), std::string::npos);
    // Two signals that are no Ctrl-C do not halt a printer.
    CHECK_EQ(program.said().find("M112"), std::string::npos);
    CHECK_EQ(files_in(folder), files);
  }
}

TEST_CASE("however often a terminal closes, a print ends safely") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", parts::box({1, 1, 0}, 8, 6, 100));
  for (const int signal : {SIGHUP, SIGTERM}) {
    CAPTURE(signal);
    RunningProgram program(
        {kRind, "print", part, "--port", "virtual", "--virtual-speed", "100", "--json"});
    REQUIRE(program.wait_for("\"event\":\"layer\",\"layer\":2", 60));
    for (int i = 0; i < 5; ++i) {
      program.tell(signal);
      RunningProgram::pause(0.005);
    }
    const std::optional<int> code = program.end(60);
    CAPTURE(program.said());
    REQUIRE(code.has_value());
    CHECK_EQ(*code, 5);
    CHECK_NE(program.said().find("nozzle lifted, heaters and fan off"), std::string::npos);
  }
}
