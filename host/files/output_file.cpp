#include "host/files/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include "host/system/limits.h"
#include "host/system/stop_signals.h"  // StopShield

namespace host {
namespace {

constexpr int kNameAttempts = 16;

core::Error cannot(const std::string& path, const char* what) {
  return {core::ErrorCode::kUnreadable, path + ": can't " + what + ": " + std::strerror(errno)};
}

std::string random_name(const std::string& folder) {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) {
    number = static_cast<std::uint64_t>(::getpid());
  }
  return fmt::format("{}/.rind-{:016x}", folder, number);
}

// A path to a file without a name.
std::string descriptor_name(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

// Fails if the new name is taken.
bool link_descriptor(int descriptor, const std::string& to) {
  return ::linkat(AT_FDCWD, descriptor_name(descriptor).c_str(), AT_FDCWD, to.c_str(),
                  AT_SYMLINK_FOLLOW) == 0;
}

int open_nameless(const std::string& folder, mode_t mode) {
  return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
}

// Tries whether a file without a name can be given one here. The name is visible for a moment.
bool nameless_work(const std::string& folder) {
  const int probe = open_nameless(folder, 0600);
  if (probe < 0) return false;
  const std::string name = random_name(folder);
  const bool linked = link_descriptor(probe, name);
  if (linked) (void)::unlink(name.c_str());
  ::close(probe);
  return linked;
}

}  // namespace

core::Result<OutputFile> OutputFile::open(const std::string& path, Unfinished unfinished) {
  if (path == "-") return OutputFile(STDOUT_FILENO, "standard output");
  core::Result<OutputTarget> target = look_at_target(path);
  if (!target.ok()) return target.error();
  if (target.value().kind == OutputTarget::Kind::kStream) {
    if (target.value().standard_output) return OutputFile(STDOUT_FILENO, path);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) return cannot(path, "be opened for writing");
    return OutputFile(descriptor, path);
  }
  core::Result<NameLock> lock = NameLock::take(target.value(), path);
  if (!lock.ok()) return lock.error();
  OutputFile file(-1, path);
  file.target_ = std::move(target).value();
  file.lock_ = std::move(lock).value();
  if (core::Status started = file.start(unfinished); !started.ok()) return started.error();
  return file;
}

OutputFile::OutputFile(int descriptor, std::string path)
    : descriptor_(descriptor), path_(std::move(path)) {
  target_.kind = OutputTarget::Kind::kStream;
  buffer_.reserve(kFileBufferBytes);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      lock_(std::move(other.lock_)),
      temporary_(std::exchange(other.temporary_, {})),
      unfinished_(std::move(other.unfinished_)),
      buffer_(std::move(other.buffer_)),
      position_(other.position_) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0 && descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

core::Status OutputFile::start(Unfinished unfinished) {
  const bool nameless = unfinished == Unfinished::kNameless && start_nameless();
  if (!nameless && !start_named()) return cannot(path_, "be written");
  if (target_.kind != OutputTarget::Kind::kRegular) return {};
  // chown may not be permitted, and clears special mode bits, so the mode comes second.
  struct stat older {};
  if (::stat(target_.path.c_str(), &older) == 0) {
    (void)!::fchown(descriptor_, older.st_uid, older.st_gid);
  }
  if (::fchmod(descriptor_, target_.mode) != 0 && errno != EPERM) {
    return cannot(path_, "be given the mode of the file that is there");
  }
  return {};
}

bool OutputFile::start_nameless() {
  if (!nameless_work(target_.folder)) return false;
  descriptor_ = open_nameless(target_.folder, target_.mode);
  return descriptor_ >= 0;
}

bool OutputFile::start_named() {
  for (int i = 0; i < kNameAttempts; ++i) {
    const std::string name = random_name(target_.folder);
    unfinished_ = std::make_unique<UnfinishedFile>(name);
    constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    descriptor_ = ::open(name.c_str(), kFlags, target_.mode);
    if (descriptor_ >= 0) {
      temporary_ = name;
      return true;
    }
    const int cause = errno;
    unfinished_.reset();
    errno = cause;
    if (errno != EEXIST) return false;
  }
  return false;
}

core::Status OutputFile::write(std::string_view text) {
  if (buffer_.size() + text.size() > kFileBufferBytes) {
    if (core::Status status = flush(); !status.ok()) return status;
  }
  buffer_ += text;
  position_ += static_cast<std::int64_t>(text.size());
  return {};
}

core::Status OutputFile::patch(std::int64_t offset, std::string_view text) {
  if (core::Status status = flush(); !status.ok()) return status;
  while (!text.empty()) {
    const ssize_t written = ::pwrite(descriptor_, text.data(), text.size(), offset);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return cannot(path_, "be written to the end, and is not kept");
    offset += written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

core::Status OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot(path_, "be written to the end, and is not kept");
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
  return {};
}

// A new file never replaces another one; an older one is replaced in one step.
bool OutputFile::give_name() {
  const char* to = target_.path.c_str();
  if (target_.kind == OutputTarget::Kind::kNew) {
    if (temporary_.empty()) return link_descriptor(descriptor_, target_.path);
    if (::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, to, RENAME_NOREPLACE) != 0) {
      if (errno != EINVAL && errno != ENOSYS) return false;
      if (::access(to, F_OK) == 0) {
        errno = EEXIST;
        return false;
      }
      if (std::rename(temporary_.c_str(), to) != 0) return false;
    }
    temporary_.clear();
    return true;
  }
  if (temporary_.empty()) {
    const std::string name = random_name(target_.folder);
    unfinished_ = std::make_unique<UnfinishedFile>(name);
    if (!link_descriptor(descriptor_, name)) return false;
    temporary_ = name;
  }
  struct stat there {};
  if (::lstat(to, &there) == 0 && !S_ISREG(there.st_mode)) {
    errno = EEXIST;
    return false;
  }
  if (std::rename(temporary_.c_str(), to) != 0) return false;
  temporary_.clear();
  return true;
}

core::Status OutputFile::commit(AfterStop after_stop) {
  if (core::Status status = flush(); !status.ok()) return status;
  if (target_.kind == OutputTarget::Kind::kStream) return {};
  // Some file systems report a full disk only here.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) return cannot(path_, "be written to the end");
  const StopShield shield;
  if (after_stop == AfterStop::kNothing && stop_signal_count() > 0) {
    return core::Error{core::ErrorCode::kUnreadable, "stopped; " + path_ + " is not written"};
  }
  if (!give_name()) {
    if (errno != EEXIST) return cannot(path_, "be given its name");
    return core::Error{core::ErrorCode::kUnreadable,
                       path_ +
                           ": somebody else has made a file of that name meanwhile; that one "
                           "is kept, name another"};
  }
  unfinished_.reset();
  if (::close(std::exchange(descriptor_, -1)) != 0) return cannot(path_, "be closed");
  lock_ = NameLock();
  return {};
}

core::Status write_standard_output(std::string_view text) {
  std::fflush(stdout);
  core::Result<OutputFile> out = OutputFile::open("-");
  if (!out.ok()) return out.error();
  if (core::Status written = out.value().write(text); !written.ok()) return written;
  return out.value().commit();
}

}  // namespace host
