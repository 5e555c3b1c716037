// The bytes of a file, read at any place: a regular file, or what came through a pipe.
//
// A file that is changed while it is printed is noticed: its size and time of change are looked at
// whenever bytes are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/result.h"            // Result
#include "host/files/spill_file.h"  // SpillFile

namespace host {

class FileBytes {
 public:
  // Errors: not there, no regular file.
  static core::Result<FileBytes> open(const std::string& path);
  // Takes over what was spilled. `name` is for messages.
  static FileBytes of_spill(std::string name, SpillFile spill);

  ~FileBytes();
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&&) = delete;

  // For messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::int64_t size() const { return size_; }

  // So many bytes from there; fewer only at the end. Errors: the disk's; a file that has changed
  // since it was opened. REQUIRES: at >= 0.
  [[nodiscard]] core::Result<std::size_t> read(std::int64_t at, char* into, std::size_t size) const;

 private:
  explicit FileBytes(std::string name) : name_(std::move(name)) {}

  std::string name_;
  int descriptor_ = -1;  // -1: spilled
  std::optional<SpillFile> spill_;
  std::int64_t size_ = 0;
  std::int64_t changed_s_ = 0;  // when it was changed last
  std::int64_t changed_ns_ = 0;
};

}  // namespace host
