// A log of bounded size: what the user was told, with the time, in FILE; when it is full it becomes
// FILE.1 (a file's ending stays: rind.1.log), and the oldest one goes.
#pragma once

#include <memory>
#include <string>

#include "core/result.h"  // Result

namespace host {

class LogFile {
 public:
  // Appends to what is there. At most (kLogFilesMax + 1) · kLogBytesMax on disk.
  static core::Result<std::unique_ptr<LogFile>> open(const std::string& path);
  virtual ~LogFile() = default;

  // A line of its own, on disk when it returns. A full disk is not an error of the print: the line
  // is lost.
  virtual void write(const std::string& text) = 0;
};

}  // namespace host
