// Bytes that wait to be written to the port, in one piece.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "firmware_link/wire/limits.h"  // kWindowBytesMax, kLineBytesMax

namespace firmware_link {

// A full window, a forced mismatch and a greeting at the same time.
inline constexpr std::size_t kOutputBytesMax = 512;
static_assert(kOutputBytesMax >= kWindowBytesMax + 2 * (kLineBytesMax + 2));

class OutputBuffer {
 public:
  // What is to be written next, oldest byte first. Valid until the next put().
  [[nodiscard]] std::span<const std::byte> pending() const {
    return std::span(bytes_).subspan(start_, end_ - start_);
  }
  [[nodiscard]] bool empty() const { return start_ == end_; }
  [[nodiscard]] bool has_room_for(std::size_t bytes) const {
    return end_ - start_ + bytes <= bytes_.size();
  }

  // REQUIRES: has_room_for(bytes.size()). COSTS: moves what is pending when the end is reached.
  void put(std::string_view bytes);

  // The first `count` bytes have left. REQUIRES: count <= pending().size().
  void written(std::size_t count);

  // Drops all that has not left.
  void clear() { start_ = end_ = 0; }

 private:
  std::array<std::byte, kOutputBytesMax> bytes_{};
  std::size_t start_ = 0;
  std::size_t end_ = 0;
};

}  // namespace firmware_link
