#include "firmware_link/ports/tty_port.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace firmware_link {
namespace {

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

std::variant<std::unique_ptr<BytePort>, PortError> TtyPort::open(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return open_error(path, errno);
  std::unique_ptr<BytePort> port(new TtyPort(file));
  termios settings{};
  if (::tcgetattr(file, &settings) != 0) {
    return PortError{path + " is not a terminal", "name a serial device or a pseudo-terminal"};
  }
  if (!claim(file)) return open_error(path, EBUSY);
  ::cfmakeraw(&settings);
  if (::tcsetattr(file, TCSANOW, &settings) != 0) return open_error(path, errno);
  return port;
}

TtyPort::~TtyPort() { ::close(file_); }

std::size_t TtyPort::write(std::span<const std::byte> bytes) {
  if (state_ == PortState::kLost || bytes.empty()) return 0;
  const ssize_t count = ::write(file_, bytes.data(), bytes.size());
  if (count >= 0) return static_cast<std::size_t>(count);
  if (!would_block()) state_ = PortState::kLost;
  return 0;
}

std::size_t TtyPort::read(std::span<std::byte> into, int timeout_ms) {
  if (state_ == PortState::kLost || into.empty()) return 0;
  pollfd wait{};
  wait.fd = file_;
  wait.events = POLLIN;
  if (::poll(&wait, 1, timeout_ms) <= 0) return 0;
  const ssize_t count = ::read(file_, into.data(), into.size());
  if (count > 0) return static_cast<std::size_t>(count);
  // The other side has closed: end of file, or EIO on Linux.
  if (count == 0 || !would_block()) state_ = PortState::kLost;
  return 0;
}

}  // namespace firmware_link
