#include "host/files/mapped_array.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>

namespace host {
namespace {

std::string folder() {
  const char* named = std::getenv("TMPDIR");
  return named != nullptr && *named != '\0' ? named : "/tmp";
}

core::Error cannot(int cause) {
  return {core::ErrorCode::kUnreadable,
          folder() + ": a temporary file for the part's vertices can't be made there: " +
              std::strerror(cause) + "; make room, or set TMPDIR to another folder"};
}

}  // namespace

MappedBytes::~MappedBytes() {
  if (mapped_ != nullptr) ::munmap(mapped_, mapped_bytes_);
  if (descriptor_ >= 0) ::close(descriptor_);
}

core::Status MappedBytes::grow(std::size_t size) {
  const std::size_t wanted = std::max({size, capacity() * 2, std::size_t{4'096}});
  if (wanted <= kInMemoryMax) {
    held_.resize(wanted);
    return {};
  }
  if (descriptor_ < 0) {
    std::string name = folder() + "/rind_XXXXXX";
    descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor_ < 0) return cannot(errno);
    ::unlink(name.c_str());
  }
  return map(wanted);
}

core::Status MappedBytes::map(std::size_t bytes) {
  // Reserve the room now: a full disk at the system's write-back would end the program.
  const int cause = ::posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes));
  if (cause != 0) return cannot(cause);
  void* at = mapped_ == nullptr
                 ? ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0)
                 : ::mremap(mapped_, mapped_bytes_, bytes, MREMAP_MAYMOVE);
  if (at == MAP_FAILED) return cannot(errno);
  const bool first = mapped_ == nullptr;
  mapped_ = static_cast<char*>(at);
  mapped_bytes_ = bytes;
  if (first) {
    std::copy(held_.begin(), held_.end(), mapped_);
    held_ = {};
  }
  return {};
}

}  // namespace host
