#include "host/printing/journal_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>  // renameat2
#include <cstring>
#include <filesystem>
#include <utility>

#include "host/printing/journal.h"  // read_journal

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

// A program that only looks at a journal holds it for a moment.
constexpr int kLockAttempts = 20;
constexpr useconds_t kLockPause_us = 10'000;
// Of a name that is taken by another program each time that it was found free.
constexpr int kNameAttempts = 5;

Error refusal(const std::string& path, const std::string& why) {
  return {ErrorCode::kUnreadable, path + ": " + why};
}

Error failure(const std::string& path, const std::string& what) {
  return refusal(path, what + ": " + std::strerror(errno));
}

Error held_error(const std::string& path) {
  return refusal(path, "another rind is printing with this journal; name another one by --journal");
}

bool same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

std::string kind_of(mode_t mode) {
  if (S_ISLNK(mode)) return "a symbolic link";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  if (S_ISBLK(mode) || S_ISCHR(mode)) return "a device";
  return "no journal of rind's";
}

std::string foreign_text(mode_t mode) {
  return "is " + kind_of(mode) + ", and is left as it is; name another file by --journal";
}

bool lock(int descriptor) {
  for (int i = 0; i < kLockAttempts; ++i) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
    if (errno != EWOULDBLOCK && errno != EINTR) return false;
    ::usleep(kLockPause_us);
  }
  errno = EWOULDBLOCK;
  return false;
}

// Opens nothing but a journal. ENSURES: an error, or a descriptor that the caller closes.
Result<int> open_journal(const std::string& path, int flags) {
  struct stat named {};
  if (::lstat(path.c_str(), &named) != 0) return failure(path, "the journal can't be opened");
  if (!S_ISREG(named.st_mode)) return refusal(path, foreign_text(named.st_mode));
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return failure(path, "the journal can't be opened");
  struct stat opened {};
  char first_bytes[kJournalWord.size()] = {};
  if (::fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode) &&
      ::pread(descriptor, first_bytes, sizeof first_bytes, 0) ==
          static_cast<ssize_t>(sizeof first_bytes) &&
      std::string_view(first_bytes, sizeof first_bytes) == kJournalWord) {
    return descriptor;
  }
  ::close(descriptor);
  return refusal(path, foreign_text(S_IFREG));
}

// So that a new name outlives a power cut.
void sync_folder(const std::string& path) {
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  (void)::fsync(descriptor);
  ::close(descriptor);
}

// 0: done. EEXIST: there is one of that name.
int rename_to_new(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS && errno != ENOTSUP) return errno;
  if (::link(from.c_str(), to.c_str()) != 0) return errno;
  ::unlink(from.c_str());
  return 0;
}

// Whether a whole record may be in it, or something that only another rind can tell.
bool worth_keeping(const std::string& path) { return !is_empty_journal(path); }

// REQUIRES: the caller holds what has the name.
Status move_aside(const std::string& path) {
  const std::string aside = set_aside_name(path);
  struct stat status {};
  if (::lstat(aside.c_str(), &status) == 0) {
    const Result<HeldFile> older = HeldFile::take(aside);
    if (!older.ok()) return older.error();
  }
  if (::rename(path.c_str(), aside.c_str()) == 0) return {};
  return failure(path, "the journal can't be set aside");
}

// What has the name goes out of the way, if it may.
Status make_way(const std::string& path, bool sets_aside) {
  const Result<HeldFile> old = HeldFile::take(path);
  if (!old.ok()) return old.error();
  if (!old.value().is_named(path)) return {};
  if (!worth_keeping(path)) {
    old.value().remove(path);
    return {};
  }
  if (sets_aside) return move_aside(path);
  return refusal(
      path, "holds an interrupted print; resume it by `rind resume " + path + "`, or say --anew");
}

}  // namespace

std::string set_aside_name(const std::string& path) { return path + ".old"; }

Status set_aside(const std::string& path) {
  const Result<HeldFile> old = HeldFile::take(path);
  return old.ok() ? move_aside(path) : old.error();
}

JournalLook look_at_journal(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 && errno == ENOENT) return {};
  const Result<int> opened = open_journal(path, O_RDONLY);
  if (!opened.ok()) return {JournalStanding::kForeign, opened.error().message};
  const bool is_free = ::flock(opened.value(), LOCK_SH | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  ::close(opened.value());
  if (!is_free) return {JournalStanding::kHeld, {}};
  return {worth_keeping(path) ? JournalStanding::kResumable : JournalStanding::kEmpty, {}};
}

Result<HeldFile> HeldFile::take(const std::string& path) {
  const Result<int> opened = open_journal(path, O_RDWR);
  if (!opened.ok()) return opened.error();
  HeldFile file(opened.value());
  if (lock(file.descriptor_)) return file;
  return errno == EWOULDBLOCK ? held_error(path) : failure(path, "the journal can't be locked");
}

Result<HeldFile> HeldFile::make(const std::string& path, std::string_view content,
                                bool sets_aside) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(path, error).parent_path();
  std::filesystem::create_directories(folder, error);
  std::string partial = path + ".partial-XXXXXX";
  const int descriptor = ::mkostemp(partial.data(), O_CLOEXEC);
  if (descriptor < 0) return failure(path, "the journal can't be made");
  HeldFile file(descriptor);
  const auto given_up = [&partial](const Error& why) {
    ::unlink(partial.c_str());
    return why;
  };
  if (!lock(descriptor)) return given_up(failure(path, "the journal can't be locked"));
  if (!file.write(content, 0) || ::fsync(descriptor) != 0) {
    return given_up(failure(path, "the journal can't be written"));
  }
  for (int i = 0; i < kNameAttempts; ++i) {
    errno = rename_to_new(partial, path);
    if (errno == 0) {
      sync_folder(path);
      return file;
    }
    if (errno != EEXIST) return given_up(failure(path, "the journal can't be made"));
    if (Status way = make_way(path, sets_aside); !way.ok()) return given_up(way.error());
  }
  return given_up(held_error(path));
}

HeldFile::HeldFile(HeldFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

HeldFile::~HeldFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool HeldFile::is_named(const std::string& path) const {
  struct stat named {};
  struct stat held {};
  return ::lstat(path.c_str(), &named) == 0 && ::fstat(descriptor_, &held) == 0 &&
         same_file(named, held);
}

bool HeldFile::write(std::string_view bytes, std::int64_t at) const {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor_, bytes.data(), bytes.size(), at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    at += count;
  }
  return true;
}

int HeldFile::opened_for_sync() const {
  return ::open(fmt::format("/proc/self/fd/{}", descriptor_).c_str(),
                O_WRONLY | O_DSYNC | O_CLOEXEC);
}

void HeldFile::remove(const std::string& path) const {
  if (!is_named(path)) return;
  ::unlink(path.c_str());
  sync_folder(path);
}

}  // namespace host
