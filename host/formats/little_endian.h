// Reads little-endian numbers of binary files.
#pragma once

#include <bit>
#include <cstdint>

namespace host {

// REQUIRES: 2 bytes.
[[nodiscard]] inline std::uint16_t u16_at(const char* bytes) {
  return static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[0]) |
                                    static_cast<unsigned char>(bytes[1]) << 8);
}

// REQUIRES: 4 bytes.
[[nodiscard]] inline std::uint32_t u32_at(const char* bytes) {
  return std::uint32_t{u16_at(bytes)} | std::uint32_t{u16_at(bytes + 2)} << 16;
}

// REQUIRES: 4 bytes.
[[nodiscard]] inline double float_at(const char* bytes) {
  return std::bit_cast<float>(u32_at(bytes));
}

}  // namespace host
