// What is wrong with a command line, in words that help; help texts.
#include "host/settings/usage.h"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "host/settings/options.h"
#include "host/system/exit_codes.h"

namespace {

host::OptionsExit parse(std::vector<const char*> words) {
  words.insert(words.begin(), "rind");
  const auto parsed = host::parse_options(static_cast<int>(words.size()), words.data());
  const auto* exit = std::get_if<host::OptionsExit>(&parsed);
  return exit != nullptr ? *exit : host::OptionsExit{-1, {}, false};
}

std::string refusal(const std::vector<const char*>& words) {
  const host::OptionsExit exit = parse(words);
  CHECK_EQ(exit.exit_code, host::kExitUsage);
  return exit.text.substr(0, exit.text.find('\n'));
}

}  // namespace

TEST_CASE("an unknown option is told first, with the nearest") {
  CHECK_EQ(refusal({"slice", "demo.stl", "--foo"}), "rind slice has no option --foo");
  CHECK_EQ(refusal({"plan", "demo.stl", "--layer-hieght", "0.2"}),
           "rind plan has no option --layer-hieght; did you mean --layer-height?");
  CHECK_EQ(refusal({"plan", "--set=perimeters=3", "--layer-hieght=0.2"}),
           "rind plan has no option --layer-hieght; did you mean --layer-height?");
  CHECK_EQ(refusal({"plan", "-x.stl"}),
           "there is no option -x.stl; a file of that name is ./-x.stl");
  CHECK_EQ(refusal({"help", "shw"}).find("'shw' is not a command; did you mean show? "), 0);
  CHECK_NE(parse({"slice", "--foo"}).text.find("Try 'rind slice --help'."), std::string::npos);
  CHECK_EQ(refusal({"prnt", "demo.stl"}).find("'prnt' is not a command; did you mean print? "), 0);
}

TEST_CASE("values that look like options are values") {
  CHECK_EQ(parse({"plan", "a.stl", "--set", "--foo=1"}).exit_code, -1);
  CHECK_EQ(parse({"slice", "a.stl", "-oout.gcode"}).exit_code, -1);
}

TEST_CASE("help and version, as people ask for them") {
  for (const std::vector<const char*>& words :
       {std::vector<const char*>{}, {"help"}, {"--help"}, {"-h"}}) {
    const host::OptionsExit exit = parse(words);
    CHECK_EQ(exit.exit_code, host::kExitDone);
    CHECK_NE(exit.text.find("print a part while it is being sliced"), std::string::npos);
    CHECK_NE(exit.text.find("Exit codes: 0 done"), std::string::npos);
  }
  CHECK_EQ(parse({"help", "print"}).text, parse({"print", "--help"}).text);
  CHECK_EQ(parse({"-V"}).text, parse({"--version"}).text);
  CHECK_EQ(parse({"-v"}).text, parse({"--version"}).text);
}

TEST_CASE("no line of help is wider than a window") {
  for (const char* command :
       {"setup", "print", "resume", "slice", "plan", "show", "ports", "presets", "settings"}) {
    std::istringstream help(parse({command, "--help"}).text);
    for (std::string line; std::getline(help, line);) {
      CAPTURE(line);
      CHECK_LE(line.size(), static_cast<std::size_t>(host::kHelpColumns));
    }
  }
}

TEST_CASE("with --json a usage error is an event") {
  const host::OptionsExit exit = parse({"plan", "demo.stl", "--json", "--foo"});
  CHECK(exit.json);
  CHECK_EQ(exit.text, "rind plan has no option --foo");
}
