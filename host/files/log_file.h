// A log of bounded size: the messages that the user saw, with the time. A full FILE is renamed to
// FILE.1 (rind.log to rind.1.log), and the oldest file is deleted. A stream (a pipe, /dev/stderr)
// is written straight away.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"  // Result

namespace host {

// The names of a log's older files.
[[nodiscard]] std::vector<std::string> older_logs(const std::string& path);

class LogFile {
 public:
  // Appends to an existing log. At most (kLogFilesMax + 1) · kLogBytesMax on disk. Errors: a target
  // that output_target.h refuses; another program writes the same log; a file with one of the log's
  // names is no log, and would be lost.
  static core::Result<std::unique_ptr<LogFile>> open(const std::string& path);
  virtual ~LogFile() = default;

  // Writes one line, which is on disk when this returns. On a full disk the line is lost; the print
  // continues.
  virtual void write(const std::string& text) = 0;
};

}  // namespace host
