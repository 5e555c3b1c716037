#include "firmware_link/ports/tcp_port.h"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace firmware_link {
namespace {

constexpr std::string_view kScheme = "tcp://";

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

struct Address {
  std::string host;
  std::string port;
};

// "tcp://host:port", "tcp://[::1]:port"; empty parts when it is neither.
Address address_in(std::string_view path) {
  path.remove_prefix(kScheme.size());
  while (!path.empty() && path.back() == '/') path.remove_suffix(1);
  const std::size_t colon = path.rfind(':');
  if (colon == std::string_view::npos) return {};
  std::string_view host = path.substr(0, colon);
  if (host.size() >= 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
  }
  const std::string_view port = path.substr(colon + 1);
  const bool digits =
      !port.empty() && port.size() <= 5 &&
      std::all_of(port.begin(), port.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (host.empty() || !digits) return {};
  return {std::string(host), std::string(port)};
}

// Connects in bounded time; the file, or -1 with errno set.
int connected(const addrinfo& address) {
  const int file = ::socket(address.ai_family, address.ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK,
                            address.ai_protocol);
  if (file < 0) return -1;
  int error = 0;
  if (::connect(file, address.ai_addr, address.ai_addrlen) != 0) {
    error = errno;
    if (error == EINPROGRESS) {
      pollfd wait{};
      wait.fd = file;
      wait.events = POLLOUT;
      socklen_t size = sizeof error;
      if (::poll(&wait, 1, kConnectLimit_ms) <= 0) {
        error = ETIMEDOUT;
      } else if (::getsockopt(file, SOL_SOCKET, SO_ERROR, &error, &size) != 0) {
        error = errno;
      }
    }
  }
  if (error == 0) return file;
  ::close(file);
  errno = error;
  return -1;
}

}  // namespace

bool TcpPort::names_one(std::string_view path) { return path.substr(0, kScheme.size()) == kScheme; }

std::variant<std::unique_ptr<BytePort>, PortError> TcpPort::open(const std::string& path) {
  const Address address = address_in(path);
  if (address.host.empty()) {
    return PortError{"cannot read " + path, "write it as tcp://HOST:PORT, port 23 or 8888 mostly"};
  }
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &wanted, &found);
      error != 0) {
    return PortError{"cannot find " + address.host + ": " + ::gai_strerror(error),
                     "is the name right, and the network there?"};
  }
  int file = -1;
  int why = 0;
  for (const addrinfo* each = found; each != nullptr && file < 0; each = each->ai_next) {
    file = connected(*each);
    if (file < 0) why = errno;
  }
  ::freeaddrinfo(found);
  if (file < 0) {
    return PortError{"cannot connect to " + path + ": " + std::strerror(why),
                     "is the printer on, and does it listen there? Some serve one host at a time"};
  }
  const int yes = 1;
  (void)::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  (void)::setsockopt(file, SOL_SOCKET, SO_KEEPALIVE, &yes, sizeof yes);
  return std::unique_ptr<BytePort>(new TcpPort(file));
}

TcpPort::~TcpPort() { ::close(file_); }

std::size_t TcpPort::write(std::span<const std::byte> bytes) {
  if (state_ == PortState::kLost || bytes.empty()) return 0;
  const ssize_t count = ::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (count >= 0) return static_cast<std::size_t>(count);
  if (!would_block()) state_ = PortState::kLost;
  return 0;
}

std::size_t TcpPort::read(std::span<std::byte> into, int timeout_ms) {
  if (state_ == PortState::kLost || into.empty()) return 0;
  pollfd wait{};
  wait.fd = file_;
  wait.events = POLLIN;
  if (::poll(&wait, 1, std::max(0, timeout_ms)) <= 0) return 0;
  const ssize_t count = ::recv(file_, into.data(), into.size(), 0);
  if (count > 0) return static_cast<std::size_t>(count);
  if (count == 0 || !would_block()) state_ = PortState::kLost;
  return 0;
}

}  // namespace firmware_link
