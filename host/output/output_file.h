// A file that is written as the print is computed, and that is there only when it is whole.
//
//     open ──> OUT.gcode.partial ──write …──> commit ──> OUT.gcode
//                     └── destroyed without commit: removed
//
// A device, a pipe or standard output ("-") is written straight away: it has no name to hold back.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.h"  // Result, Status

namespace host {

class OutputFile {
 public:
  // An error names the path and the cause.
  [[nodiscard]] static core::Result<OutputFile> open(const std::string& path);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  // Buffered up to kFileBufferBytes. An error, such as a full disk, is final.
  [[nodiscard]] core::Status write(std::string_view text);

  // Writes what is left and gives the file its name. REQUIRES: no write failed.
  [[nodiscard]] core::Status commit();

 private:
  OutputFile(int descriptor, std::string path, std::string partial_path);
  [[nodiscard]] core::Status flush();

  int descriptor_;
  std::string path_;
  std::string partial_path_;  // empty: written straight away
  std::string buffer_;
};

}  // namespace host
