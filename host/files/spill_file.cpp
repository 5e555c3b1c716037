#include "host/files/spill_file.h"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "core/check.h"                 // RIND_CHECK
#include "host/system/memory_budget.h"  // take_file_memory, give_back_file_memory

namespace host {
namespace {

std::string temporary_folder() {
  const char* folder = std::getenv("TMPDIR");
  return folder != nullptr && *folder != '\0' ? folder : "/tmp";
}

}  // namespace

core::Result<SpillFile> SpillFile::create(const std::string& folder, SpillUse use) {
  const std::string place = folder.empty() ? temporary_folder() : folder;
  std::string path = place + "/rind-XXXXXX";
  const int descriptor = ::mkostemp(path.data(), O_CLOEXEC);
  if (descriptor < 0) {
    return core::Error{core::ErrorCode::kUnreadable,
                       place + ": no temporary file for " + std::string(use.purpose) +
                           " can be made here: " + std::strerror(errno) + "; " +
                           std::string(use.remedy)};
  }
  ::unlink(path.c_str());
  return SpillFile(place, use, descriptor);
}

SpillFile::SpillFile(std::string folder, SpillUse use, int descriptor)
    : folder_(std::move(folder)), use_(use), descriptor_(descriptor) {
  struct statfs system {};
  in_memory_ = ::fstatfs(descriptor_, &system) == 0 && system.f_type == TMPFS_MAGIC;
}

SpillFile::~SpillFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (in_memory_) give_back_file_memory(size_);
}

SpillFile::SpillFile(SpillFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      use_(other.use_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      in_memory_(other.in_memory_),
      size_(other.size_) {}

SpillFile& SpillFile::operator=(SpillFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(use_, other.use_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(in_memory_, other.in_memory_);
  std::swap(size_, other.size_);
  return *this;
}

core::Error SpillFile::failed(const char* what, int cause) const {
  return {core::ErrorCode::kUnreadable,
          folder_ + ": " + what + " the temporary file for " + std::string(use_.purpose) +
              " failed after " + std::to_string(size_) + " bytes: " + std::strerror(cause) +
              "; make room there, or " + std::string(use_.remedy)};
}

core::Status SpillFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto wanted = static_cast<std::int64_t>(bytes.size());
    if (in_memory_ && !take_file_memory(wanted)) {
      return core::Error{core::ErrorCode::kNoMemory,
                         folder_ + " is kept in memory, and with it the temporary file for " +
                             std::string(use_.purpose) + ": " + memory_refusal() + "; " +
                             std::string(use_.remedy)};
    }
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (in_memory_) give_back_file_memory(wanted - std::max<std::int64_t>(count, 0));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return failed("writing", count < 0 ? errno : ENOSPC);
    bytes.remove_prefix(static_cast<std::size_t>(count));
    size_ += count;
  }
  return {};
}

core::Status SpillFile::read(std::int64_t offset, char* into, std::size_t size) const {
  RIND_CHECK(offset >= 0 && offset + static_cast<std::int64_t>(size) <= size_);
  while (size > 0) {
    const ssize_t count = ::pread(descriptor_, into, size, offset);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return failed("reading", count < 0 ? errno : EIO);
    into += count;
    offset += count;
    size -= static_cast<std::size_t>(count);
  }
  return {};
}

}  // namespace host
