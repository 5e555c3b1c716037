// A 64-bit hash of bytes: FNV-1a (Fowler, Noll, Vo, 1991). It protects against mistakes, not
// against malice.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"  // Result

namespace host {

inline constexpr std::uint64_t kHashStart = 14'695'981'039'346'656'037U;

[[nodiscard]] constexpr std::uint64_t hash_of(std::string_view bytes,
                                              std::uint64_t before = kHashStart) {
  for (const char byte : bytes) {
    before = (before ^ static_cast<unsigned char>(byte)) * 1'099'511'628'211U;
  }
  return before;
}

struct FileContent {
  std::uint64_t hash = kHashStart;
  std::int64_t bytes = 0;
};

// Reads the whole file through one buffer of fixed size. COSTS: about 1 ns a byte, and the reading.
[[nodiscard]] core::Result<FileContent> content_of(const std::string& path);

// Of several files in their order; of one file, its own.
[[nodiscard]] core::Result<FileContent> contents_of(const std::vector<std::string>& paths);

}  // namespace host
