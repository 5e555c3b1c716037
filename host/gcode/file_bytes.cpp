#include "host/gcode/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/check.h"

namespace host {
namespace {

core::Error unreadable(const std::string& name, const std::string& cause) {
  return {core::ErrorCode::kUnreadable, name + ": " + cause};
}

}  // namespace

core::Result<FileBytes> FileBytes::open(const std::string& path) {
  FileBytes file(path);
  file.descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file.descriptor_ < 0) return unreadable(path, std::strerror(errno));
  struct stat status {};
  if (::fstat(file.descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) {
    return unreadable(path, "this is no regular file");
  }
  file.size_ = status.st_size;
  file.changed_s_ = status.st_mtim.tv_sec;
  file.changed_ns_ = status.st_mtim.tv_nsec;
  return file;
}

FileBytes FileBytes::of_spill(std::string name, SpillFile spill) {
  FileBytes file(std::move(name));
  file.size_ = spill.size();
  file.spill_.emplace(std::move(spill));
  return file;
}

FileBytes::~FileBytes() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FileBytes::FileBytes(FileBytes&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      spill_(std::move(other.spill_)),
      size_(other.size_),
      changed_s_(other.changed_s_),
      changed_ns_(other.changed_ns_) {}

core::Result<std::size_t> FileBytes::read(std::int64_t at, char* into, std::size_t size) const {
  RIND_CHECK(at >= 0);
  const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, size_ - at));
  size = std::min(size, left);
  if (spill_) {
    if (core::Status read = spill_->read(at, into, size); !read.ok()) return read.error();
    return size;
  }
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || status.st_size != size_ ||
      status.st_mtim.tv_sec != changed_s_ || status.st_mtim.tv_nsec != changed_ns_) {
    return unreadable(name_,
                      "the file was changed while it was read; what it holds now was not "
                      "checked: print it again");
  }
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count =
        ::pread(descriptor_, into + done, size - done, at + static_cast<std::int64_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      return unreadable(name_, "reading failed at byte " + std::to_string(at) + ": " +
                                   (count < 0 ? std::strerror(errno) : "the file ended"));
    }
    done += static_cast<std::size_t>(count);
  }
  return done;
}

}  // namespace host
