// Reads a file or standard input in order, through one buffer of fixed size.
//
//     window(n)   gives the next bytes, at least n of them unless the file ends sooner
//     skip(n)     moves past n bytes that have been used
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"  // Result

namespace host {

// From now on, waiting for a pipe's next bytes fails with an error. The first stop signal has the
// same effect; this function is for prints that ended for another reason.
void stop_waiting_for_input();

class InputFile {
 public:
  // The buffer's size, and the longest window.
  static constexpr std::size_t kWindowMax = std::size_t{1} << 18;

  // `path` "-" is standard input. Folders are refused.
  static core::Result<InputFile> open(const std::string& path);
  // Standard input of which only the start was looked at: open("-") gives it again. REQUIRES: none
  // of it was skipped.
  static void give_back(InputFile standard_input);
  // Takes over an open file, and closes it at the end. `name` is for messages.
  static InputFile from_descriptor(std::string name, int descriptor);
  // Reads bytes in memory.
  static InputFile from_bytes(std::string name, std::string bytes);

  ~InputFile();
  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&& other) noexcept;

  // For messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  // True for a regular file that can be opened again by its path; false for a pipe, a device, or
  // bytes in memory.
  [[nodiscard]] bool rereadable() const;
  // Size of a regular file or of bytes in memory; nullopt if not known before the end.
  [[nodiscard]] std::optional<std::int64_t> size() const;
  // Bytes skipped so far.
  [[nodiscard]] std::int64_t position() const { return position_; }

  // The view is valid until the next call, and empty only at the end.
  // REQUIRES: 1 <= least <= kWindowMax
  [[nodiscard]] core::Result<std::string_view> window(std::size_t least);
  // REQUIRES: bytes <= size of the last window()
  void skip(std::size_t bytes);

 private:
  InputFile(std::string name, int descriptor);
  [[nodiscard]] core::Status fill();

  std::string name_;
  int descriptor_ = -1;  // -1: none, all bytes are in the buffer
  bool named_ = true;    // can be opened again by its path
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool ended_ = false;
  std::int64_t position_ = 0;
};

}  // namespace host
