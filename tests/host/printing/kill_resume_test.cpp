// The program itself, killed in mid-print (SIGKILL) and resumed: what a controller executed in all
// is what the whole print says, each road once.
//
// RIND_KILLS=50 kills more often than the few times that fit into every run.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/laid_roads.h"
#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

using test::LaidPiece;
using test::run_program;

namespace {

const std::string kBinaries = RIND_BINARY_DIR;

// A program that runs beside the test, its standard output to be read.
class Program {
 public:
  explicit Program(const std::vector<std::string>& words) {
    std::array<int, 2> ends{};
    REQUIRE_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    REQUIRE_EQ(::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ),
               0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_ = ends[0];
  }
  ~Program() {
    end(SIGKILL);
    ::close(output_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // Waits until that was said; false when the program ended before.
  bool wait_for(const std::string& words) {
    while (said_.find(words) == std::string::npos) {
      std::array<char, 4'096> bytes{};
      const ssize_t count = ::read(output_, bytes.data(), bytes.size());
      if (count <= 0) return false;
      said_.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return true;
  }

  void end(int signal) {
    if (process_ <= 0) return;
    ::kill(process_, signal);
    (void)::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
  int output_ = -1;
  std::string said_;
};

std::vector<LaidPiece> laid_in(const std::string& path) {
  std::ifstream file(path);
  test::RoadTracer tracer;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == ';') continue;
    tracer.execute(line);
  }
  return tracer.laid();
}

bool lays_the_same(const std::vector<LaidPiece>& laid, const std::vector<LaidPiece>& whole) {
  INFO("laid " << laid.size() << " pieces of " << whole.size());
  for (std::size_t i = 0; i < std::min(laid.size(), whole.size()); ++i) {
    CAPTURE(i);
    if (!(laid[i] == whole[i])) {
      FAIL_CHECK("another piece of road");
      return false;
    }
  }
  CHECK_EQ(laid.size(), whole.size());
  return laid.size() == whole.size();
}

int kills_wanted() {
  const char* told = std::getenv("RIND_KILLS");
  return told != nullptr ? std::atoi(told) : 1;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

TEST_CASE("a print that is killed is resumed, every road once") {
  const test::PartFolder parts_folder;
  const test::TemporaryFolder folder;
  const std::string part = parts_folder.add(
      "part.stl", parts::together({parts::box({8, 8, 0}, 14, 10, 6), parts::tube(7, 5, 6, 180)}));
  const std::vector<std::string> settings = {"--layer-height", "0.3",   "--set",
                                             "bed_x=200",      "--set", "bed_y=200"};
  // The controller draws arcs; a file has them if they are asked for.
  std::string typed = " --set arcs=on";
  for (const std::string& word : settings) typed += " " + word;
  REQUIRE_EQ(run_program(kBinaries + "/rind slice " + part + " -o " + folder.path("whole.gcode") +
                         " --quiet" + typed)
                 .exit_code,
             0);
  const std::vector<LaidPiece> whole = laid_in(folder.path("whole.gcode"));
  REQUIRE_GT(whole.size(), 500);

  const std::uint64_t seed = std::random_device()();
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < kills_wanted(); ++i) {
    CAPTURE(i);
    const std::string port = folder.path("printer" + std::to_string(i));
    const std::string log = folder.path("executed" + std::to_string(i));
    const std::string journal = folder.path("journal" + std::to_string(i));
    Program controller({kBinaries + "/tools/virtual_controller", "--keep", "--link", port, "--log",
                        log, "--speed", "300"});
    REQUIRE(controller.wait_for("\n"));
    {
      std::vector<std::string> words = {kBinaries + "/rind", "print", part,    "--port", port,
                                        "--journal",         journal, "--json"};
      words.insert(words.end(), settings.begin(), settings.end());
      Program print(words);
      const std::string layer = std::to_string(2 + random() % 10);
      REQUIRE(print.wait_for("\"event\":\"layer\",\"layer\":" + layer + ","));
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 30));
      print.end(SIGKILL);
    }
    if (!std::filesystem::exists(journal)) {  // on a quick machine it was done before
      controller.end(SIGTERM);
      CHECK(lays_the_same(laid_in(log), whole));
      continue;
    }
    const test::ProgramRun resumed =
        run_program("timeout 60 " + kBinaries + "/rind resume " + journal + " --yes");
    CAPTURE(resumed.output);
    REQUIRE_EQ(resumed.exit_code, 0);
    controller.end(SIGTERM);
    const bool same = lays_the_same(laid_in(log), whole);
    REQUIRE(same);
  }
}

TEST_CASE("a print that was cut is neither overwritten nor lost") {
  const test::PartFolder parts_folder;
  const test::TemporaryFolder folder;
  REQUIRE_EQ(::setenv("XDG_STATE_HOME", folder.path("state").c_str(), 1), 0);
  const std::string part = parts_folder.add("cut.stl", parts::box({8, 8, 0}, 14, 10, 6));
  const std::string state = folder.path("state/rind");
  const std::string rind = kBinaries + "/rind ";
  const std::string port = folder.path("printer");
  const auto journals = [&state](const std::string& ending) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(state)) {
      const std::string path = entry.path().string();
      if (path.size() > ending.size() &&
          path.compare(path.size() - ending.size(), ending.size(), ending) == 0) {
        paths.push_back(path);
      }
    }
    return paths;
  };
  const auto cut = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {
        kBinaries + "/rind", "print", part,        "--port", port, "--set",
        "bed_x=300",         "--set", "bed_y=300", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    Program print(words);
    REQUIRE(print.wait_for("\"event\":\"layer\",\"layer\":6,"));
    print.end(SIGKILL);
  };

  const std::string bed = " --set bed_x=300 --set bed_y=300";
  CHECK_EQ(run_program(rind + "print " + part + bed + " --port " + port).exit_code, 4);
  CHECK_FALSE(std::filesystem::exists(state));  // a failed start leaves nothing behind

  Program controller(
      {kBinaries + "/tools/virtual_controller", "--keep", "--link", port, "--speed", "100"});
  REQUIRE(controller.wait_for("\n"));
  cut({});
  REQUIRE_EQ(journals(".journal").size(), 1);
  const std::string journal = journals(".journal").front();
  const std::string left = bytes_of(journal);
  const std::string again = "timeout 60 " + rind + "print " + part + bed + " --port " + port;
  const test::ProgramRun refused = run_program(again + " < /dev/null");
  CAPTURE(refused.output);
  CHECK_EQ(refused.exit_code, 2);
  CHECK_NE(refused.output.find("--anew"), std::string::npos);
  CHECK_NE(refused.output.find(journal), std::string::npos);
  CHECK_EQ(bytes_of(journal), left);
  const std::string list = run_program(rind + "resume").output;
  CHECK_NE(list.find("cut.stl: layer "), std::string::npos);
  CHECK_NE(list.find("(unchanged)"), std::string::npos);

  // Not even with --anew, as long as the printer does not answer.
  CHECK_EQ(
      run_program(rind + "print " + part + bed + " --anew --port " + folder.path("no")).exit_code,
      4);
  CHECK_EQ(bytes_of(journal), left);
  cut({"--anew"});
  REQUIRE_EQ(journals(".old").size(), 1);
  CHECK_EQ(bytes_of(journals(".old").front()), left);

  const test::ProgramRun resumed =
      run_program("timeout 60 " + rind + "resume cut.stl --yes --set bed_x=200 --set bed_y=200");
  CAPTURE(resumed.output);
  CHECK_EQ(resumed.exit_code, 0);
  CHECK(journals(".journal").empty());
  CHECK_EQ(journals(".old").size(), 1);
  CHECK_EQ(run_program(rind + "resume nothing.stl").exit_code, 2);
  CHECK_EQ(run_program(again + " --journal " + part).exit_code, 3);
  CHECK(std::filesystem::exists(part));
}
