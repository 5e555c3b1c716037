#include "host/files/input_file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/check.h"                // RIND_CHECK
#include "host/system/stop_signals.h"  // stop_signal_count

namespace host {
namespace {

constexpr const char* kStandardInput = "standard input";

core::Error unreadable(const std::string& name, const std::string& cause) {
  return {core::ErrorCode::kUnreadable, name + ": " + cause};
}

std::atomic<bool> g_stop_waiting = false;

constexpr int kWait_ms = 50;

std::optional<InputFile>& given_back() {
  static std::optional<InputFile> file;
  return file;
}

}  // namespace

void InputFile::give_back(InputFile standard_input) {
  RIND_CHECK(standard_input.position() == 0);
  given_back().emplace(std::move(standard_input));
}

void stop_waiting_for_input() { g_stop_waiting.store(true); }

core::Result<InputFile> InputFile::open(const std::string& path) {
  if (path == "-" && given_back()) {
    InputFile file = *std::move(given_back());
    given_back().reset();
    return file;
  }
  if (path == "-") return InputFile(kStandardInput, ::dup(STDIN_FILENO));
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    const int cause = errno;
    std::string advice = std::strerror(cause);
    if (cause == ENOENT) advice = "there is no such file; check the path";
    if (cause == EACCES) advice = "reading it is not permitted; change its permissions";
    return unreadable(path, advice);
  }
  InputFile file(path, descriptor);
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode)) {
    return unreadable(path, "this is a folder; name a part's file in it");
  }
  return file;
}

InputFile InputFile::from_descriptor(std::string name, int descriptor) {
  InputFile file(std::move(name), descriptor);
  file.named_ = false;
  return file;
}

InputFile InputFile::from_bytes(std::string name, std::string bytes) {
  InputFile file(std::move(name), -1);
  file.buffer_.assign(bytes.begin(), bytes.end());
  file.end_ = file.buffer_.size();
  file.ended_ = true;
  return file;
}

InputFile::InputFile(std::string name, int descriptor)
    : name_(std::move(name)), descriptor_(descriptor) {
  if (descriptor_ >= 0) buffer_.resize(kWindowMax);
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

InputFile::InputFile(InputFile&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      named_(other.named_),
      buffer_(std::move(other.buffer_)),
      begin_(other.begin_),
      end_(other.end_),
      ended_(other.ended_),
      position_(other.position_) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(named_, other.named_);
  std::swap(buffer_, other.buffer_);
  begin_ = other.begin_;
  end_ = other.end_;
  ended_ = other.ended_;
  position_ = other.position_;
  return *this;
}

bool InputFile::rereadable() const {
  struct stat status {};
  return named_ && name_ != kStandardInput && descriptor_ >= 0 &&
         ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
}

std::optional<std::int64_t> InputFile::size() const {
  if (descriptor_ < 0) return position_ + static_cast<std::int64_t>(end_ - begin_);
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return std::int64_t{status.st_size};
}

core::Status InputFile::fill() {
  if (begin_ > 0) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  pollfd waiting{descriptor_, POLLIN, 0};
  int ready = 0;
  while ((ready = ::poll(&waiting, 1, kWait_ms)) == 0 || (ready < 0 && errno == EINTR)) {
    if (g_stop_waiting.load() || stop_signal_count() > 0) {
      return unreadable(name_, "stopped while waiting for more of it");
    }
  }
  const ssize_t count = ::read(descriptor_, buffer_.data() + end_, buffer_.size() - end_);
  if (count < 0 && errno == EINTR) return {};
  if (count < 0) {
    return unreadable(name_, "reading failed at byte " +
                                 std::to_string(position_ + static_cast<std::int64_t>(end_)) +
                                 ": " + std::strerror(errno));
  }
  ended_ = count == 0;
  end_ += static_cast<std::size_t>(count);
  return {};
}

core::Result<std::string_view> InputFile::window(std::size_t least) {
  RIND_CHECK(least >= 1 && least <= kWindowMax);
  while (end_ - begin_ < least && !ended_) {
    if (core::Status filled = fill(); !filled.ok()) return filled.error();
  }
  return std::string_view(buffer_.data() + begin_, end_ - begin_);
}

void InputFile::skip(std::size_t bytes) {
  RIND_CHECK(bytes <= end_ - begin_);
  begin_ += bytes;
  position_ += static_cast<std::int64_t>(bytes);
}

}  // namespace host
