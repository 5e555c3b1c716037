// Whether the filament on the spool is enough: for a whole print, up to its M600, and for the rest
// of one that was interrupted.
#include "host/commands/spool_check.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"

using host::spool_check;
using test::PartFolder;
using test::ProgramRun;
using test::rind;
using test::says;

namespace {

nlohmann::json planned(const std::string& arguments) {
  const ProgramRun run =
      test::run_program(test::kRind + " plan " + arguments + " --json 2> /dev/null");
  REQUIRE_EQ(run.exit_code, 0);
  return nlohmann::json::parse(run.output);
}

// "… needs 1.23 m": in mm, to 5 mm.
double told_mm(const ProgramRun& run) {
  std::smatch match;
  const bool found = std::regex_search(run.output, match, std::regex("needs ([0-9.]+) m of"));
  CAPTURE(run.output);
  REQUIRE(found);
  return 1'000 * std::stod(match[1]);
}

}  // namespace

TEST_CASE("what is needed of the spool at hand") {
  CHECK_EQ(spool_check(100, 90, {}).needed_mm, 90);
  CHECK(spool_check(90, 90, {}).enough());
  CHECK_FALSE(spool_check(89, 90, {}).enough());
  // Up to the change of the spool.
  CHECK_EQ(spool_check(50, 90, 40).needed_mm, 40);
  CHECK(spool_check(50, 90, 40).until_change);
  CHECK(spool_check(50, 90, 40).enough());
  // The rest of a print, before the change and behind it.
  CHECK_EQ(spool_check(50, 90, {}, 30).needed_mm, 60);
  CHECK_EQ(spool_check(50, 90, 40, 30).needed_mm, 10);
  CHECK_EQ(spool_check(50, 90, 40, 60).needed_mm, 30);
  CHECK_FALSE(spool_check(50, 90, 40, 60).until_change);
  CHECK_EQ(spool_check(50, 90, {}, 95).needed_mm, 0);
}

TEST_CASE("in words") {
  CHECK_EQ(host::spool_text({12'000, 9'820}), "12.00 m are left: enough, 2.18 m stay on the spool");
  CHECK_EQ(host::spool_text({500, 1'750}), "500.0 mm are left: too short by 1.25 m");
  CHECK_EQ(host::spool_text({500, 400, true}),
           "500.0 mm are left: enough, 100.0 mm stay on the spool, when M600 asks for another one");
}

TEST_CASE("M600 asks for another spool: of the one at hand, what comes before it is needed") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 8, 6, 4));
  const nlohmann::json whole = planned(box);
  CHECK_FALSE(whole.contains("needed_to_change_mm"));
  const double needed_mm = whole["needed_mm"];
  const std::string change = box + " --at '2 M600'";
  const double to_change_mm = planned(change)["needed_to_change_mm"];
  CHECK_EQ(planned(change)["needed_mm"].get<double>(), doctest::Approx(needed_mm).epsilon(0.01));
  CHECK_GT(to_change_mm, 0.35 * needed_mm);
  CHECK_LT(to_change_mm, 0.65 * needed_mm);

  // The same of a file that has it.
  const std::string gcode = folder.file("change.gcode");
  REQUIRE_EQ(rind("slice " + change + " --quiet -o " + gcode).exit_code, 0);
  const auto left = [&](const std::string& part, double mm) {
    return planned(part + fmt::format(" --spool-left {}mm", mm))["spool_enough"].get<bool>();
  };
  for (const std::string& part : {change, gcode}) {
    CAPTURE(part);
    CHECK_EQ(planned(part)["needed_to_change_mm"].get<double>(),
             doctest::Approx(to_change_mm).epsilon(0.01));
    CHECK(left(part, 1.02 * to_change_mm));
    CHECK_FALSE(left(part, 0.98 * to_change_mm));
  }
  CHECK(says(rind("plan " + gcode + " --spool-left '1 m'"), "when M600 asks for another one"));
  // A print says so, too, and counts nothing down.
  const ProgramRun few = rind("print " + gcode + " --port virtual --virtual-speed 0 --spool-left " +
                              fmt::format("{}mm", 0.9 * to_change_mm));
  CHECK_EQ(few.exit_code, 2);
  CHECK(says(few, "until it is changed by M600"));
  // Before any filament, it asks for the first spool.
  const auto first = planned(box + " --set 'start_gcode=G28\\nM600'");
  CHECK_FALSE(first.contains("needed_to_change_mm"));
}

TEST_CASE("a print that is resumed needs the rest alone") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 25, 25, 25));
  const std::string journal = folder.file("box.journal");
  const double whole_mm = planned(box)["needed_mm"];
  const ProgramRun stopped =
      test::run_program("timeout --preserve-status -s INT 2 " + test::kRind + " print " + box +
                        " --port virtual --virtual-speed 300 --journal " + journal);
  CAPTURE(stopped.output);
  REQUIRE_EQ(stopped.exit_code, 5);
  if (!says(stopped, "to resume it")) return;  // before the first road, on a slow machine
  const std::string resume = "resume " + journal + " --port virtual --virtual-speed 0 --yes";
  const ProgramRun few = rind(resume + " --spool-left '1 mm'");
  CAPTURE(few.output);
  CHECK_EQ(few.exit_code, 2);
  CHECK(says(few, "the rest of the print needs"));
  const double rest_mm = told_mm(few);
  CHECK_LT(rest_mm, whole_mm - 100);
  CHECK_GT(rest_mm, 100);
  // It was not taken up: the journal is as it was. What is left is counted down from here.
  const ProgramRun enough = rind(resume + fmt::format(" --spool-left {}mm --json", rest_mm + 50));
  CAPTURE(enough.output.substr(0, 2'000));
  CHECK_EQ(enough.exit_code, 0);
  std::smatch match;
  const std::regex counted("\"spool_left_mm\":([-0-9.]+)");
  double last_mm = 0;
  for (std::sregex_iterator it(enough.output.begin(), enough.output.end(), counted), end; it != end;
       ++it) {
    last_mm = std::stod((*it)[1]);
    CHECK_LE(last_mm, rest_mm + 51);
    CHECK_GE(last_mm, 0);
  }
}
