#include "host/output/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "host/limits.h"

namespace host {
namespace {

core::Error cannot(const std::string& path, const char* what) {
  return {core::ErrorCode::kUnreadable, path + ": can't " + what + ": " + std::strerror(errno)};
}

}  // namespace

core::Result<OutputFile> OutputFile::open(const std::string& path) {
  if (path == "-") return OutputFile(STDOUT_FILENO, "standard output", "");
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return cannot(path, "be opened for writing");
    return OutputFile(descriptor, path, "");
  }
  const std::string partial_path = path + ".partial";
  const int descriptor =
      ::open(partial_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return cannot(path, "be written");
  return OutputFile(descriptor, path, partial_path);
}

OutputFile::OutputFile(int descriptor, std::string path, std::string partial_path)
    : descriptor_(descriptor), path_(std::move(path)), partial_path_(std::move(partial_path)) {
  buffer_.reserve(kFileBufferBytes);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      partial_path_(std::move(other.partial_path_)),
      buffer_(std::move(other.buffer_)) {}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  if (descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  if (!partial_path_.empty()) ::unlink(partial_path_.c_str());
}

core::Status OutputFile::write(std::string_view text) {
  if (buffer_.size() + text.size() > kFileBufferBytes) {
    if (core::Status status = flush(); !status.ok()) return status;
  }
  buffer_ += text;
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

core::Status OutputFile::commit() {
  if (core::Status status = flush(); !status.ok()) return status;
  if (partial_path_.empty()) return {};
  // Some file systems tell only here that there was no room.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) return cannot(path_, "be written to the end");
  if (::close(std::exchange(descriptor_, -1)) != 0) return cannot(path_, "be closed");
  if (std::rename(partial_path_.c_str(), path_.c_str()) != 0) {
    const core::Error error = cannot(path_, "be given its name");
    ::unlink(partial_path_.c_str());
    return error;
  }
  return {};
}

}  // namespace host
