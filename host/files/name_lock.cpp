#include "host/files/name_lock.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <utility>

#include "host/files/content_hash.h"  // hash_of

namespace host {

core::Result<NameLock> NameLock::take(const OutputTarget& target, const std::string& path) {
  const int descriptor = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return NameLock();
  NameLock lock(descriptor);
  // A leading zero makes the name abstract: no file is created.
  const std::string name =
      fmt::format("{}rind-output-{:x}-{:x}-{:x}", '\0', target.folder_identity.device,
                  target.folder_identity.number, hash_of(target.name, kHashStart));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::size_t length = std::min(name.size(), sizeof address.sun_path);
  std::copy_n(name.begin(), length, address.sun_path);
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length);
  if (::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), size) == 0) return lock;
  if (errno != EADDRINUSE) return NameLock();
  return core::Error{core::ErrorCode::kUnreadable,
                     path +
                         ": another rind is writing it now; wait until that one has ended, or "
                         "name another file"};
}

NameLock::~NameLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

NameLock::NameLock(NameLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

NameLock& NameLock::operator=(NameLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

}  // namespace host
