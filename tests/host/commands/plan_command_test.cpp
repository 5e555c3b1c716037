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

TEST_CASE(
    "plan says whether the spool is enough, by length and by weight, for all parts together") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 8, 6, 4));
  const auto planned = [&](const std::string& more) {
    const ProgramRun run =
        test::run_program(test::kRind + " plan " + more + kCoarse + " --json 2> /dev/null");
    REQUIRE_EQ(run.exit_code, 0);
    return nlohmann::json::parse(run.output);
  };
  const auto alone = planned(box);
  CHECK_FALSE(alone.contains("spool_enough"));
  const double needed_mm = alone["needed_mm"], grams = alone["filament_g"];
  // No start G-code: that is what the roads take.
  const double roads_mm = alone["filament_mm"]["total"];
  CHECK(needed_mm == doctest::Approx(roads_mm).epsilon(0.001));

  const auto left = [&](double share, const std::string& more) {
    return planned(more + " --spool-left " + std::to_string(share * needed_mm) + "mm");
  };
  CHECK_EQ(left(1.02, box)["spool_enough"], true);
  CHECK_EQ(left(0.98, box)["spool_enough"], false);
  CHECK_EQ(left(2.9, box + " --copies 3")["spool_enough"], false);
  CHECK_EQ(left(3.1, box + " --copies 3")["spool_enough"], true);
  CHECK_EQ(left(1.9, box + " " + box)["spool_enough"], false);
  CHECK_EQ(left(2.1, box + " " + box)["spool_enough"], true);
  CHECK_EQ(planned(box + " --spool-left '" + std::to_string(1.02 * grams) + " g'")["spool_enough"],
           true);
  CHECK_EQ(planned(box + " --spool-left " + std::to_string(0.98e-3 * grams) + "kg")["spool_enough"],
           false);
  // What the start G-code pushes out is needed, too.
  const std::string purge = " --set 'start_gcode=G28\\nM83\\nG1 E20 F300\\nG1 E-5\\nG1 E5'";
  const double purged_mm = planned(box + purge)["needed_mm"];
  CHECK(purged_mm == doctest::Approx(needed_mm + 20).epsilon(0.001));

  const ProgramRun table = rind("plan " + box + kCoarse + " --spool-left '12 m'");
  CHECK(says(table, "spool      12.00 m are left: enough, "));
  const ProgramRun bare = rind("plan " + box + kCoarse + " --spool-left 12");
  CHECK_EQ(bare.exit_code, 2);
  CHECK(says(bare, "'12' is no amount of filament; write '12 m'"));
  const ProgramRun unknown =
      rind("plan " + box + kCoarse + " --spool-left 12g --set filament_density_g_cm3=0");
  CHECK_EQ(unknown.exit_code, 3);
  CHECK(says(unknown, "set filament_density_g_cm3"));
}

TEST_CASE("a print whose filament will not do says so before anything is heated") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 8, 6, 1.6));
  const std::string print = kCoarse + " --port virtual --virtual-speed 0";
  const ProgramRun enough = rind("print " + box + print + " --spool-left '2 m'");
  CAPTURE(enough.output);
  CHECK_EQ(enough.exit_code, 0);
  CHECK(says(enough, "2.00 m are left: enough, "));
  const ProgramRun few = rind("print " + box + print + " --spool-left '30 mm'");
  CAPTURE(few.output);
  CHECK_EQ(few.exit_code, 2);
  CHECK(says(few, "too short by "));
  CHECK_FALSE(says(few, "nozzle"));

  // Ready G-code tells what it needs; a pipe doesn't, and is counted down.
  const std::string gcode = folder.file("box.gcode");
  REQUIRE_EQ(rind("slice " + box + kCoarse + " -o " + gcode).exit_code, 0);
  CHECK_EQ(rind("print " + gcode + print + " --spool-left '30 mm'").exit_code, 2);
  CHECK_EQ(rind("print " + gcode + print + " --spool-left '2 m'").exit_code, 0);
  CHECK(says(rind("plan " + gcode + " --spool-left '30 mm'"), "too short by "));
  const ProgramRun pipe = test::run_program("cat " + box + " | " + test::kRind + " print - " +
                                            print + " --spool-left '30 mm' 2>&1");
  CAPTURE(pipe.output);
  CHECK_EQ(pipe.exit_code, 0);
  CHECK(says(pipe, "a part from a pipe can't be planned first"));
  CHECK(says(pipe, "of filament are left on the spool"));
}

TEST_CASE("objects in turn: plans and G-code follow them, pictures and layers have all of them") {
  const PartFolder folder;
  const std::string low = folder.add("low.stl", parts::box({1, 1, 0}, 8, 6, 4));
  const std::string high = folder.add("high.stl", parts::box({1, 1, 0}, 8, 6, 8));
  const std::string both = high + " " + low + kCoarse + " --printer none --sequential";
  CHECK(says(rind("plan " + both), "objects    1 low_1, 2 high_2\nlayers     30 of 0.4 mm"));
  const std::string gcode = folder.file("both.gcode");
  REQUIRE_EQ(rind("slice " + both + " -o " + gcode).exit_code, 0);
  const std::string text = content(gcode);
  const std::size_t first = text.find(";Z:4\n");
  REQUIRE(first != std::string::npos);
  CHECK(text.find(";Z:0.4\n", first) != std::string::npos);
  CHECK(says(rind("show " + both + " --layer 10 -o " + folder.file("all.svg")), "layer 10 of 20"));
  CHECK(says(rind("slice " + both + " -o " + folder.file("both.cli")), "both.cli: 20 layers"));
}
