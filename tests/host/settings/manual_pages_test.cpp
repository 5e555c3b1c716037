// Manual pages hold what help and the table of settings hold; no text in them is a sign of man.
#include "host/settings/manual_pages.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "host/settings/options.h"
#include "host/system/exit_codes.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace {

host::OptionsExit parse(std::vector<const char*> words) {
  words.insert(words.begin(), "rind");
  const auto parsed = host::parse_options(static_cast<int>(words.size()), words.data());
  const auto* exit = std::get_if<host::OptionsExit>(&parsed);
  REQUIRE(exit != nullptr);
  return *exit;
}

std::string printed(const std::vector<const char*>& words) {
  const host::OptionsExit exit = parse(words);
  REQUIRE_EQ(exit.exit_code, host::kExitDone);
  return exit.text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The words of a page as a reader sees them, one space between them.
std::string read(const std::string& source) {
  std::string page, plain;
  for (const std::string& line : lines_of(source)) {
    if (line != ".TP" && line != ".br")
      page += (line.rfind(".SH ", 0) == 0 ? line.substr(4) : line) + "\n";
  }
  for (std::size_t i = 0; i < page.size(); ++i) {
    if (page[i] != '\\') {
      plain += page[i];
    } else if (page[++i] == 'f') {
      ++i;  // a font
    } else if (page[i] == 'e') {
      plain += '\\';
    } else if (page[i] == '-') {
      plain += '-';
    } else if (page[i] == '(') {  // a letter's name
      const std::string name = page.substr(i + 1, 2);
      plain += name == "aq" ? '\'' : name == "ga" ? '`' : name == "ha" ? '^' : '~';
      i += 2;
    }
  }
  std::istringstream in(plain);
  std::string words;
  for (std::string word; in >> word;) words += word + " ";
  return words;
}

bool holds(const std::string& page, const std::string& text) {
  return read(page).find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("there is a page for each command that help lists") {
  const std::vector<std::string> pages = lines_of(printed({"manual"}));
  CHECK_EQ(pages.front(), "rind.1");
  CHECK_EQ(pages.back(), "rind.ini.5");
  const std::string help = printed({"help"});
  std::size_t commands = 0;
  for (const std::string& line : lines_of(help.substr(help.find("Subcommands:")))) {
    if (line.rfind("  ", 0) != 0) continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    CAPTURE(name);
    ++commands;
    CHECK_EQ(std::count(pages.begin(), pages.end(), "rind-" + name + ".1"), 1);
    CHECK(holds(printed({"manual", "rind.1"}), "rind " + name + " "));
  }
  CHECK_EQ(pages.size(), commands + 2);
  CHECK_EQ(parse({"manual", "rind-fly.1"}).exit_code, host::kExitUsage);
  CHECK_NE(parse({"manual", "rind-fly.1"}).text.find("there are rind.1, rind-"), std::string::npos);
}

TEST_CASE("a command's page has every option and operand of its help") {
  std::size_t count = 0;
  for (const char* command : {"setup", "print", "resume", "slice", "plan", "show", "presets"}) {
    const std::string page = printed({"manual", ("rind-" + std::string(command) + ".1").c_str()});
    CAPTURE(command);
    for (const std::string& line : lines_of(printed({command, "--help"}))) {
      if (line.rfind("  -", 0) != 0) continue;
      std::string names = line.substr(2, line.find(' ', 2) - 2);
      if (const std::size_t comma = names.find(','); comma != std::string::npos) {
        names.insert(comma + 1, " ");
      }
      CAPTURE(names);
      CHECK(holds(page, names + " "));
      ++count;
    }
    CHECK(holds(page, "EXIT STATUS 0 done 2 "));
    CHECK(holds(page, "SEE ALSO rind(1)"));
  }
  CHECK_GT(count, 100);
  CHECK(holds(printed({"manual", "rind-show.1"}), "rind show [OPTIONS] -o, --output FILE PART "));
  CHECK(holds(printed({"manual", "rind-presets.1"}), "rind presets [OPTIONS] [NAME] "));
  CHECK(holds(printed({"manual", "rind-print.1"}), "XDG_STATE_HOME"));
  CHECK_FALSE(holds(printed({"manual", "rind-plan.1"}), "XDG_STATE_HOME"));
}

TEST_CASE("rind.ini has all settings with range and default") {
  const std::string page = read(printed({"manual", "rind.ini.5"}));
  const auto rows = host::describe_settings(host::PrintSettings{});
  CHECK_GT(rows.size(), 100);
  for (const host::SettingRow& row : rows) {
    CAPTURE(row.key);
    std::istringstream in(row.key + " " + row.help + " " + row.range + "; default: " +
                          (row.default_value.empty() ? "empty" : row.default_value));
    std::string words;
    for (std::string word; in >> word;) words += word + " ";
    CHECK_NE(page.find(words), std::string::npos);
  }
}

TEST_CASE("text means itself") {
  CHECK_EQ(host::manual_text("a-b 'c' \\n ~ ^ `"), "a\\-b \\(aqc\\(aq \\en \\(ti \\(ha \\(ga");
  host::ProgramText program;
  program.commands = {{"go", ".SH NOTHING", {}, {}}};
  program.commands[0].options = {
      {{"--far"}, "N", host::ValueKind::kText, {}, ".br 'x", "", false, false}};
  for (const host::ManualPage& page : host::manual_pages(program, {})) {
    for (const std::string& line : lines_of(page.text)) {
      CAPTURE(line);
      CHECK_FALSE((line.rfind(".SH NOTHING", 0) == 0 || line.rfind(".br '", 0) == 0));
      CHECK_FALSE(line.rfind("'", 0) == 0);
    }
  }
}

TEST_CASE("man shows every page without a complaint") {
  if (test::run_program("command -v man").exit_code != 0) return;
  const test::TemporaryFolder folder;
  for (const std::string& name : lines_of(printed({"manual"}))) {
    CAPTURE(name);
    const std::string file = folder.write(name, printed({"manual", name.c_str()}));
    const auto run =
        test::run_program("LC_ALL=C.UTF-8 man --warnings -l " + file + " 2>&1 >/dev/null");
    if (run.output.find("not been installed") != std::string::npos) return;  // a stand-in for man
    CHECK_EQ(run.output, "");
  }
}
