// The program as users meet it: exit codes, messages, and what it leaves behind.
#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"
#include "tests/support/svg_text.h"

namespace fs = std::filesystem;
using test::content;
using test::kRind;
using test::PartFolder;
using test::ProgramRun;
using test::rind;
using test::says;

namespace {

const std::string kCoarse = " --layer-height 0.4 --wall-thickness 0.8";

parts::Part small_box() { return parts::box({1, 1, 0}, 8, 6, 4); }

parts::Part with_corner(double value) {
  return parts::edited(small_box(), [value](const parts::Facet& facet, std::int64_t number) {
    parts::Facet changed = facet;
    if (number == 3) changed[1].y = value;
    return std::vector<parts::Facet>{changed};
  });
}

std::string binary_stl(const parts::Part& part) {
  std::ostringstream out;
  parts::write_binary_stl(part, out);
  return out.str();
}

struct BadPart {
  std::string name;
  std::string bytes;
  std::string cause;  // somewhere in the message
};

std::vector<BadPart> bad_parts() {
  const std::string good = binary_stl(small_box());
  return {
      {"empty.stl", "", ""},
      {"cut.stl", good.substr(0, good.size() - 30), ""},
      {"head_only.stl", good.substr(0, 50), ""},
      {"nan.stl", binary_stl(with_corner(std::nan(""))), "facet"},
      {"infinite.stl", binary_stl(with_corner(std::numeric_limits<double>::infinity())), "facet"},
      {"flat.stl", binary_stl(parts::box({1, 1, 0}, 8, 6, 0)), ""},
      {"thin.stl", binary_stl(parts::box({1, 1, 0}, 8, 6, 0.05)), "layer"},
      {"needle.stl", binary_stl(parts::box({1, 1, 0}, 0.1, 0.1, 4)), "road"},
      {"large.stl", binary_stl(parts::box({1, 1, 0}, 800, 6, 4)), "bed"},
      {"far.stl", binary_stl(parts::box({1e7, 1, 0}, 8, 6, 4)), ""},
      {"letter.stl", "Dear printer,\nplease print my part.\n", ""},
      {"half.stl", "solid half\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n", "line"},
  };
}

}  // namespace

TEST_CASE("a bad part ends with code 3, its name, a cause, and no file") {
  const PartFolder folder;
  for (const BadPart& bad : bad_parts()) {
    CAPTURE(bad.name);
    const std::string path = folder.add_text(bad.name, bad.bytes);
    const std::string out = folder.file("out.gcode");
    const ProgramRun run = rind("slice " + path + " -o " + out + kCoarse + " --quiet");
    CAPTURE(run.output);
    CHECK_EQ(run.exit_code, 3);
    CHECK(says(run, bad.name));
    CHECK(says(run, bad.cause));
    CHECK_FALSE(fs::exists(out));
    CHECK_FALSE(fs::exists(out + ".partial"));

    // Nor is anything heated for it.
    const ProgramRun print =
        rind("print " + path + " --port virtual --virtual-speed 0 --quiet" + kCoarse);
    CAPTURE(print.output);
    CHECK_EQ(print.exit_code, 3);
  }
}

TEST_CASE("a part that can't be opened ends with code 3 and the reason") {
  const PartFolder folder;
  const std::string out = folder.file("out.gcode");
  CHECK_EQ(rind("slice " + folder.file("") + " -o " + out).exit_code, 3);
  const ProgramRun missing = rind("slice " + folder.file("none.stl") + " -o " + out);
  CHECK_EQ(missing.exit_code, 3);
  CHECK(says(missing, "none.stl"));

  // Root may read everything, so the program is run as nobody then, from where nobody may read it.
  const std::string locked = folder.add("locked.stl", small_box());
  fs::permissions(locked, fs::perms::none);
  const std::string program = folder.file("rind");
  fs::copy_file(kRind, program);
  const std::string as_nobody =
      geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  const ProgramRun run = test::run_program(as_nobody + program + " plan " + locked);
  CAPTURE(run.output);
  CHECK_EQ(run.exit_code, 3);
  CHECK(says(run, "locked.stl"));
  CHECK(says(run, "permi"));
}

TEST_CASE("odd but good text is taken, whatever its case, blanks and line ends") {
  const PartFolder folder;
  std::ostringstream ascii;
  parts::write_ascii_stl(small_box(), ascii);
  std::string text = ascii.str(), odd;
  for (char c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    if (c == '\n') odd += "\r";
    odd += c == ' ' ? '\t' : c;
  }
  const std::string out = folder.file("out.gcode"), reference = folder.file("reference.gcode");
  const ProgramRun run =
      rind("slice " + folder.add_text("odd.stl", odd) + " -o " + out + kCoarse + " --quiet");
  CAPTURE(run.output);
  CHECK_EQ(run.exit_code, 0);
  CHECK_EQ(rind("slice " + folder.add("box.stl", small_box()) + " -o " + reference + kCoarse +
                " --quiet")
               .exit_code,
           0);
  CHECK_EQ(content(out), content(reference));
}

TEST_CASE("a mended part is printed, and what was mended is told with its heights") {
  const PartFolder folder;
  const auto only = [](bool keep, const parts::Facet& facet, const parts::Facet& other) {
    return keep ? std::vector<parts::Facet>{facet} : std::vector<parts::Facet>{other};
  };
  const std::vector<std::pair<std::string, parts::Part>> faulty = {
      {"hole.stl", parts::edited(small_box(),
                                 [](const parts::Facet& facet, std::int64_t number) {
                                   return number == 4 ? std::vector<parts::Facet>{}
                                                      : std::vector<parts::Facet>{facet};
                                 })},
      {"flipped.stl", parts::edited(small_box(),
                                    [&only](const parts::Facet& facet, std::int64_t number) {
                                      return only(number != 6, facet, parts::flipped(facet));
                                    })},
      {"doubled.stl",
       parts::edited(small_box(), [](const parts::Facet& facet, std::int64_t number) {
         return number == 7 ? std::vector<parts::Facet>{facet, facet}
                            : std::vector<parts::Facet>{facet};
       })}};
  for (const auto& each : faulty) {
    const std::string& name = each.first;
    CAPTURE(name);
    const std::string stats = folder.file("stats.json");
    const ProgramRun run = rind("slice " + folder.add(name, each.second) + " -o " +
                                folder.file("out.gcode") + kCoarse + " --stats " + stats);
    CAPTURE(run.output);
    CHECK_EQ(run.exit_code, 0);
    CHECK(says(run, "mended in"));
    CHECK(says(run, "at height"));
    CHECK_GT(nlohmann::json::parse(content(stats))["defects"]["layers"], 0);
  }
}

TEST_CASE(
    "an island that begins in the air is told with layer, place and size, or ends the print") {
  const PartFolder folder;
  const std::string part = folder.add(
      "island.stl",
      parts::together({parts::box({0, 0, 0}, 5, 20, 6), parts::box({15, 5, 2}, 6, 4, 4)}));
  const std::string told = "an island of 24.0 mm² begins in the air at (157.5, 147.0) mm";
  const std::string stats = folder.file("stats.json"), out = folder.file("out.gcode");
  const ProgramRun plan = rind("plan " + part + kCoarse + " --stats " + stats);
  CHECK_EQ(plan.exit_code, 0);
  CAPTURE(plan.output);
  CHECK(says(plan, told + " on the bed, layer 6, 2 mm high"));
  CHECK(says(plan, "1 island begins in the air"));
  const auto islands = nlohmann::json::parse(content(stats))["hanging"]["islands"];
  CHECK_EQ(islands["count"], 1);
  CHECK_EQ(islands["first"][0]["layer"], 6);
  CHECK(says(rind("show " + part + kCoarse + " --layer 7 -o " + folder.file("l.svg")), told));
  const ProgramRun stop = rind("slice " + part + kCoarse + " --on-floating stop -o " + out);
  CHECK_EQ(stop.exit_code, 3);
  CHECK(says(stop, told));
  CHECK_FALSE(std::filesystem::exists(out));
  const std::string print = "print " + part + kCoarse + " --port virtual --virtual-speed 0";
  CHECK_EQ(rind(print + " --on-floating stop").exit_code, 3);
  const ProgramRun printed = rind(print);
  CHECK_EQ(printed.exit_code, 0);
  CHECK(says(printed, told));
}

TEST_CASE("a bad setting ends with code 3 and what would be right") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box());
  const ProgramRun unknown = rind("plan " + box + " --set layer_hight=0.2");
  CHECK_EQ(unknown.exit_code, 3);
  CHECK(says(unknown, "layer_height"));
  CHECK_EQ(rind("plan " + box + " --layer-height -1").exit_code, 3);
  CHECK_EQ(rind("plan " + box + " --set start_gcode=M112").exit_code, 3);
  CHECK_EQ(rind("plan " + box + " --profile " + folder.file("none.ini")).exit_code, 3);
  const ProgramRun layer = rind("show " + box + " --layer 99999 -o " + folder.file("a.svg"));
  CHECK_EQ(layer.exit_code, 3);
  CHECK(says(layer, "highest is"));
  const ProgramRun missed = rind("show " + box + " --section X=8.1 -o " + folder.file("a.svg"));
  CHECK_EQ(missed.exit_code, 3);
  CHECK(says(missed, "misses the part, which reaches from 0 to 8 mm"));
  const ProgramRun beside =
      rind("show " + box + " --section X=4 --zoom 9,2,2 -o " + folder.file("a.svg"));
  CHECK_EQ(beside.exit_code, 3);
  CHECK(says(beside, "misses the part, which is 6 mm wide there and 4 mm high"));
  CHECK_FALSE(fs::exists(folder.file("a.svg")));
}

TEST_CASE("an output that can't be written ends with code 3 and leaves no file") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box());
  const ProgramRun full = rind("slice " + box + " -o /dev/full --format gcode --quiet");
  CHECK_EQ(full.exit_code, 3);
  CHECK(says(full, "No space left"));
  CHECK_EQ(rind("slice " + box + " -o /nowhere/out.gcode --quiet").exit_code, 3);
  const ProgramRun stats = rind("plan " + box + kCoarse + " --quiet --stats /nowhere/stats.json");
  CHECK_EQ(stats.exit_code, 3);
  CHECK(says(stats, "/nowhere/stats.json"));
  // A reader that leaves early is an error too, not a death by signal.
  const ProgramRun left = test::run_program("set -o pipefail; " + kRind + " slice " + box +
                                            " -o - --format gcode --quiet | true");
  CHECK_LT(left.exit_code, 128);
}

TEST_CASE("standard input and standard output are parts and files like others") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box()), out = folder.file("out.gcode");
  // A pipe can't be patched, and has no lines of progress.
  const std::string alike = kCoarse + std::string(" --set progress_commands=0");
  CHECK_EQ(rind("slice " + box + " -o " + out + alike + " --quiet").exit_code, 0);
  const ProgramRun piped = test::run_program("cat " + box + " | " + kRind +
                                             " slice - -o - --format gcode --quiet" + alike);
  CHECK_EQ(piped.exit_code, 0);
  CHECK_EQ(piped.output, content(out));
}

TEST_CASE("a file's statistics tell when its first road was there, if it has roads") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box()), stats = folder.file("s.json");
  const auto first_road = [&](const std::string& format) {
    CHECK_EQ(rind("slice " + box + " -o /dev/null --quiet --format " + format + kCoarse +
                  " --stats " + stats)
                 .exit_code,
             0);
    return nlohmann::json::parse(content(stats))["first_road_cpu_s"];
  };
  CHECK_GT(first_road("gcode"), 0.0);
  CHECK_GT(first_road("cli-roads"), 0.0);
  CHECK(first_road("cli").is_null());
}

TEST_CASE("a port must be named, and must be there") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box());
  const ProgramRun none = rind("print " + box);
  CHECK_EQ(none.exit_code, 2);
  CHECK(says(none, "--port virtual"));
  // No nozzle is sent to a bed that nobody knows.
  const ProgramRun unknown = rind("print " + box + " --port /dev/tty_none");
  CHECK_EQ(unknown.exit_code, 3);
  CHECK(says(unknown, "rind setup --port /dev/tty_none"));
  const ProgramRun missing = rind("print " + box + " --port /dev/tty_none --preset ender3");
  CHECK_EQ(missing.exit_code, 4);
  CHECK(says(missing, "/dev/tty_none"));
}

TEST_CASE("an interrupt in mid-print ends with code 5, where it was and what was done") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", parts::box({1, 1, 0}, 8, 6, 200));
  const std::string stats = folder.file("stats.json");
  // Interrupted when some layers have been told of, however slow the machine.
  const std::string out = folder.file("events.json");
  const ProgramRun run = test::run_program(
      kRind + " print " + box + " --port virtual --virtual-speed 50 --json --stats " + stats +
      " > " + out + " & pid=$!; for i in $(seq 300); do grep -q 'layer\":[1-9][0-9]' " + out +
      " && break; sleep 0.1; done; kill -TERM $pid; wait $pid; code=$?; cat " + out +
      "; exit $code");
  CAPTURE(run.output);
  CHECK_EQ(run.exit_code, 5);
  CHECK(says(run, "stopped at layer"));
  CHECK(says(run, "heaters and fan off"));
  CHECK(says(run, "\"exit_code\":5"));
  CHECK_FALSE(nlohmann::json::parse(content(stats))["first_road_s"].is_null());
}

TEST_CASE("events are JSON, a line each") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box());
  const ProgramRun run = test::run_program(kRind + " print " + box +
                                           " --port virtual --virtual-speed 0 --json" + kCoarse);
  CHECK_EQ(run.exit_code, 0);
  std::istringstream lines(run.output);
  std::string line, last;
  int count = 0;
  while (std::getline(lines, line)) {
    CAPTURE(line);
    const auto event = nlohmann::json::parse(line, nullptr, false);
    REQUIRE(event.is_object());
    last = event["event"];
    ++count;
  }
  CHECK_GE(count, 3);
  CHECK_EQ(last, "done");
}

TEST_CASE("plan, show and settings tell what they should") {
  const PartFolder folder;
  const std::string box = folder.add("box.stl", small_box()), svg = folder.file("layer.svg");
  const ProgramRun plan = rind("plan " + box + kCoarse);
  CHECK_EQ(plan.exit_code, 0);
  for (const char* word : {"10 of 0.4 mm", "outer perimeter", "time", "wall", "defects    none"}) {
    CAPTURE(word);
    CHECK(says(plan, word));
  }
  CHECK_EQ(rind("show " + box + " --layer 5 -o " + svg + kCoarse).exit_code, 0);
  CHECK_NE(content(svg).find("</svg>"), std::string::npos);
  CHECK_EQ(rind("show " + box + " --section Y=3 -o " + svg + kCoarse).exit_code, 0);
  CHECK_EQ(test::svg_fault(content(svg)), "");
  CHECK_NE(content(svg).find("cut 3 mm behind its front"), std::string::npos);
  CHECK_EQ(rind("show " + box + " --section X=8 -o " + svg + kCoarse).exit_code, 0);
  CHECK_EQ(rind("show " + box + " --section X=4 --zoom 1,3,2 -o " + svg + kCoarse).exit_code, 0);
  CHECK_EQ(test::svg_fault(content(svg)), "");

  // What `rind settings` prints is a profile that changes nothing.
  const std::string profile = folder.file("all.ini");
  CHECK_EQ(rind("settings --set perimeters=3 > " + profile).exit_code, 0);
  const ProgramRun again = rind("settings --profile " + profile);
  CAPTURE(again.output);
  CHECK_EQ(again.exit_code, 0);
  CHECK_EQ(again.output, content(profile));
  CHECK(says(again, "perimeters = 3"));
}

TEST_CASE("a cut shows supports, and each kind of road stands in its legend") {
  const PartFolder folder;
  const std::string part = folder.add("mushroom.stl", parts::mushroom());
  const std::string svg = folder.file("cut.svg");
  const ProgramRun run = rind("show " + part + " --section Y=50% -o " + svg + " --quiet" +
                              " --set supports=everywhere");
  CAPTURE(run.output);
  REQUIRE_EQ(run.exit_code, 0);
  const std::string picture = content(svg);
  CHECK_EQ(test::svg_fault(picture), "");
  for (const char* kind :
       {"outer perimeter", "bridge over loose", ">support<", "support interface"}) {
    CAPTURE(kind);
    CHECK_NE(picture.find(kind), std::string::npos);
  }
}

TEST_CASE("a cut through a part ten times as tall holds no more layers") {
  const PartFolder folder;
  const std::string stats = folder.file("stats.json"), svg = folder.file("cut.svg");
  const auto peak_layers = [&](std::int64_t layers) {
    const std::string tower = folder.add("tower.stl", parts::tower(layers));
    const ProgramRun run = rind("show " + tower + " --section Y=50% -o " + svg + " --stats " +
                                stats + " --quiet --set simplify_tolerance=0.05");
    CAPTURE(run.output);
    REQUIRE_EQ(run.exit_code, 0);
    CHECK_EQ(test::svg_fault(content(svg)), "");
    const nlohmann::json read = nlohmann::json::parse(content(stats));
    CHECK_EQ(read.at("layers"), layers);
    return read.at("peak_layers_held").get<int>();
  };
  CHECK_EQ(peak_layers(20), peak_layers(200));
}

TEST_CASE("any number of threads gives the same bytes") {
  const PartFolder folder;
  const std::string part = folder.add("demo.stl", parts::demo());
  const std::string unequal = " --set adaptive_layer_height=1 --height-range '10-12 0.25'";
  for (const std::string name : {"out.gcode", "out.cli", "unequal.gcode"}) {
    CAPTURE(name);
    const std::string heights = name == "unequal.gcode" ? unequal : "";
    std::string one;
    for (const char* threads : {"1", "2", "5"}) {
      CAPTURE(threads);
      const std::string out = folder.file(name);
      const ProgramRun run =
          rind("slice " + part + kCoarse + heights + " --quiet --jobs " + threads + " -o " + out);
      REQUIRE_EQ(run.exit_code, 0);
      if (one.empty()) one = content(out);
      CHECK_FALSE(one.empty());
      CHECK(content(out) == one);
    }
  }
}
