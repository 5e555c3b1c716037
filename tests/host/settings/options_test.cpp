#include "host/settings/options.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "host/system/exit_codes.h"

using host::Options;
using host::OptionsExit;
using host::OutputFormat;
using host::Subcommand;

namespace {

std::variant<Options, OptionsExit> parse(std::vector<const char*> words) {
  words.insert(words.begin(), "rind");
  return host::parse_options(static_cast<int>(words.size()), words.data());
}

Options parse_good(const std::vector<const char*>& words) {
  const auto parsed = parse(words);
  if (const auto* refused = std::get_if<OptionsExit>(&parsed)) FAIL(refused->text);
  return std::get<Options>(parsed);
}

OptionsExit parse_bad(const std::vector<const char*>& words) {
  const auto parsed = parse(words);
  REQUIRE(std::holds_alternative<OptionsExit>(parsed));
  return std::get<OptionsExit>(parsed);
}

bool says(const OptionsExit& refused, const std::string& text) {
  return refused.text.find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("print takes a part, a port and settings in the order typed") {
  const Options options =
      parse_good({"print", "part.stl", "--port", "/dev/ttyUSB0", "--baud", "250000", "--set",
                  "perimeters=3", "--wall-thickness", "1.2", "--set", "perimeters=1", "--quiet"});
  CHECK_EQ(options.subcommand, Subcommand::kPrint);
  CHECK_EQ(options.part.path, "part.stl");
  CHECK_EQ(options.link.port, "/dev/ttyUSB0");
  CHECK_EQ(options.link.baud, 250'000);
  CHECK(options.quiet);
  REQUIRE_EQ(options.settings.assignments.size(), 3);
  CHECK_EQ(options.settings.assignments[0], std::pair<std::string, std::string>("perimeters", "3"));
  CHECK_EQ(options.settings.assignments[1],
           std::pair<std::string, std::string>("wall_thickness", "1.2"));
  CHECK_EQ(options.settings.assignments[2], std::pair<std::string, std::string>("perimeters", "1"));
}

TEST_CASE("--set takes one assignment and leaves the part alone") {
  const Options options =
      parse_good({"slice", "--set", "perimeters=3", "part.stl", "-o", "out.gcode"});
  CHECK_EQ(options.part.path, "part.stl");
  REQUIRE_EQ(options.settings.assignments.size(), 1);
}

TEST_CASE("ranges of height may be given several times, each a line of its setting") {
  const Options options =
      parse_good({"slice", "part.stl", "-o", "out.gcode", "--support-range", "0-20 off",
                  "--height-range", "1-2 0.1", "--support-range", "35-40 on"});
  REQUIRE_FALSE(options.settings.assignments.empty());
  CHECK_EQ(options.settings.assignments.back(),
           std::pair<std::string, std::string>("support_height_range", "0-20 off\\n35-40 on"));
}

TEST_CASE("the form of the output follows its name, or --format") {
  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "a.gcode"}).output.format, OutputFormat::kGcode);
  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "a.CLI"}).output.format, OutputFormat::kCli);
  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "-", "--format", "cli"}).output.format,
           OutputFormat::kCli);
  CHECK_EQ(parse_good({"slice", "-", "-o", "-", "--format", "gcode"}).part.path, "-");

  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "-"}).output.format, OutputFormat::kGcode);
  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "/dev/null"}).output.format, OutputFormat::kGcode);

  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "a.lsif"}).output.format, OutputFormat::kLsif);
  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "a.ssl"}).output.format, OutputFormat::kSliceV0);
  CHECK_EQ(parse_good({"slice", "p.stl", "-o", "a.svg"}).output.format, OutputFormat::kSvg);
  const Options roads = parse_good({"slice", "p.stl", "-o", "a.cli", "--format", "cli-roads"});
  CHECK_EQ(roads.output.format, OutputFormat::kCliRoads);

  CHECK(says(parse_bad({"slice", "p.stl", "-o", "a.stl"}), "the name 'a.stl' does not tell"));
  CHECK(says(parse_bad({"slice", "p.stl", "-o", "a"}), "--format"));
}

TEST_CASE("a layer file holds walls where it can tell them apart, or what is asked for") {
  using host::LayerContents;
  const auto contents = [](const char* output, const char* asked) {
    if (asked == nullptr) return parse_good({"slice", "p.stl", "-o", output}).output.contents;
    return parse_good({"slice", "p.stl", "-o", output, "--contents", asked}).output.contents;
  };
  CHECK_EQ(contents("a.cli", nullptr), LayerContents::kWalls);
  CHECK_EQ(contents("a.lsif", nullptr), LayerContents::kWalls);
  CHECK_EQ(contents("a.ssl", nullptr), LayerContents::kSlices);
  CHECK_EQ(contents("a.svg", nullptr), LayerContents::kSlices);
  CHECK_EQ(contents("a.cli", "slices"), LayerContents::kSlices);
  CHECK_EQ(contents("a.ssl", "quickslice"), LayerContents::kWallsForQuickSlice);
  CHECK_EQ(parse_good({"formats"}).subcommand, host::Subcommand::kFormats);
}

TEST_CASE("a cut is asked for by axis, in mm or per cent") {
  const auto section = [](const char* text) {
    const Options options = parse_good({"show", "p.stl", "-o", "a.svg", "--section", text});
    CHECK_EQ(options.output.layer, 0);
    return options.output.section.value();
  };
  CHECK_EQ(section("Y=12.5").axis, 'Y');
  CHECK_EQ(section("Y=12.5").value, 12.5);
  CHECK_FALSE(section("Y=12.5").percent);
  CHECK_EQ(section("y=3 mm").value, 3);
  CHECK_EQ(section("x=50%").axis, 'X');
  CHECK_EQ(section("x=50%").value, 50);
  CHECK(section("x=50%").percent);
  CHECK_FALSE(
      parse_good({"show", "p.stl", "-o", "a.svg", "--layer", "2"}).output.section.has_value());
  const Options zoomed =
      parse_good({"show", "p.stl", "-o", "a.svg", "--section", "Y=1", "--zoom", "4,10.5,6"});
  CHECK_EQ(zoomed.output.zoom.value().along, 4);
  CHECK_EQ(zoomed.output.zoom.value().height, 10.5);
  CHECK_EQ(zoomed.output.zoom.value().size, 6);
}

TEST_CASE("several parts may be named") {
  const Options options = parse_good({"slice", "p.stl", "q.3mf", "-o", "a.gcode"});
  CHECK_EQ(options.part.path, "p.stl");
  CHECK_EQ(options.part.more_paths, std::vector<std::string>{"q.3mf"});
}

TEST_CASE("what can't be understood is refused with exit code 2 and the reason") {
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases = {
      {{"prnt", "p.stl"}, "prnt"},
      {{"print"}, "PART"},
      {{"slice", "p.stl"}, "--output"},
      {{"show", "p.stl", "-o", "a.svg"}, "--layer"},
      {{"show", "p.stl", "-o", "a.svg", "--layer", "0"}, "--layer"},
      {{"show", "p.stl", "-o", "a.svg", "--layer", "3", "--section", "Y=1"}, "--section"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Z=1"}, "'Z=1' is no position for a cut"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Y="}, "Y=12.5"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Y=1inch"}, "Y=12.5"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "X=nan"}, "X=50%"},
      {{"show", "p.stl", "-o", "a.svg", "--layer", "3", "--zoom", "1,2,3"}, "--section"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Y=1", "--zoom", "1,2"}, "4,10,6"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Y=1", "--zoom", "1,2,3,4"}, "4,10,6"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Y=1", "--zoom", "1,b,3"}, "4,10,6"},
      {{"show", "p.stl", "-o", "a.svg", "--section", "Y=1", "--zoom", "1,2,0"}, "4,10,6"},
      {{"print", "p.stl", "--baud", "fast"}, "--baud"},
      {{"print", "p.stl", "--baud", "7"}, "--baud"},
      {{"print", "p.stl", "--virtual-speed", "-1"}, "--virtual-speed"},
      {{"plan", "p.stl", "--set", "perimeters"}, "KEY=VALUE"},
      {{"plan", "p.stl", "--set", "=3"}, "KEY=VALUE"},
      {{"plan", "p.stl", "--colour"}, "--colour"},
  };
  for (const auto& each : cases) {
    const OptionsExit refused = parse_bad(each.first);
    const std::string& reason = each.second;
    CAPTURE(refused.text);
    CAPTURE(reason);
    CHECK_EQ(refused.exit_code, host::kExitUsage);
    CHECK(says(refused, reason));
    CHECK(says(refused, "Try 'rind "));
    CHECK(says(refused, "--help'"));
  }
}

TEST_CASE("help and version end well and say what they should") {
  CHECK_EQ(parse_bad({"--help"}).exit_code, host::kExitDone);
  for (const char* word : {"print", "slice", "plan", "show", "ports", "settings"}) {
    CHECK(says(parse_bad({"--help"}), word));
  }
  CHECK(says(parse_bad({"--help"}), "resume"));
  CHECK(says(parse_bad({"print", "--help"}), "--virtual-speed"));
  CHECK_EQ(parse_bad({"--version"}).exit_code, host::kExitDone);
  CHECK(says(parse_bad({"--version"}), "rind 0.1.0"));
}

TEST_CASE("bounds of memory, the order of a pipe, bad layers and a log") {
  const Options plain = parse_good({"print", "part.stl", "--port", "virtual"});
  CHECK_EQ(plain.part.sort_bytes, std::size_t{8} << 20);
  CHECK_EQ(plain.memory_limit_bytes, 0);
  CHECK_EQ(plain.part.sorted, host::PipeSorted::kAuto);
  CHECK_EQ(plain.part.on_bad_layer, host::OnBadLayer::kRepair);
  CHECK_EQ(plain.part.on_floating, host::OnFloating::kWarn);
  CHECK(plain.log.empty());
  const Options options = parse_good({"print", "-", "--port", "virtual", "--memory", "512k",
                                      "--memory-limit", "64M", "--sorted", "yes", "--on-bad-layer",
                                      "neighbour", "--on-floating", "stop", "--log", "rind.log"});
  CHECK_EQ(options.part.on_floating, host::OnFloating::kStop);
  CHECK_EQ(options.part.sort_bytes, std::size_t{512} << 10);
  CHECK_EQ(options.memory_limit_bytes, std::size_t{64} << 20);
  CHECK_EQ(options.part.sorted, host::PipeSorted::kYes);
  CHECK_EQ(options.part.on_bad_layer, host::OnBadLayer::kNeighbour);
  CHECK_EQ(options.log, "rind.log");
  CHECK_EQ(parse_good({"slice", "-", "-o", "a.gcode", "--sorted", "no"}).part.sorted,
           host::PipeSorted::kNo);
  CHECK_EQ(parse_bad({"plan", "a.stl", "--memory", "63k"}).exit_code, host::kExitUsage);
  CHECK_EQ(parse_bad({"plan", "a.stl", "--memory", "much"}).exit_code, host::kExitUsage);
  CHECK_EQ(parse_bad({"slice", "-", "-o", "a.gcode", "--sorted", "maybe"}).exit_code,
           host::kExitUsage);
  CHECK_EQ(parse_bad({"plan", "a.stl", "--on-bad-layer", "weep"}).exit_code, host::kExitUsage);
}

TEST_CASE("resume takes a journal; the rest is in it") {
  const Options options =
      parse_good({"resume", "p.print.journal", "--yes", "--nozzle-height", "12.5"});
  CHECK_EQ(options.subcommand, Subcommand::kResume);
  CHECK_EQ(options.print.journal, "p.print.journal");
  CHECK(options.part.path.empty());
  CHECK(options.link.port.empty());
  CHECK(options.print.yes);
  CHECK_EQ(options.print.nozzle_height_mm, 12.5);
  CHECK_FALSE(options.link.baud_told);
  CHECK_FALSE(options.print.bad_layer_told);
  const Options told = parse_good({"resume", "p.print.journal", "--port", "/dev/x", "--baud",
                                   "250000", "--on-bad-layer", "repair", "--part", "q.stl"});
  CHECK(told.link.baud_told);
  CHECK(told.print.bad_layer_told);
  CHECK_EQ(told.part.path, "q.stl");
  CHECK(parse_good({"resume"}).print.journal.empty());  // lists
}

TEST_CASE("what a print does when the line is lost, and where its journal is") {
  const Options plain = parse_good({"print", "part.stl"});
  CHECK_EQ(plain.link.on_lost_port, host::OnLostPort::kWait);
  CHECK_FALSE(plain.print.no_journal);
  CHECK_FALSE(plain.print.anew);
  CHECK(parse_good({"print", "part.stl", "--anew"}).print.anew);
  const Options told = parse_good({"print", "part.stl", "--on-lost-port", "stop", "--journal", "j",
                                   "--lost-port-wait", "5", "--pause-heat", "7"});
  CHECK_EQ(told.link.on_lost_port, host::OnLostPort::kStop);
  CHECK_EQ(told.print.journal, "j");
  CHECK_EQ(told.link.lost_port_wait_s, 5);
  CHECK_EQ(told.print.pause_heat_s, 7);
  CHECK_EQ(parse_bad({"print", "part.stl", "--journal", "j", "--no-journal"}).exit_code,
           host::kExitUsage);
}
