// Offers the virtual controller to any host program: on a pseudo-terminal, a unix socket or TCP.
//
//     tools/virtual_controller --link /tmp/printer &      prints the pseudo-terminal's path
//     rind print part.stl --port /tmp/printer
//     tools/virtual_controller --list-scenarios            faults that it can simulate, by name
//     tools/virtual_controller --scenario lost-ok --seed 7 --listen 127.0.0.1:8888
//
// It starts when a host opens the port, like a board that DTR resets.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tools/faults/hostile_controller.h"

namespace {

using firmware_link::HostileController;
using firmware_link::Instant;
using firmware_link::Scenario;
using firmware_link::VirtualController;
using firmware_link::VirtualControllerOptions;
using firmware_link::VirtualDialect;

volatile std::sig_atomic_t stop_asked = 0;
void ask_to_stop(int) { stop_asked = 1; }

struct Options {
  std::string link;
  std::string socket;
  std::string listen;
  std::string log;
  bool as_sent = false;
  std::string scenario = "clean";
  VirtualDialect dialect = VirtualDialect::kMarlin;
  std::uint64_t seed = 1;
  std::size_t within_lines = 400;
  double speed = 1;
  bool once = false;
  bool keep = false;
  bool list = false;
};

Instant clock_now() {
  return Instant(std::chrono::duration_cast<firmware_link::Duration>(
      std::chrono::steady_clock::now().time_since_epoch()));
}

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "virtual_controller: %s: %s\n", what.c_str(), std::strerror(errno));
  std::exit(1);
}

// Where hosts connect: a pseudo-terminal is always the same file, a socket gives one for each host.
class Entrance {
 public:
  explicit Entrance(const Options& options) : options_(options) {
    if (!options.socket.empty()) {
      open_unix_socket();
    } else if (!options.listen.empty()) {
      open_tcp_socket();
    } else {
      open_terminal();
    }
    std::fflush(stdout);
  }

  ~Entrance() {
    if (!options_.link.empty()) ::unlink(options_.link.c_str());
    if (!options_.socket.empty()) ::unlink(options_.socket.c_str());
    ::close(file_);
  }
  Entrance(const Entrance&) = delete;
  Entrance& operator=(const Entrance&) = delete;

  // Waits for a host and returns the file to talk to it; -1 after a stop signal.
  int wait_for_host() {
    while (stop_asked == 0) {
      pollfd wait{};
      wait.fd = file_;
      wait.events = terminal_ ? POLLOUT : POLLIN;
      (void)::poll(&wait, 1, 50);
      if (terminal_) {
        // A pseudo-terminal that no host has open reports a hang-up.
        if ((wait.revents & POLLHUP) == 0) return file_;
        ::usleep(20'000);
      } else if ((wait.revents & POLLIN) != 0) {
        const int host = ::accept4(file_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
        if (host >= 0) return host;
      }
    }
    return -1;
  }

  void host_gone(int host) const {
    if (!terminal_) ::close(host);
  }

 private:
  void open_terminal() {
    terminal_ = true;
    file_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (file_ < 0 || ::grantpt(file_) != 0 || ::unlockpt(file_) != 0) fail("no pseudo-terminal");
    const std::string path = ::ptsname(file_);
    // Opened once in raw mode and closed again, so that the hang-up is reported until a host comes,
    // and so that nothing is echoed before the host has set up the terminal.
    const int slave = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (slave < 0) fail(path);
    termios settings{};
    (void)::tcgetattr(slave, &settings);
    ::cfmakeraw(&settings);
    (void)::tcsetattr(slave, TCSANOW, &settings);
    ::close(slave);
    if (!options_.link.empty()) {
      ::unlink(options_.link.c_str());
      if (::symlink(path.c_str(), options_.link.c_str()) != 0) fail(options_.link);
    }
    std::printf("%s\n", path.c_str());
  }

  void open_unix_socket() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (options_.socket.size() >= sizeof address.sun_path) fail(options_.socket);
    std::memcpy(address.sun_path, options_.socket.c_str(), options_.socket.size());
    ::unlink(options_.socket.c_str());
    file_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (file_ < 0 ||
        ::bind(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(file_, 1) != 0) {
      fail(options_.socket);
    }
    std::printf("%s\n", options_.socket.c_str());
  }

  void open_tcp_socket() {
    const std::size_t colon = options_.listen.rfind(':');
    sockaddr_in address{};
    address.sin_family = AF_INET;
    const std::string host = options_.listen.substr(0, colon);
    if (colon == std::string::npos || ::inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) {
      errno = EINVAL;
      fail("--listen wants ADDRESS:PORT, for example 127.0.0.1:0");
    }
    address.sin_port =
        htons(static_cast<std::uint16_t>(std::atoi(options_.listen.c_str() + colon + 1)));
    file_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    (void)::setsockopt(file_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    socklen_t size = sizeof address;
    if (file_ < 0 || ::bind(file_, reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
        ::listen(file_, 1) != 0 ||
        ::getsockname(file_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      fail(options_.listen);
    }
    std::printf("tcp://%s:%d\n", host.c_str(), ntohs(address.sin_port));
  }

  Options options_;
  int file_ = -1;
  bool terminal_ = false;
};

// Talks to one host until it hangs up; false after a stop signal.
class Conversation {
 public:
  Conversation(int host, const Options& options, const Scenario& scenario,
               const VirtualControllerOptions& controller)
      : host_(host),
        speed_(options.speed),
        origin_(clock_now()),
        controller_(scenario, options.seed, controller, options.within_lines, simulated_now()) {}

  // The next host finds the same controller, still running; its output in between is lost.
  void talk_to(int host) {
    host_ = host;
    begin_ = end_ = 0;
    controller_.advance(simulated_now());
    while (controller_.output(answers_, simulated_now()) > 0) controller_.advance(simulated_now());
  }

  bool run() {
    while (stop_asked == 0) {
      // An unplugged host sees a hang-up; when it comes back, the controller may have reset.
      if (!controller_.plugged(simulated_now())) return true;
      if (!write_answers() || !read_lines()) return true;
    }
    return false;
  }

  VirtualController& controller() { return controller_.controller(); }

 private:
  Instant simulated_now() const {
    const double passed = static_cast<double>((clock_now() - origin_).count()) * speed_;
    return Instant(firmware_link::Duration(static_cast<firmware_link::Duration::rep>(passed)));
  }

  bool write_answers() {
    controller_.advance(simulated_now());
    while (true) {
      if (begin_ == end_) {
        begin_ = 0;
        end_ = controller_.output(answers_, simulated_now());
        if (end_ == 0) return true;
      }
      const ssize_t count = ::write(host_, answers_.data() + begin_, end_ - begin_);
      if (count < 0) return errno == EAGAIN || errno == EINTR;
      begin_ += static_cast<std::size_t>(count);
    }
  }

  bool read_lines() {
    pollfd wait{};
    wait.fd = host_;
    wait.events = POLLIN;
    // A millisecond is often enough for the controller's own events.
    const bool busy = controller_.owes_answer() || begin_ != end_;
    if (::poll(&wait, 1, busy ? 1 : 20) <= 0) return true;
    if ((wait.revents & POLLIN) != 0) {
      std::array<std::byte, 256> bytes;
      const ssize_t count = ::read(host_, bytes.data(), bytes.size());
      if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR)) return false;
      if (count > 0) {
        const auto read = std::span(bytes).first(static_cast<std::size_t>(count));
        (void)controller_.input(read, simulated_now());
      }
      return true;
    }
    return (wait.revents & (POLLHUP | POLLERR)) == 0;
  }

  int host_;
  double speed_;
  Instant origin_;
  HostileController controller_;
  std::array<std::byte, 1024> answers_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

void print_totals(VirtualController& controller) {
  const auto& totals = controller.totals();
  std::fprintf(stderr,
               "virtual_controller: %lld commands, %lld unknown, %lld moves, %.2f mm of filament, "
               "%.1f mm of way, z up to %.3f mm, %lld resends asked, %lld bytes lost, planner ran "
               "dry %lld times\n",
               static_cast<long long>(totals.commands),
               static_cast<long long>(totals.unknown_commands),
               static_cast<long long>(totals.moves), totals.filament_mm(), totals.distance_mm,
               totals.z_mm_max, static_cast<long long>(totals.resends_asked),
               static_cast<long long>(totals.receive_bytes_lost),
               static_cast<long long>(totals.planner_underruns));
}

void list_scenarios() {
  for (const Scenario& scenario : firmware_link::scenarios()) {
    std::printf("%-22s %s\n", std::string(scenario.name).c_str(),
                std::string(scenario.what).c_str());
  }
}

// Serves one host after the other, until a stop signal.
void serve(const Options& options, const Scenario& scenario,
           const VirtualControllerOptions& controller, std::ofstream& log) {
  Entrance entrance(options);
  std::optional<Conversation> conversation;
  while (true) {
    const int host = entrance.wait_for_host();
    if (host < 0) break;
    if (conversation && options.keep) {
      conversation->talk_to(host);
    } else {
      conversation.emplace(host, options, scenario, controller);
    }
    const bool hung_up = conversation->run();
    log.flush();
    print_totals(conversation->controller());
    entrance.host_gone(host);
    if (!hung_up || options.once) break;
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A 3D printer's controller that exists only in memory, as Marlin speaks.");
  app.add_option("--link", options.link, "a symbolic link to make to the pseudo-terminal");
  app.add_option("--socket", options.socket, "serve on this unix socket instead");
  app.add_option("--listen", options.listen, "serve on this TCP ADDRESS:PORT instead");
  app.add_option("--log", options.log, "write each executed command to this file");
  app.add_flag("--as-sent", options.as_sent, "log moves in the words that came, not spelled out");
  app.add_option("--speed", options.speed, "how many times as fast as real time")
      ->check(CLI::PositiveNumber);
  const std::map<std::string, VirtualDialect> dialects = {{"marlin", VirtualDialect::kMarlin},
                                                          {"klipper", VirtualDialect::kKlipper},
                                                          {"reprap", VirtualDialect::kRepRap},
                                                          {"prusa", VirtualDialect::kPrusa}};
  app.add_option("--dialect", options.dialect, "marlin, klipper, reprap, prusa")
      ->transform(CLI::CheckedTransformer(dialects));
  app.add_option("--scenario", options.scenario, "what goes wrong; see --list-scenarios");
  app.add_option("--seed", options.seed, "the scenario's dice");
  app.add_option("--within-lines", options.within_lines, "when a mishap comes at the latest")
      ->check(CLI::PositiveNumber);
  app.add_flag("--list-scenarios", options.list, "tell what can go wrong");
  VirtualControllerOptions controller_options;
  app.add_option("--baud", controller_options.baud, "bits a second on the wire; 0: no limit");
  app.add_flag("--meatpack", controller_options.meatpack, "offer to unpack lines (MeatPack)");
  app.add_flag("--advanced-ok", controller_options.advanced_ok, "tell free slots in each ok");
  app.add_flag("--emergency-parser", controller_options.emergency_parser, "heed M112 at once");
  app.add_flag("--keep", options.keep, "not reset by a host that opens the port");
  app.add_flag("--once", options.once, "end when the first host hangs up");
  CLI11_PARSE(app, argc, argv);
  if (options.list) {
    list_scenarios();
    return 0;
  }
  const Scenario* found = firmware_link::find_scenario(options.scenario);
  if (found == nullptr) {
    std::fprintf(stderr, "virtual_controller: no scenario '%s'; --list-scenarios tells them\n",
                 options.scenario.c_str());
    return 2;
  }
  Scenario scenario = *found;
  if (scenario.name == "clean") scenario.dialect = options.dialect;
  scenario.advanced_ok = scenario.advanced_ok || controller_options.advanced_ok;
  scenario.meatpack = scenario.meatpack || controller_options.meatpack;

  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);

  std::ofstream log;
  if (!options.log.empty()) {
    log.open(options.log);
    if (!log) fail(options.log);
    controller_options.executed = [&](const firmware_link::ExecutedCommand& command) {
      log << (options.as_sent ? command.words : command.text) << '\n';
    };
  }
  serve(options, scenario, controller_options, log);
  return 0;
}
