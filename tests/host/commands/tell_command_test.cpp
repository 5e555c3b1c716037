// A running print is told what to do by another program.
#include <doctest/doctest.h>

#include <string>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"

using test::kRind;
using test::PartFolder;
using test::ProgramRun;
using test::rind;
using test::run_program;
using test::says;

TEST_CASE("a request that is none, and one that nobody hears, are errors") {
  const PartFolder folder;
  const std::string state = "XDG_STATE_HOME=" + folder.file("state") + " ";
  CHECK_EQ(run_program(state + kRind + " tell dance").exit_code, 2);
  CHECK(says(run_program(state + kRind + " tell cancel x"), "pause, resume, stop, cancel N"));
  const ProgramRun nobody = run_program(state + kRind + " tell stop");
  CHECK_EQ(nobody.exit_code, 3);
  CHECK(says(nobody, "no print is running"));
  CHECK(says(run_program(state + kRind + " tell stop --print part.stl"), "of part.stl is running"));
}

TEST_CASE("another program cancels an object, pauses, and stops") {
  const PartFolder folder;
  const std::string part = folder.add("box.stl", parts::box({1, 1, 0}, 12, 12, 40));
  const std::string plan = rind("plan --printer none --copies 3 " + part).output;
  CHECK(plan.find("objects    1 box_1, 2 box_2, 3 box_3") != std::string::npos);
  const std::string state = folder.file("state");
  const std::string print = kRind + " print --printer none --copies 3 --port virtual" +
                            " --virtual-speed 20 --journal " + state + "/rind/one.journal --json ";
  const std::string tell = kRind + " tell ";
  // The first request is repeated until the print has begun.
  const ProgramRun run = run_program(
      "export XDG_STATE_HOME=" + state + "; mkdir -p " + state + "/rind; " + print + part +
      " & print=$!; for i in $(seq 300); do " + tell + "cancel 2 2> " + folder.file("why") +
      " && break; sleep 0.1; done; " +  //
      tell + "cancel 7; echo wrong $?; " + tell + "cancel 2; echo again $?; " + tell +
      "pause --print " + part + "; echo pause $?; " + tell +
      "stop --print box.stl; kill -0 $print && sleep 5; kill $print; wait $print; echo print $?");
  CAPTURE(run.output);
  CHECK(says(run, "object 2 is cancelled"));
  CHECK(says(run, "was told to cancel object 7, but its journal does not say"));
  CHECK(says(run, "wrong 3"));
  CHECK(says(run, "again 0"));
  CHECK(says(run, "pause 0"));
  CHECK(says(run, "print 5"));
}
