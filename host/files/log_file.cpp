#include "host/files/log_file.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <cctype>
#include <fstream>
#include <string>
#include <utility>

#include "host/files/name_lock.h"      // NameLock
#include "host/files/output_target.h"  // look_at_target
#include "host/system/limits.h"        // kLogBytesMax, kLogFilesMax

namespace host {
namespace {

class SpdLog final : public LogFile {
 public:
  SpdLog(spdlog::sink_ptr sink, NameLock lock)
      : lock_(std::move(lock)), logger_("rind", std::move(sink)) {
    logger_.set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %v");
    logger_.flush_on(spdlog::level::trace);
    logger_.set_error_handler([](const std::string&) {});
  }
  void write(const std::string& text) override { logger_.info("{}", text); }

 private:
  NameLock lock_;
  spdlog::logger logger_;
};

core::Error refused(const std::string& path, const std::string& cause) {
  return {core::ErrorCode::kUnreadable, path + ": " + cause};
}

// True if the file starts with a log line's time, or is empty.
bool is_log(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(11, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (file.gcount() == 0) return !file.bad();
  constexpr std::string_view kForm = "0000-00-00T";
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    const bool digit = std::isdigit(static_cast<unsigned char>(begin[i])) != 0;
    if (kForm[i] == '0' ? !digit : begin[i] != kForm[i]) return false;
  }
  return true;
}

// Existing files are appended to and deleted in the end, so they must be logs.
core::Status check_logs(const std::string& path) {
  std::vector<std::string> names = older_logs(path);
  names.push_back(path);
  for (const std::string& name : names) {
    const core::Result<OutputTarget> there = look_at_target(name);
    if (!there.ok()) return there.error();
    if (there.value().kind == OutputTarget::Kind::kNew) continue;
    if (there.value().kind == OutputTarget::Kind::kRegular && is_log(name)) continue;
    return refused(name,
                   "this file is no log of rind, and would be lost when the log is full; "
                   "name another one with --log");
  }
  return {};
}

}  // namespace

std::vector<std::string> older_logs(const std::string& path) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= kLogFilesMax; ++i) {
    names.push_back(spdlog::sinks::rotating_file_sink_st::calc_filename(path, i));
  }
  return names;
}

core::Result<std::unique_ptr<LogFile>> LogFile::open(const std::string& path) {
  core::Result<OutputTarget> target = look_at_target(path);
  if (!target.ok()) return target.error();
  const std::string& file = target.value().path;
  const bool stream = target.value().kind == OutputTarget::Kind::kStream;
  NameLock lock;
  if (!stream) {
    core::Result<NameLock> taken = NameLock::take(target.value(), path);
    if (!taken.ok()) return taken.error();
    lock = std::move(taken).value();
    if (core::Status fine = check_logs(file); !fine.ok()) return fine.error();
  }
  try {
    spdlog::sink_ptr sink;
    if (stream) {
      sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(file);
    } else {
      sink =
          std::make_shared<spdlog::sinks::rotating_file_sink_st>(file, kLogBytesMax, kLogFilesMax);
    }
    return std::unique_ptr<LogFile>(std::make_unique<SpdLog>(std::move(sink), std::move(lock)));
  } catch (const spdlog::spdlog_ex& error) {
    return refused(path, std::string("the log can't be written: ") + error.what() +
                             "; name another file with --log");
  }
}

}  // namespace host
