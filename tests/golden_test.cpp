// Whole prints as they were, line by line: a few layers of three parts. An unintended change of
// what is printed shows here as a difference that a person can read.
//
// A change that is meant: RIND_RENEW_GOLDEN=1 build/release/tests/golden_test writes the files
// again. Look at `git diff tests/golden` before you commit it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "core/settings.h"
#include "host/output/gcode_writer.h"
#include "host/part/part_file.h"
#include "host/pipeline/pipeline.h"
#include "tests/support/part_folder.h"
#include "tools/parts/part_maker.h"

using core::Length;
using core::Settings;

namespace {

struct Golden {
  std::string name;
  parts::Part part;
  Settings settings;
};

// Small: every file is a few hundred lines.
Settings small_print() {
  Settings settings;
  settings.wall_thickness = Length::from_mm(0.4);
  settings.bed_x = settings.bed_y = Length::from_mm(40);
  settings.skirt_distance = Length::from_mm(2);
  settings.arcs = core::ArcUse::kOn;
  return settings;
}

std::vector<Golden> goldens() {
  Settings dome = small_print();
  dome.layer_height = Length::from_mm(0.3);
  Settings tube = small_print();
  tube.perimeters = 1;
  tube.arcs = core::ArcUse::kOff;
  return {
      // Solid bottom and top, a loose layer between them, gap fill.
      {"box", parts::box({0, 0, 0}, 8, 6, 1), small_print()},
      // Slopes, and arcs.
      {"dome", parts::dome(2.5, 48, 12), dome},
      // A hole, and walls that two perimeters share; no arcs.
      {"tube", parts::tube(3, 2.2, 0.8, 16), tube},
  };
}

std::string printed(const Golden& golden) {
  const test::PartFolder folder;
  const std::string path = folder.add(golden.name + ".stl", golden.part);
  core::Result<host::OpenedPart> part = host::open_whole_part(path, golden.settings);
  if (!part.ok()) FAIL(part.error().message);
  host::PrintPlan print_plan{golden.settings, std::move(part).value(), golden.name};
  std::string text;
  host::GcodeWriter writer;
  host::PipelineOutputs outputs;
  outputs.on_motion = [&](const core::Motion& motion,
                          const std::optional<firmware_link::Command>& command) {
    writer.write(motion, command, text);
    return true;
  };
  host::PipelineSignals signals;
  host::GeometryStatistics statistics;
  REQUIRE(host::run_pipeline(print_plan, outputs, signals, statistics).ok());
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

void compare(const std::vector<std::string>& was, const std::vector<std::string>& is) {
  const auto [old_line, new_line] = std::mismatch(was.begin(), was.end(), is.begin(), is.end());
  if (old_line == was.end() && new_line == is.end()) return;
  const auto number = old_line - was.begin() + 1;
  const std::string before = old_line == was.end() ? "nothing" : *old_line;
  const std::string now = new_line == is.end() ? "nothing" : *new_line;
  FAIL_CHECK("line " << number << " was \"" << before << "\", is \"" << now
                     << "\". If that is meant: RIND_RENEW_GOLDEN=1, and look at git diff.");
}

}  // namespace

TEST_CASE("prints are what they were") {
  for (const Golden& golden : goldens()) {
    CAPTURE(golden.name);
    const std::string path =
        std::string(RIND_SOURCE_DIR) + "/tests/golden/" + golden.name + ".gcode";
    const std::string text = printed(golden);
    CHECK_GT(std::count(text.begin(), text.end(), '\n'), 100);
    if (std::getenv("RIND_RENEW_GOLDEN") != nullptr) {
      std::filesystem::create_directories(std::filesystem::path(path).parent_path());
      std::ofstream(path, std::ios::binary) << text;
      continue;
    }
    std::ifstream file(path, std::ios::binary);
    REQUIRE(file.good());
    std::ostringstream was;
    was << file.rdbuf();
    compare(lines_of(was.str()), lines_of(text));
    CHECK(was.str() == text);
  }
}
