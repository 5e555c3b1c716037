// Ports on pseudo-terminals, and the virtual controller behind a port. The serial port itself is
// proven by tools/test_uart.
#include "firmware_link/ports/ports.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <string>

#include "firmware_link/dialects/marlin_dialect.h"
#include "firmware_link/session/link_step.h"
#include "firmware_link/virtual/virtual_port.h"

using namespace firmware_link;
using namespace std::chrono_literals;

namespace {

// The far end of a pseudo-terminal.
struct FarEnd {
  int file = ::posix_openpt(O_RDWR | O_NOCTTY);
  std::string path;

  FarEnd() {
    REQUIRE(file >= 0);
    REQUIRE(::grantpt(file) == 0);
    REQUIRE(::unlockpt(file) == 0);
    path = ::ptsname(file);
  }
  ~FarEnd() { hang_up(); }
  void hang_up() {
    if (file >= 0) ::close(file);
    file = -1;
  }
  void say(const std::string& text) const {
    REQUIRE(::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  }
  std::string hear(std::size_t size) const {
    std::string text(size, '\0');
    std::size_t at = 0;
    while (at < size) {
      const ssize_t count = ::read(file, text.data() + at, size - at);
      REQUIRE(count > 0);
      at += static_cast<std::size_t>(count);
    }
    return text;
  }
};

std::unique_ptr<BytePort> opened(const std::string& path) {
  OpenedPort port = open_port(path, 115200);
  REQUIRE(std::holds_alternative<std::unique_ptr<BytePort>>(port));
  return std::move(std::get<std::unique_ptr<BytePort>>(port));
}

PortError refused(const std::string& path) {
  OpenedPort port = open_port(path, 115200);
  REQUIRE(std::holds_alternative<PortError>(port));
  return std::get<PortError>(port);
}

std::string read_text(BytePort& port) {
  std::array<std::byte, 64> bytes;
  const std::size_t count = port.read(bytes, 1000);
  return {reinterpret_cast<const char*>(bytes.data()), count};
}

PortClock still_clock(Instant& now) {
  return {[&now] { return now; }, [&now](Duration duration) { now += duration; }};
}

}  // namespace

TEST_CASE("a pseudo-terminal carries every byte as it is, both ways") {
  FarEnd far;
  const auto port = opened(far.path);
  std::string text;
  for (int i = 0; i < 256; ++i) text.push_back(static_cast<char>(i));
  CHECK(port->write(std::as_bytes(std::span(text.data(), text.size()))) == 256);
  CHECK(far.hear(256) == text);
  far.say("ok\r\n\x03");
  CHECK(read_text(*port) == "ok\r\n\x03");
  CHECK(port->state() == PortState::kOpen);
}

TEST_CASE("a link to a pseudo-terminal is one too") {
  FarEnd far;
  const auto link =
      std::filesystem::temp_directory_path() / ("rind_port_" + std::to_string(::getpid()));
  std::filesystem::create_symlink(far.path, link);
  const auto port = opened(link.string());
  far.say("x");
  CHECK(read_text(*port) == "x");
  std::filesystem::remove(link);
}

TEST_CASE("a port that another program prints on is refused, and free when that one has ended") {
  const FarEnd far_end;
  {
    const auto first = opened(far_end.path);
    OpenedPort second = open_port(far_end.path, 115200);
    REQUIRE(std::holds_alternative<PortError>(second));
    CHECK(std::get<PortError>(second).remedy.find("another program") != std::string::npos);
    CHECK(first->state() == PortState::kOpen);
  }
  CHECK(opened(far_end.path)->state() == PortState::kOpen);
}

TEST_CASE("a hang-up is a lost port, and stays so") {
  FarEnd far;
  const auto port = opened(far.path);
  far.hang_up();
  CHECK(read_text(*port).empty());
  CHECK(port->state() == PortState::kLost);
  CHECK(port->write(std::as_bytes(std::span("x", 1))) == 0);
  CHECK(read_text(*port).empty());
}

TEST_CASE("a full terminal takes what fits, and no call waits") {
  FarEnd far;
  const auto port = opened(far.path);
  const std::string text(1000, 'x');
  std::size_t taken = 0;
  std::size_t last = 1;
  for (int i = 0; i < 1000 && last > 0; ++i) {
    last = port->write(std::as_bytes(std::span(text.data(), text.size())));
    taken += last;
  }
  CHECK(last == 0);
  CHECK(taken > 1000);
  CHECK(port->state() == PortState::kOpen);
}

TEST_CASE("what is no port is told with cause and remedy") {
  const PortError missing = refused("/dev/no_such_port");
  CHECK(missing.cause == "cannot open /dev/no_such_port: No such file or directory");
  CHECK(missing.remedy.find("rind ports") != std::string::npos);
  for (const char* path : {"/dev/null", "/tmp", "/proc/self/exe"}) {
    CAPTURE(path);
    const PortError error = refused(path);
    CHECK(error.cause.find(path) != std::string::npos);
    CHECK_FALSE(error.remedy.empty());
  }
  (void)list_ports();
}

TEST_CASE("a session over a pseudo-terminal ends when the far end does") {
  FarEnd far;
  const auto port = opened(far.path);
  Session session(std::make_unique<MarlinDialect>(), {}, Instant{});
  far.say("start\n");
  step(session, *port, Instant{}, 10);
  CHECK(session.state() == SessionState::kConnecting);
  far.hang_up();
  step(session, *port, Instant{}, 10);
  CHECK(session.state() == SessionState::kFaulted);
  CHECK(session.reason().find("lost") != std::string::npos);
}

TEST_CASE("the virtual port prints as fast as it can: an hour takes no time") {
  Instant now{};
  VirtualPort port({}, still_clock(now), 0);
  Session session(std::make_unique<MarlinDialect>(), {}, now);
  const char* const lines[] = {"G28", "M190 S60", "M109 S210", "G1 X100 F1", "M400", "G4 S1000"};
  std::size_t next = 0;
  for (int turn = 0; turn < 20000 && session.state() != SessionState::kFinished; ++turn) {
    while (session.can_take() && next < std::size(lines)) {
      session.take(std::get<Verbatim>(verbatim_from(lines[next++])), now);
    }
    if (session.can_take()) session.finish(now);
    step(session, port, now, 5);
    now += 1ms;
  }
  CHECK(session.state() == SessionState::kFinished);
  CHECK(now < Instant(20s));
  CHECK(port.simulated_now() > Instant(3000s));
  CHECK(port.controller().state().x_mm == 100);
}

TEST_CASE("the virtual port's time runs as many times as fast as asked") {
  Instant now{};
  VirtualPort port({}, still_clock(now), 10);
  const std::string text = "G4 S10\n";
  while (!read_text(port).empty()) {
  }
  const Instant before = now;
  CHECK(port.write(std::as_bytes(std::span(text.data(), text.size()))) == text.size());
  std::string heard;
  while (heard.find("ok\n") == std::string::npos && now < before + 5s) heard += read_text(port);
  CHECK(now - before >= 1s);
  CHECK(now - before <= 1100ms);
}

TEST_CASE("a port's name that is none here is told before it is opened") {
  using firmware_link::port_name_mistake;
  CHECK(port_name_mistake("COM3").find("Windows") != std::string::npos);
  CHECK(port_name_mistake("ttyUSB0").find("/dev/ttyUSB0") != std::string::npos);
  CHECK(port_name_mistake("http://printer").find("tcp://HOST:PORT") != std::string::npos);
  CHECK(port_name_mistake("tcp://printer:23").empty());
  CHECK(port_name_mistake("192.168.1.5:23") ==
        "192.168.1.5:23: a printer in the network is named tcp://192.168.1.5:23");
  CHECK(port_name_mistake("printer.local:8888").find("tcp://printer.local:8888") !=
        std::string::npos);
  for (const char* fine : {"/dev/ttyUSB0", "tcp://192.168.1.5:23", "virtual", "COMMON", "a:b",
                           "/dev/serial/by-path/pci-0000:00:14.0-usb-0:1:1.0-port0"}) {
    CHECK(port_name_mistake(fine).empty());
  }
}
