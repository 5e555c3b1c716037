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

class SpillFile {
 public:
  // `folder` empty: $TMPDIR, or /tmp. Errors (kUnreadable): no such folder, no permission to write
  // there; the message names the folder, the cause and what to do.
  static core::Result<SpillFile> create(const std::string& folder);

  ~SpillFile();
  SpillFile(SpillFile&& other) noexcept;
  SpillFile& operator=(SpillFile&& other) noexcept;

  // Appends all of it. A full disk is an error.
  [[nodiscard]] core::Status append(std::string_view bytes);

  // Reads `size` bytes at `offset`. REQUIRES: they have been appended.
  [[nodiscard]] core::Status read(std::int64_t offset, char* into, std::size_t size) const;

  [[nodiscard]] std::int64_t size() const { return size_; }

 private:
  SpillFile(std::string folder, int descriptor)
      : folder_(std::move(folder)), descriptor_(descriptor) {}
  [[nodiscard]] core::Error failed(const char* what, int cause) const;

  std::string folder_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;
};

}  // namespace host
