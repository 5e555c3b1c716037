// Bytes of a file or of standard input, in order, through one buffer of fixed size.
//
//     window(n)   the next bytes, at least n of them unless the file ends before
//     skip(n)     they have been used
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"  // Result

namespace host {

// Whoever waits for a pipe's next bytes gets an error instead, from now on; so does everyone after
// the first stop signal. For a print that has ended in another way.
void stop_waiting_for_input();

class InputFile {
 public:
  // The buffer's size, and the longest window.
  static constexpr std::size_t kWindowMax = std::size_t{1} << 18;

  // `path` "-" is standard input. A folder is refused here.
  static core::Result<InputFile> open(const std::string& path);
  // Over an open file without a name of its own, which it closes; `name` is for people.
  static InputFile from_descriptor(std::string name, int descriptor);
  // The same over bytes in memory.
  static InputFile from_bytes(std::string name, std::string bytes);

  ~InputFile();
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&& other) noexcept;

  // As people are to see it.
  [[nodiscard]] const std::string& name() const { return name_; }
  // A regular file, which its path gives once more: not a pipe, a device, or bytes in memory.
  [[nodiscard]] bool rereadable() const;
  // Where that can be known before the end: of a regular file, and of bytes in memory.
  [[nodiscard]] std::optional<std::int64_t> size() const;
  // Bytes skipped so far.
  [[nodiscard]] std::int64_t position() const { return position_; }

  // Valid until the next call. Empty only at the end. REQUIRES: 1 <= least <= kWindowMax
  [[nodiscard]] core::Result<std::string_view> window(std::size_t least);
  // REQUIRES: bytes <= what window() gave last
  void skip(std::size_t bytes);

 private:
  InputFile(std::string name, int descriptor);
  [[nodiscard]] core::Status fill();

  std::string name_;
  int descriptor_ = -1;  // -1: none, all bytes are in the buffer
  bool named_ = true;    // its path gives it once more
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool ended_ = false;
  std::int64_t position_ = 0;
};

}  // namespace host
