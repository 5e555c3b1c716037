// Measures how fast a host's lines reach a controller, and planner underruns: rind's session and
// Debian's printcore, each over a pseudo-terminal to the same virtual controller, in real time.
//
//     tools/bench_link                both, on a wire of 250000 baud with 1 ms latency, and a
//                                     circle of 0.2 mm segments at 60 mm/s over 115200 baud
//
// printcore is in Debian's package printrun; without it, only rind is measured, with a message.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/ports/ports.h"
#include "firmware_link/session/link_step.h"
#include "firmware_link/virtual/virtual_controller.h"
#include "firmware_link/wire/line_codec.h"

namespace {

using namespace firmware_link;
using namespace std::chrono_literals;

// Time of an ATmega2560 for a short move: less than the wire's (firmware_link/README.md).
constexpr Duration kCommandCost = 250us;
constexpr Duration kLatency = 1ms;

constexpr const char* kPrintcore = R"(
import sys, time
from printrun.printcore import printcore
from printrun import gcoder
core = printcore(sys.argv[1], int(sys.argv[2]))
until = time.time() + 15
while not core.online and time.time() < until: time.sleep(0.05)
if not core.online: sys.exit(3)
core.startprint(gcoder.LightGCode([line.strip() for line in open(sys.argv[3])]))
while core.printing: time.sleep(0.05)
core.disconnect()
)";

Instant clock_now() {
  return Instant(
      std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

struct Result {
  bool done = false;
  double lines_s = 0;
  std::int64_t underruns = 0;
  double low_s = 0;
  std::int64_t resends = 0;
};

// Serves a pseudo-terminal with a virtual controller behind a wire, while a client runs.
class Server {
 public:
  Server(std::int64_t baud, std::size_t moves) : moves_(moves) {
    VirtualControllerOptions options;
    options.baud = baud;
    options.command_cost = kCommandCost;
    options.extrude_celsius_min = 0;
    options.executed = [this](const ExecutedCommand& command) {
      if (command.text.substr(0, 4) != "G1 X") return;
      if (count_++ == 0) first_ = command.when;
      last_ = command.when;
    };
    controller_ = std::make_unique<VirtualController>(options, clock_now());
    file_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0 || ::grantpt(file_) != 0 || ::unlockpt(file_) != 0) std::abort();
    path_ = ::ptsname(file_);
    slave_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    (void)::tcgetattr(slave_, &settings);
    ::cfmakeraw(&settings);
    (void)::tcsetattr(slave_, TCSANOW, &settings);
  }
  ~Server() {
    ::close(slave_);
    ::close(file_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  void run_until(const std::atomic<bool>& stop) {
    while (!stop) turn();
  }

  [[nodiscard]] Result result() {
    Result result;
    result.done = count_ >= moves_;
    const double seconds = std::chrono::duration<double>(last_ - first_).count();
    if (seconds > 0) result.lines_s = static_cast<double>(count_ - 1) / seconds;
    result.underruns = controller_->totals().planner_underruns;
    result.low_s = std::chrono::duration<double>(controller_->totals().planner_low).count();
    result.resends = controller_->totals().resends_asked;
    return result;
  }

 private:
  void turn() {
    const Instant now = clock_now();
    std::array<std::byte, 512> bytes;
    const ssize_t count = ::read(file_, bytes.data(), bytes.size());
    if (count > 0) {
      (void)controller_->input(std::span(bytes).first(static_cast<std::size_t>(count)), now);
    }
    controller_->advance(now);
    if (const std::size_t said = controller_->output(bytes); said > 0) {
      answers_.emplace_back(now + kLatency,
                            std::string(reinterpret_cast<const char*>(bytes.data()), said));
    }
    while (!answers_.empty() && answers_.front().first <= now) {
      const std::string& text = answers_.front().second;
      if (::write(file_, text.data(), text.size()) < 0) break;
      answers_.pop_front();
    }
    if (count <= 0) std::this_thread::sleep_for(50us);
  }

  std::size_t moves_;
  std::size_t count_ = 0;
  Instant first_{};
  Instant last_{};
  std::unique_ptr<VirtualController> controller_;
  std::deque<std::pair<Instant, std::string>> answers_;
  std::string path_;
  int file_ = -1;
  int slave_ = -1;
};

bool print_with_rind(const std::string& path, const std::vector<Command>& commands) {
  OpenedPort opened = open_port(path, 250000);
  if (!std::holds_alternative<std::unique_ptr<BytePort>>(opened)) return false;
  BytePort& port = *std::get<std::unique_ptr<BytePort>>(opened);
  Session session(std::make_unique<MarlinDialect>(), {}, clock_now());
  std::size_t next = 0;
  while (session.state() != SessionState::kFinished) {
    const Instant now = clock_now();
    while (session.can_take() && next < commands.size()) session.take(commands[next++], now);
    if (session.can_take() && next == commands.size()) session.finish(now);
    step(session, port, now, session.can_take() ? 0 : 5);
    if (session.state() == SessionState::kFaulted) {
      std::fprintf(stderr, "bench_link: %s\n", session.reason().c_str());
      return false;
    }
  }
  return true;
}

bool have_printcore() {
  return std::system("/usr/bin/python3 -c 'import printrun.printcore' >/dev/null 2>&1") == 0;
}

bool print_with_printcore(const std::string& path, const std::vector<Command>& commands) {
  const std::string file = "/tmp/bench_link_" + std::to_string(::getpid()) + ".gcode";
  {
    std::ofstream out(file);
    for (const Command& command : commands) {
      TextBuffer buffer;
      out << encode(command, buffer) << '\n';
    }
  }
  const std::string words[] = {"/usr/bin/python3", "-c", kPrintcore, path, "250000", file};
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const bool started =
      ::posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ) == 0;
  ::posix_spawn_file_actions_destroy(&actions);
  int status = 1;
  if (started) (void)::waitpid(child, &status, 0);
  ::unlink(file.c_str());
  return started && status == 0;
}

using Print = bool (*)(const std::string&, const std::vector<Command>&);

Result measure(std::int64_t baud, const std::vector<Command>& commands, std::size_t moves,
               Print print) {
  Server server(baud, moves);
  std::atomic<bool> stop = false;
  bool printed = false;
  std::thread client([&] {
    printed = print(server.path(), commands);
    stop = true;
  });
  server.run_until(stop);
  client.join();
  Result result = server.result();
  result.done = result.done && printed;
  return result;
}

// The move to the start point is not measured.
void add_start(std::vector<Command>& commands) {
  for (const char* line : {"M83", "G0 X130 Y100 F12000", "M400"}) {
    commands.emplace_back(std::get<Verbatim>(verbatim_from(line)));
  }
}

// Moves too short to become blocks, so that only the link is measured.
std::vector<Command> short_moves(std::size_t count) {
  std::vector<Command> commands;
  add_start(commands);
  for (std::size_t i = 0; i < count; ++i) {
    Move move;
    move.extruding = true;
    move.x_um = 100'000 + static_cast<std::int64_t>(i % 50);
    move.y_um = 100'000 + static_cast<std::int64_t>(i % 37);
    move.e_10nm = 1'234 + static_cast<std::int64_t>(i % 10);
    commands.emplace_back(move);
  }
  return commands;
}

std::vector<Command> circle(std::size_t segments) {
  constexpr double kRadius_mm = 30;
  constexpr double kSegment_mm = 0.2;
  std::vector<Command> commands;
  add_start(commands);
  for (std::size_t i = 0; i < segments; ++i) {
    const double angle = static_cast<double>(i) * kSegment_mm / kRadius_mm;
    Move move;
    move.extruding = true;
    move.x_um = std::llround((100 + kRadius_mm * std::cos(angle)) * 1000);
    move.y_um = std::llround((100 + kRadius_mm * std::sin(angle)) * 1000);
    move.e_10nm = 665;
    if (i == 0) move.f_mm_min = 3600;
    commands.emplace_back(move);
  }
  return commands;
}

void report(const char* what, const Result& result) {
  fmt::print(
      "  {:10} {:6.0f} lines/s, planner ran dry {} times, below half for {:.2f} s, {} "
      "resends{}\n",
      what, result.lines_s, result.underruns, result.low_s, result.resends,
      result.done ? "" : "  (did not finish)");
}

}  // namespace

int main() {
  const bool peer = have_printcore();
  if (!peer) {
    fmt::print("printcore is not here (apt-get install printrun): only rind is measured\n");
  }
  constexpr std::size_t kMoves = 4000;
  fmt::print("{} short moves at 250000 baud, 1 ms latency\n", kMoves);
  const std::vector<Command> moves = short_moves(kMoves);
  const Result ours = measure(250000, moves, kMoves, print_with_rind);
  report("rind", ours);
  if (peer) {
    const Result theirs = measure(250000, moves, kMoves, print_with_printcore);
    report("printcore", theirs);
    if (theirs.lines_s > 0) {
      fmt::print("  rind sends {:.2f} times as many\n", ours.lines_s / theirs.lines_s);
    }
  }
  constexpr std::size_t kSegments = 1885;  // twice around
  fmt::print("a circle of 0.2 mm segments at 60 mm/s (300 a second) at 115200 baud\n");
  const std::vector<Command> round = circle(kSegments);
  report("rind", measure(115200, round, kSegments, print_with_rind));
  if (peer) report("printcore", measure(115200, round, kSegments, print_with_printcore));
  return ours.done ? 0 : 1;
}
