#include "firmware_link/ports/ports.h"

#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "firmware_link/ports/serial_port.h"  // SerialPort
#include "firmware_link/ports/tcp_port.h"     // TcpPort
#include "firmware_link/ports/tty_port.h"     // TtyPort
#include "firmware_link/wire/check.h"

namespace firmware_link {
namespace {

bool is_pseudo_terminal(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  return !error && real.parent_path() == "/dev/pts";
}

}  // namespace

PortError open_error(const std::string& path, int system_error) {
  const std::string cause = "cannot open " + path + ": " + std::strerror(system_error);
  switch (system_error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return {cause, "is the printer plugged in and switched on? `rind ports` lists the ports"};
    case EACCES:
    case EPERM:
      return {cause,
              "join the group that owns it: `sudo adduser $USER dialout`, then log in again"};
    case EBUSY:
      return {cause, "another program holds it: close that one (OctoPrint, a serial monitor …)"};
    default:
      return {cause, "`rind ports` lists the ports"};
  }
}

bool claim(int file) { return ::flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

OpenedPort open_port(const std::string& path, int baud) {
  LINK_CHECK(baud > 0);
  if (std::string mistake = port_name_mistake(path); !mistake.empty()) {
    return PortError{std::move(mistake), "`rind ports` lists the ports"};
  }
  if (TcpPort::names_one(path)) return TcpPort::open(path);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return open_error(path, ENOENT);
  if (is_pseudo_terminal(path)) return TtyPort::open(path);
  return SerialPort::open(path, baud);
}

std::string port_name_mistake(const std::string& path) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (path.size() > 3 && path.compare(0, 3, "COM") == 0 &&
      std::all_of(path.begin() + 3, path.end(), is_digit)) {
    return path + " is a port's name in Windows; here it is one like /dev/ttyUSB0";
  }
  if (const std::size_t scheme = path.find("://");
      scheme != std::string::npos && !TcpPort::names_one(path)) {
    return path + " is no port's name; a printer in the network is named tcp://HOST:PORT";
  }
  const bool bare = path.rfind("tty", 0) == 0 && path.find('/') == std::string::npos;
  std::error_code error;
  if (bare && !std::filesystem::exists(path, error)) {
    return path + " is named with its folder: /dev/" + path;
  }
  const std::size_t colon = path.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == path.size() ||
      path.find('/') != std::string::npos ||
      !std::all_of(path.begin() + static_cast<std::ptrdiff_t>(colon) + 1, path.end(), is_digit)) {
    return {};
  }
  return path + ": a printer in the network is named tcp://" + path;
}

std::vector<PortDescription> list_ports() { return SerialPort::list(); }

}  // namespace firmware_link
