// A temporary file without a name: it disappears with the program, however that ends.
//
// It is appended to, then read at any offset. It is made in $TMPDIR, or in /tmp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"  // Result, Status

namespace host {

// What a file is for, in messages.
struct SpillUse {
  std::string_view purpose;  // "sorting"
  std::string_view remedy;   // "set TMPDIR, or more memory with --memory"
};

class SpillFile {
 public:
  // `folder` empty: $TMPDIR, or /tmp. Errors (kUnreadable): no such folder, no permission to write
  // there; the message names the folder, the cause and what to do.
  static core::Result<SpillFile> create(const std::string& folder, SpillUse use);

  ~SpillFile();
  SpillFile(SpillFile&& other) noexcept;
  SpillFile& operator=(SpillFile&& other) noexcept;

  // Appends all of it. Errors: a full disk; a file in memory that would exceed the memory limit.
  [[nodiscard]] core::Status append(std::string_view bytes);

  // Reads `size` bytes at `offset`. REQUIRES: they have been appended.
  [[nodiscard]] core::Status read(std::int64_t offset, char* into, std::size_t size) const;

  [[nodiscard]] std::int64_t size() const { return size_; }

  // Whether the folder is kept in memory (tmpfs): then so is the file.
  [[nodiscard]] bool in_memory() const { return in_memory_; }
  [[nodiscard]] const std::string& folder() const { return folder_; }

 private:
  SpillFile(std::string folder, SpillUse use, int descriptor);
  [[nodiscard]] core::Error failed(const char* what, int cause) const;

  std::string folder_;
  SpillUse use_;
  int descriptor_ = -1;
  bool in_memory_ = false;
  std::int64_t size_ = 0;
};

}  // namespace host
