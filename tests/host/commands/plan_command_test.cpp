// What `rind plan` tells before anything is printed.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"

using test::content;
using test::PartFolder;
using test::ProgramRun;
using test::rind;
using test::says;

namespace {

const std::string kCoarse = " --layer-height 0.4 --wall-thickness 0.8";

}  // namespace

TEST_CASE("plan says whether a part stands, and whether this computer keeps up") {
  const PartFolder folder;
  const std::string stats = folder.file("stats.json");
  const std::string pillar = folder.add("pillar.stl", parts::box({1, 1, 0}, 4, 4, 60));
  const std::string told = "it stands 60 mm high on a foot 4.0 mm broad at (150.0, 150.0) mm";
  const ProgramRun plan = rind("plan " + pillar + kCoarse + " --stats " + stats);
  CAPTURE(plan.output);
  CHECK_EQ(plan.exit_code, 0);
  CHECK(says(plan, told));
  CHECK(says(plan, "it may come loose; set brim_width=5"));
  CHECK(says(plan, "is at most 4.0 mm thick from 0 to 60 mm of height: it may bend"));
  CHECK(says(plan, "it keeps up"));
  const auto json = nlohmann::json::parse(content(stats));
  CHECK_EQ(json["standing"]["loosest"]["brim_mm"], 5);
  CHECK_EQ(json["standing"]["slenderest"]["slenderness"], 15);
  CHECK_GT(json["pace"]["slowest"]["printing_s"], 0);
  CHECK(says(rind("plan " + pillar + kCoarse + " --json"), told));

  CHECK_FALSE(says(rind("plan " + pillar + kCoarse + " --set brim_width=5"), "come loose"));
  CHECK_FALSE(says(rind("plan " + pillar + kCoarse + " --set raft_layers=3 --set raft_expansion=6"),
                   "come loose"));
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 8, 6, 4));
  const ProgramRun low = rind("plan " + box + kCoarse);
  CHECK_FALSE(says(low, "stands"));
  CHECK(says(low, "it keeps up"));
}

TEST_CASE("plan as JSON has all that its table tells of the part") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 8, 6, 4));
  const ProgramRun run = test::run_program(test::kRind + " plan " + box + kCoarse +
                                           " --set filament_cost_kg=20 --json 2> /dev/null");
  REQUIRE_EQ(run.exit_code, 0);
  const auto json = nlohmann::json::parse(run.output);
  CHECK_EQ(json["part"]["name"], "box.stl");
  CHECK_EQ(json["part"]["facets"], 12);
  CHECK_EQ(json["part"]["x_mm"], 8);
  CHECK_EQ(json["part"]["y_mm"], 6);
  CHECK_EQ(json["part"]["z_mm"], 4);
  CHECK(json["volume_mm3"].get<double>() == doctest::Approx(192));
  double filament_mm = 0;
  for (const auto& [kind, mm] : json["filament_mm"].items()) {
    if (kind != "total") filament_mm += mm.get<double>();
  }
  const double grams = filament_mm * 3.14159265 * 1.75 * 1.75 / 4 * 1.24e-3;
  CHECK(json["filament_g"].get<double>() == doctest::Approx(grams));
  CHECK(json["price"].get<double>() == doctest::Approx(grams * 0.02));
}

TEST_CASE("ready G-code is printed as it is: what would change it is refused by name") {
  const test::PartFolder folder;
  const std::string file = folder.add_text("a.gcode", "G28\nG1 Z0.2 F600\nG1 X10 Y10 E1\n");
  for (const char* wish : {"--copies 2", "--scale 2", "--rotate 45", "--mirror x", "--cut 1"}) {
    CAPTURE(wish);
    const test::ProgramRun outcome = test::rind("plan " + file + " " + wish);
    CHECK_EQ(outcome.exit_code, 3);
    CHECK(test::says(outcome, "printed as it is"));
  }
  CHECK_EQ(test::rind("plan " + file).exit_code, 0);
}
