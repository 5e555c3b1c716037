#include "host/files/output_target.h"

#include <sys/sysmacros.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace host {
namespace {

namespace fs = std::filesystem;

// As many as Linux follows.
constexpr int kLinksMax = 40;

core::Error refused(const std::string& path, const std::string& cause) {
  return {core::ErrorCode::kUnreadable, path + ": " + cause};
}

core::Error failed(const std::string& path) {
  return refused(path, std::string("can't be written: ") + std::strerror(errno));
}

FileIdentity identity_of(const struct stat& status) { return {status.st_dev, status.st_ino}; }

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// A link that another user may have planted.
bool planted(const struct stat& link, const std::string& path) {
  struct stat folder {};
  if (::stat(folder_of(path).c_str(), &folder) != 0) return false;
  const bool everybodys = (folder.st_mode & S_ISVTX) != 0 && (folder.st_mode & S_IWOTH) != 0;
  return everybodys && link.st_uid != ::geteuid() && link.st_uid != folder.st_uid;
}

core::Result<std::string> behind_links(const std::string& path) {
  fs::path at = path;
  for (int i = 0; i < kLinksMax; ++i) {
    struct stat status {};
    if (::lstat(at.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return at.string();
    if (planted(status, at.string())) {
      return refused(path, at.string() + " is somebody else's link; name another file");
    }
    std::error_code error;
    const fs::path to = fs::read_symlink(at, error);
    if (error) return refused(path, "can't be written: " + error.message());
    at = to.is_absolute() ? to : at.parent_path() / to;
  }
  errno = ELOOP;
  return failed(path);
}

// True for devices that discard bytes or show them to the user.
bool harmless(const struct stat& status) {
  constexpr unsigned kMemoryDevices = 1, kNull = 3, kZero = 5, kFull = 7;
  constexpr unsigned kTerminalDevices = 5, kOwnTerminal = 0;
  const unsigned kind = major(status.st_rdev), which = minor(status.st_rdev);
  if (kind == kMemoryDevices && (which == kNull || which == kZero || which == kFull)) return true;
  if (kind == kTerminalDevices && which == kOwnTerminal) return true;
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    struct stat own {};
    if (::fstat(descriptor, &own) == 0 && S_ISCHR(own.st_mode) && own.st_rdev == status.st_rdev) {
      return true;
    }
  }
  return false;
}

// Only these names: /dev/null is not standard output, even where that leads to it.
bool names_standard_output(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

core::Result<OutputTarget> look_at_special(const std::string& path, const struct stat& status) {
  OutputTarget target;
  target.kind = OutputTarget::Kind::kStream;
  target.path = path;
  target.file = identity_of(status);
  target.standard_output = names_standard_output(path);
  if (S_ISFIFO(status.st_mode)) return target;
  if (S_ISCHR(status.st_mode) && harmless(status)) return target;
  if (S_ISDIR(status.st_mode)) return refused(path, "this is a folder; name a file in it");
  return refused(path,
                 "this is a device or a socket, not a file; name a file (to print, use: rind print "
                 "--port)");
}

}  // namespace

std::optional<FileIdentity> identity_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return identity_of(status);
}

std::optional<FileIdentity> identity_of(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return std::nullopt;
  return identity_of(status);
}

core::Result<OutputTarget> look_at_target(const std::string& path) {
  struct stat status {};
  const bool there = ::stat(path.c_str(), &status) == 0;
  if (there && !S_ISREG(status.st_mode)) return look_at_special(path, status);
  // /dev/stdout as a file: appended to.
  if (there && names_standard_output(path)) {
    OutputTarget target;
    target.kind = OutputTarget::Kind::kStream;
    target.path = path;
    target.file = identity_of(status);
    target.standard_output = true;
    return target;
  }
  core::Result<std::string> real = behind_links(path);
  if (!real.ok()) return real.error();
  OutputTarget target;
  target.path = std::move(real).value();
  target.folder = folder_of(target.path);
  target.name = fs::path(target.path).filename().string();
  if (target.name.empty()) return refused(path, "this names a folder; name a file in it");
  const std::optional<FileIdentity> folder = identity_of(target.folder);
  if (!folder) return failed(path);
  target.folder_identity = *folder;
  if (::access(target.folder.c_str(), W_OK | X_OK) != 0) return failed(path);
  if (!there && identity_of(std::string("/dev")) == folder) {
    return refused(path, "there is no such device; name a file");
  }
  if (!there) return target;
  if (::access(target.path.c_str(), W_OK) != 0) {
    return refused(path, std::string("the file exists and can't be written to: ") +
                             std::strerror(errno) + "; name another file");
  }
  target.kind = OutputTarget::Kind::kRegular;
  target.file = identity_of(status);
  target.mode = status.st_mode & 07777;
  return target;
}

}  // namespace host
