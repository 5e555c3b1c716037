#include "host/printing/request_pipe.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>

#include "host/system/text.h"  // trimmed

namespace host {
namespace {

std::string pipe_of(const std::string& journal) { return journal + ".requests"; }

bool is_pipe(int descriptor) {
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISFIFO(status.st_mode);
}

}  // namespace

std::optional<TypedRequest> request_of_line(std::string_view line) {
  const std::string_view text = trimmed(line);
  if (text == "pause") return TypedRequest{UserRequest::kPause};
  if (text == "resume") return TypedRequest{UserRequest::kResume};
  if (text == "stop") return TypedRequest{UserRequest::kStop};
  constexpr std::string_view kCancel = "cancel ";
  if (text.substr(0, kCancel.size()) != kCancel) return std::nullopt;
  const std::string_view digits = trimmed(text.substr(kCancel.size()));
  TypedRequest cancelled;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), cancelled.object);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  if (!whole || cancelled.object < 1) return std::nullopt;
  return cancelled;
}

std::unique_ptr<RequestPipe> RequestPipe::create(const std::string& journal) {
  std::string path = pipe_of(journal);
  if (::mkfifo(path.c_str(), 0600) != 0 && errno != EEXIST) return nullptr;
  // Open for writing, too: otherwise it would be at its end whenever nobody writes.
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  if (!is_pipe(descriptor)) {
    ::close(descriptor);
    return nullptr;
  }
  return std::unique_ptr<RequestPipe>(new RequestPipe(std::move(path), descriptor));
}

RequestPipe::~RequestPipe() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

std::optional<TypedRequest> RequestPipe::next() {
  while (true) {
    const std::size_t end = read_.find('\n');
    if (end != std::string::npos) {
      const std::optional<TypedRequest> request = request_of_line(read_.substr(0, end));
      read_.erase(0, end + 1);
      if (std::exchange(skips_to_end_, false) || !request) continue;
      return request;
    }
    if (read_.size() > kRequestBytesMax) skips_to_end_ = true;
    if (skips_to_end_) read_.clear();
    std::array<char, kRequestBytesMax> bytes{};
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count <= 0) return std::nullopt;
    read_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

core::Status tell_print(const std::string& journal, const std::string& request) {
  const core::Error nobody{core::ErrorCode::kUnreadable,
                           journal + ": no print that takes requests runs with this journal"};
  const int descriptor =
      ::open(pipe_of(journal).c_str(), O_WRONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return nobody;
  const std::string line = request + "\n";
  const bool written = is_pipe(descriptor) && ::write(descriptor, line.data(), line.size()) ==
                                                  static_cast<ssize_t>(line.size());
  const int cause = errno;
  ::close(descriptor);
  if (written) return {};
  if (cause != EAGAIN) return nobody;
  return core::Error{core::ErrorCode::kUnreadable,
                     journal + ": the print does not read its requests; is it stopped?"};
}

}  // namespace host
