// A log of bounded size: what the user was told, with the time, in FILE; when it is full it becomes
// FILE.1 (a file's ending stays: rind.1.log), and the oldest one goes. A stream (a pipe,
// /dev/stderr) is written as it comes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.h"  // Result

namespace host {

// The names that a log's older parts have.
[[nodiscard]] std::vector<std::string> older_logs(const std::string& path);

class LogFile {
 public:
  // Appends to what is there. At most (kLogFilesMax + 1) · kLogBytesMax on disk. Errors: what
  // output_target.h refuses, another program that writes the same log, and files under its names
  // that are no logs, and would be lost when they are full.
  static core::Result<std::unique_ptr<LogFile>> open(const std::string& path);
  virtual ~LogFile() = default;

  // A line of its own, on disk when it returns. A full disk is not an error of the print: the line
  // is lost.
  virtual void write(const std::string& text) = 0;
};

}  // namespace host
