// A TCP port against a listening socket of the test's own: the same bytes as to a pseudo-terminal.
#include "firmware_link/ports/tcp_port.h"

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/link_step.h"
#include "firmware_link/virtual/virtual_controller.h"

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

void check_open(const OpenedPort& opened) {
  if (const auto* error = std::get_if<PortError>(&opened)) FAIL(error->cause);
}

// A place that listens, and the far end of the first that comes.
struct Listener {
  int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int far = -1;
  std::string path;

  Listener() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    REQUIRE(::bind(file, reinterpret_cast<const sockaddr*>(&address), size) == 0);
    REQUIRE(::listen(file, 1) == 0);
    REQUIRE(::getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) == 0);
    path = "tcp://127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }
  ~Listener() {
    if (far >= 0) ::close(far);
    ::close(file);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  void accept() {
    far = ::accept4(file, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    REQUIRE(far >= 0);
  }
};

// A pseudo-terminal, and its far end.
struct Terminal {
  int far = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::string path;
  Terminal() {
    REQUIRE(::grantpt(far) == 0);
    REQUIRE(::unlockpt(far) == 0);
    path = ::ptsname(far);
  }
  ~Terminal() { ::close(far); }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
};

// Prints some moves over the port to a controller at the far end, and returns what came there.
std::string bytes_sent(BytePort& port, int far) {
  Instant now{};
  VirtualController controller({}, now);
  Session session(std::make_unique<MarlinDialect>(), {}, now);
  std::string heard;
  std::array<std::byte, 512> bytes;
  int next = 0;
  for (int turn = 0; turn < 3000 && session.state() != SessionState::kFinished; ++turn) {
    while (const std::size_t count = controller.output(bytes)) {
      REQUIRE(::write(far, bytes.data(), count) == static_cast<ssize_t>(count));
    }
    while (session.can_take() && next < 40) {
      Move move;
      move.x_um = 1000 * ++next;
      session.take(move, now);
    }
    if (session.can_take()) session.finish(now);
    step(session, port, now, 1);
    const ssize_t count = ::read(far, bytes.data(), bytes.size());
    if (count > 0) {
      const auto read = std::span(bytes).first(static_cast<std::size_t>(count));
      heard.append(reinterpret_cast<const char*>(read.data()), read.size());
      (void)controller.input(read, now);
    }
    now += 5ms;
    controller.advance(now);
  }
  CHECK(session.state() == SessionState::kFinished);
  return heard;
}

}  // namespace

TEST_CASE("a print over TCP sends the same bytes as over a pseudo-terminal") {
  Listener listener;
  OpenedPort tcp = open_port(listener.path, 115200);
  check_open(tcp);
  listener.accept();
  const std::string over_tcp = bytes_sent(*std::get<std::unique_ptr<BytePort>>(tcp), listener.far);
  Terminal terminal;
  OpenedPort tty = open_port(terminal.path, 115200);
  check_open(tty);
  const std::string over_tty = bytes_sent(*std::get<std::unique_ptr<BytePort>>(tty), terminal.far);
  CHECK(over_tcp.find("G0X40*") != std::string::npos);
  CHECK(over_tcp == over_tty);
}

TEST_CASE("a far end that hangs up is a lost port") {
  Listener listener;
  OpenedPort opened = open_port(listener.path, 115200);
  check_open(opened);
  BytePort& port = *std::get<std::unique_ptr<BytePort>>(opened);
  listener.accept();
  std::array<std::byte, 16> bytes;
  CHECK(port.read(bytes, 0) == 0);
  CHECK(port.state() == PortState::kOpen);
  CHECK_FALSE(port.reset_device());
  ::close(listener.far);
  listener.far = -1;
  CHECK(port.read(bytes, 1000) == 0);
  CHECK(port.state() == PortState::kLost);
  CHECK(port.write(bytes) == 0);
}

TEST_CASE("what is no address, nobody's address, or nobody listening is told with a remedy") {
  const std::string closed = [] {
    Listener listener;
    return listener.path;
  }();
  for (const std::string& path :
       {std::string("tcp://"), std::string("tcp://host"), std::string("tcp://host:"),
        std::string("tcp://:23"), std::string("tcp://host:a1"), closed}) {
    CAPTURE(path);
    const OpenedPort opened = open_port(path, 115200);
    const auto* error = std::get_if<PortError>(&opened);
    REQUIRE(error != nullptr);
    CHECK_FALSE(error->cause.empty());
    CHECK_FALSE(error->remedy.empty());
  }
}
