#include "host/log_file.h"

#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/spdlog.h>

#include <utility>

#include "host/limits.h"  // kLogBytesMax, kLogFilesMax

namespace host {
namespace {

class RotatingLog final : public LogFile {
 public:
  explicit RotatingLog(const std::string& path)
      : logger_("rind", std::make_shared<spdlog::sinks::rotating_file_sink_st>(path, kLogBytesMax,
                                                                               kLogFilesMax)) {
    logger_.set_pattern("%Y-%m-%dT%H:%M:%S.%e%z %v");
    logger_.flush_on(spdlog::level::trace);
    logger_.set_error_handler([](const std::string&) {});
  }
  void write(const std::string& text) override { logger_.info("{}", text); }

 private:
  spdlog::logger logger_;
};

}  // namespace

core::Result<std::unique_ptr<LogFile>> LogFile::open(const std::string& path) {
  try {
    return std::unique_ptr<LogFile>(std::make_unique<RotatingLog>(path));
  } catch (const spdlog::spdlog_ex& error) {
    return core::Error{
        core::ErrorCode::kUnreadable,
        path + ": the log can't be written: " + error.what() + "; name another file with --log"};
  }
}

}  // namespace host
