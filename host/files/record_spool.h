// Records of bytes in a temporary file without a name, written one behind another and read either
// way, through one buffer.
//
//     │length│ bytes │length│length│ bytes │length│ …
//
// Memory: two buffers of kSpoolBufferBytes and the longest record each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"            // Result, Status
#include "host/files/spill_file.h"  // SpillFile

namespace host {

class RecordSpool {
 public:
  struct Record {
    std::int64_t at = 0;     // for read_at()
    std::string_view bytes;  // valid until the next call
  };

  // Errors: as SpillFile.
  static core::Result<RecordSpool> create(const std::string& folder, SpillUse use);

  // Where the next record will be.
  [[nodiscard]] std::int64_t next_place() const {
    return file_.size() + static_cast<std::int64_t>(unwritten_.size());
  }

  // REQUIRES: at most 2^32 − 1 bytes; nothing was read so far.
  [[nodiscard]] core::Status append(std::string_view bytes);

  // Where reading goes on: behind the last record (the default), or at the first.
  void go_to_end();
  void go_to_start();

  // The next record up, or down; nullopt at the end.
  [[nodiscard]] core::Result<std::optional<Record>> next();
  [[nodiscard]] core::Result<std::optional<Record>> previous();

  // The record at this place, wherever reading stands.
  [[nodiscard]] core::Result<Record> read_at(std::int64_t place);

  [[nodiscard]] std::int64_t size() const { return next_place(); }
  [[nodiscard]] const SpillFile& file() const { return file_; }

 private:
  explicit RecordSpool(SpillFile file) : file_(std::move(file)) {}

  [[nodiscard]] core::Status write_out();
  // Bytes of the file, from the buffer. `down`: the buffer is filled with what is before them.
  [[nodiscard]] core::Result<std::string_view> look(std::int64_t from, std::size_t size, bool down);
  [[nodiscard]] core::Result<Record> record_at(std::int64_t place);

  SpillFile file_;
  std::string unwritten_;
  std::string buffer_;
  std::int64_t buffer_from_ = 0;
  std::int64_t here_ = 0;
};

}  // namespace host
