// Commands in a random order, two at a time, with random names, some of them ended by a signal:
// what was there and is not an output's to replace is never changed, and an output is whole or the
// older one.
//
// RIND_FILE_STEPS=2000 tries more, RIND_FILE_SEED another order.
#include <doctest/doctest.h>
#include <signal.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "host/printing/journal.h"
#include "tests/support/part_folder.h"
#include "tests/support/random_regions.h"
#include "tests/support/run_program.h"
#include "tests/support/running_program.h"

namespace fs = std::filesystem;
using test::content;
using test::kRind;
using test::PartFolder;
using test::Random;
using test::RunningProgram;

namespace {

const std::vector<std::string> kCoarse = {"--quiet", "--layer-height", "0.4", "--wall-thickness",
                                          "0.8"};

using Files = std::map<std::string, std::string>;  // content by name; a link's is its target's

Files files_in(const PartFolder& folder) {
  Files files;
  for (const auto& entry : fs::directory_iterator(folder.file(""))) {
    files[entry.path().filename().string()] = content(entry.path().string());
  }
  return files;
}

std::int64_t setting(const char* name, std::int64_t otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::atoll(value) : otherwise;
}

// What a command may do to a name: give it one of these contents, or more of what it has.
struct Effect {
  std::vector<std::string> contents;
  bool statistics = false;
  bool grows = false;
  bool journal = false;  // it comes, and goes when the print is done
  bool resumes = false;
  bool anew = false;
};

struct Command {
  std::vector<std::string> words;
  std::map<std::string, Effect> effects;
};

class World {
 public:
  explicit World(std::uint64_t seed) : random_(seed) {
    std::ostringstream box, demo;
    parts::write_binary_stl(parts::box({1, 1, 0}, 8, 6, 4), box);
    parts::write_ascii_stl(parts::box({1, 1, 0}, 5, 5, 3), demo);
    for (const auto& [name, text] :
         {std::pair<std::string, std::string>{"a.stl", box.str()},
          {"b.stl", demo.str()},
          {"spare.stl", box.str()},
          {"mesh.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n"},
          {"photo.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)},
          {"own.ini", "layer_height = 0.4\n"}}) {
      (void)folder_.add_text(name, text);
      precious_[name] = text;
    }
    (void)folder_.add_text("old.gcode", "; by another program\nG28\n");
    (void)folder_.add_text("old.json", "{}\n");
    fs::create_symlink("old.gcode", folder_.file("link.gcode"));
    fs::create_symlink("a.stl", folder_.file("part.gcode"));
    precious_["part.gcode"] = precious_["a.stl"];
    names_ = {"a.stl",     "b.stl",   "spare.stl", "mesh.obj",   "photo.png",  "own.ini",
              "old.gcode", "x.json",  "y.gcode",   "link.gcode", "part.gcode", "old.json",
              "z.gcode",   "run.log", "w.cli",     "cut.svg",    "run.1.log"};
    for (const char* part : {"a.stl", "b.stl"}) {
      for (const char* format : {"gcode", "cli"}) {
        expected_[std::string(part) + format] = sliced(part, format);
      }
    }
  }

  void step() {
    const Files before = files_in(folder_);
    std::vector<Command> commands{command()};
    if (random_.integer(0, 1) == 0) commands.push_back(command());
    run(commands);
    const Files after = files_in(folder_);
    for (const Command& each : commands) {
      std::string text;
      for (const std::string& word : each.words) text += word + " ";
      said_ += text + "\n";
    }
    CAPTURE(said_);
    for (const auto& entry : before) {
      const std::string &name = entry.first, &text = entry.second;
      CAPTURE(name);
      if (is_journal(text)) {
        check_journal(name, text, after, commands);
        continue;
      }
      REQUIRE_MESSAGE(after.contains(name), "a file is gone");
      if (after.at(name) != text) check_changed(name, text, after.at(name), commands);
    }
    for (const auto& entry : after) {
      const std::string &name = entry.first, &text = entry.second;
      CAPTURE(name);
      if (!before.contains(name)) check_changed(name, "", text, commands);
    }
    CHECK(fs::is_symlink(folder_.file("link.gcode")));
    CHECK(fs::is_symlink(folder_.file("part.gcode")));
    said_.clear();
  }

 private:
  std::string sliced(const std::string& part, const std::string& format) {
    const PartFolder apart;
    const std::string out = apart.file("out");
    std::vector<std::string> words{kRind,      "slice", folder_.file(part), "-o", out,
                                   "--format", format};
    words.insert(words.end(), kCoarse.begin(), kCoarse.end());
    REQUIRE_EQ(RunningProgram(words).end(60), 0);
    return content(out);
  }

  std::string pick(const std::vector<std::string>& words) {
    return words[static_cast<std::size_t>(random_.integer(0, static_cast<int>(words.size()) - 1))];
  }

  // Nothing is known of what links stand for but here.
  static std::string real(const std::string& name) {
    if (name == "link.gcode") return "old.gcode";
    if (name == "part.gcode") return "a.stl";
    return name;
  }

  void write(Command& command, const char* option, const std::string& name, const Effect& effect) {
    command.words.insert(command.words.end(), {option, folder_.file(name)});
    command.effects[name] = command.effects[real(name)] = effect;
    if (real(name) == "old.gcode") command.effects["link.gcode"] = effect;
  }

  Command command() {
    if (random_.integer(0, 6) == 0) return resume();
    Command command;
    const std::string part = pick({"a.stl", "a.stl", "b.stl", "photo.png", "part.gcode"});
    const std::string kind = pick({"slice", "slice", "slice", "plan", "show", "print"});
    command.words = {kRind, kind, folder_.file(part)};
    command.words.insert(command.words.end(), kCoarse.begin(), kCoarse.end());
    if (kind == "slice") {
      const std::string format = pick({"gcode", "cli"});
      const auto whole = expected_.find(real(part) + format);
      write(command, "-o", pick(names_),
            {whole == expected_.end() ? std::vector<std::string>{}
                                      : std::vector<std::string>{whole->second}});
      command.words.insert(command.words.end(), {"--format", format});
    }
    if (kind == "show") {
      const std::string name = pick({"cut.svg", "x.json", "a.stl", "mesh.obj", "part.gcode"});
      write(command, "-o", name, {{"<svg"}});
      command.words.insert(command.words.end(), {"--layer", "2"});
    }
    if (kind == "print") {
      command.words.insert(command.words.end(), {"--port", "virtual", "--virtual-speed", "0"});
    }
    Effect statistics, log;
    statistics.statistics = log.grows = true;
    if (random_.integer(0, 1) == 0) write(command, "--stats", pick(names_), statistics);
    if (random_.integer(0, 2) == 0) write(command, "--log", pick(names_), log);
    if (kind == "print" && random_.integer(0, 3) > 0) add_journal(command);
    if (random_.integer(0, 2) == 0) {
      command.words.insert(command.words.end(), {"--profile", folder_.file("own.ini")});
    }
    return command;
  }

  void add_journal(Command& command) {
    Effect journal;
    journal.journal = true;
    journal.anew = random_.integer(0, 1) == 0;
    const std::string name = pick({"j1", "j1", "j1", "j2", "a.stl", "photo.png", "old.json",
                                   "x.json", "link.gcode", "run.log"});
    write(command, "--journal", name, journal);
    if (!journal.anew) return;
    command.words.emplace_back("--anew");
    command.effects[name + ".old"] = journal;
  }

  Command resume() {
    Command command;
    const std::string name = pick({"j1", "j1", "j2", "a.stl", "x.json"});
    command.words = {kRind,    "resume",  folder_.file(name), "--yes", "--quiet",
                     "--port", "virtual", "--virtual-speed",  "0"};
    command.effects[name].resumes = true;
    Effect statistics;
    statistics.statistics = true;
    if (random_.integer(0, 1) == 0) write(command, "--stats", pick(names_), statistics);
    return command;
  }

  // At once; each may be ended in the middle.
  void run(const std::vector<Command>& commands) {
    killed_ = false;
    std::vector<std::unique_ptr<RunningProgram>> programs;
    for (const Command& command : commands) {
      programs.push_back(std::make_unique<RunningProgram>(command.words));
    }
    for (const auto& program : programs) {
      const int chance = random_.integer(0, 5);
      if (chance > 1) continue;
      killed_ |= chance == 0;
      RunningProgram::pause(random_.between(0, 0.06));
      program->tell(chance == 0 ? SIGKILL : SIGTERM);
    }
    for (const auto& program : programs) {
      const std::optional<int> code = program->end(60);
      REQUIRE(code.has_value());
      const bool known = *code == 0 || (*code >= 2 && *code <= 5);
      const bool killed = *code == 128 + SIGKILL || *code == 128 + SIGTERM;
      REQUIRE_MESSAGE((known || killed), program->said());
    }
  }

  // One from which a print can be gone on with: it is so afterwards, or was gone on with, or was
  // set aside because that was asked for.
  static void check_journal(const std::string& name, const std::string& before, const Files& after,
                            const std::vector<Command>& commands) {
    if (after.contains(name) && after.at(name) == before) return;
    if (!host::read_journal_bytes(before, name).ok()) return;
    bool explained = false;
    for (const Command& command : commands) {
      const auto effect = command.effects.find(name);
      if (effect == command.effects.end()) continue;
      explained |= effect->second.resumes;
      if (!effect->second.anew) continue;
      const auto aside = after.find(name + ".old");
      explained |= aside != after.end() && aside->second == before;
      // An older one that was set aside makes room.
      explained |= name.ends_with(".old");
    }
    REQUIRE_MESSAGE(explained, "a print that was cut is lost");
  }

  static bool contains(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
  }

  static bool is_journal(const std::string& text) { return text.rfind("rind journal ", 0) == 0; }

  void check_changed(const std::string& name, const std::string& before, const std::string& after,
                     const std::vector<Command>& commands) const {
    REQUIRE_MESSAGE(!precious_.contains(name), "what is no output was changed");
    bool explained = false;
    const bool killed_early = name.rfind(".rind-", 0) == 0 || contains(name, ".partial-");
    if (killed_ && killed_early && before.empty()) return;
    for (const Command& command : commands) {
      const auto effect = command.effects.find(name);
      if (effect == command.effects.end()) continue;
      explained |= effect->second.journal && before.empty() && is_journal(after);
      if (effect->second.statistics) explained |= nlohmann::json::accept(after);
      if (effect->second.grows) explained |= after.rfind(before, 0) == 0;
      for (const std::string& whole : effect->second.contents) {
        explained |= after == whole || (whole == "<svg" && after.ends_with("</svg>\n"));
      }
    }
    CAPTURE(before.size());
    CAPTURE(after.size());
    REQUIRE_MESSAGE(explained, "no command says that this file may have become so");
  }

  Random random_;
  PartFolder folder_;
  Files precious_;
  std::vector<std::string> names_;
  std::map<std::string, std::string> expected_;
  std::string said_;
  bool killed_ = false;  // by SIGKILL, in this step
};

}  // namespace

TEST_CASE("commands in any order destroy no file that was there") {
  const auto seed = static_cast<std::uint64_t>(setting("RIND_FILE_SEED", 11));
  const std::int64_t steps = setting("RIND_FILE_STEPS", 60);
  CAPTURE(seed);
  World world(seed);
  for (std::int64_t step = 0; step < steps; ++step) {
    CAPTURE(step);
    world.step();
  }
  MESSAGE("seed " << seed << ", " << steps << " steps");
}
