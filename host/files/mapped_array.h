// A growing array that moves to a memory-mapped temporary file without a name once it is large. The
// system may then write its pages to disk.
//
// For data with random access: the vertices of an OBJ, SIF, AMF or 3MF file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/check.h"   // RIND_CHECK
#include "core/result.h"  // Status

namespace host {

class MappedBytes {
 public:
  // Up to this size the bytes are in plain memory.
  static constexpr std::size_t kInMemoryMax = std::size_t{1} << 20;

  MappedBytes() = default;
  ~MappedBytes();
  MappedBytes(const MappedBytes&) = delete;
  MappedBytes& operator=(const MappedBytes&) = delete;

  // Appends zeros up to `size`. Errors: a full disk; a folder ($TMPDIR, or /tmp) that can't be
  // written to. COSTS: amortised O(bytes appended).
  [[nodiscard]] core::Status grow(std::size_t size);

  [[nodiscard]] const char* data() const { return mapped_ != nullptr ? mapped_ : held_.data(); }
  [[nodiscard]] char* data() { return mapped_ != nullptr ? mapped_ : held_.data(); }
  [[nodiscard]] std::size_t capacity() const {
    return mapped_ != nullptr ? mapped_bytes_ : held_.size();
  }

 private:
  [[nodiscard]] core::Status map(std::size_t bytes);

  std::vector<char> held_;
  int descriptor_ = -1;
  char* mapped_ = nullptr;
  std::size_t mapped_bytes_ = 0;
};

template <typename T>
class MappedArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  [[nodiscard]] core::Status push_back(const T& value) {
    const std::size_t end = (size_ + 1) * sizeof(T);
    if (end > bytes_.capacity()) {
      if (core::Status grown = bytes_.grow(end); !grown.ok()) return grown;
    }
    std::memcpy(bytes_.data() + size_ * sizeof(T), &value, sizeof(T));
    ++size_;
    return {};
  }

  // REQUIRES: i < size()
  [[nodiscard]] T at(std::size_t i) const {
    RIND_CHECK(i < size_);
    T value;
    std::memcpy(&value, bytes_.data() + i * sizeof(T), sizeof(T));
    return value;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  // Keeps the memory for new elements.
  void clear() { size_ = 0; }

 private:
  MappedBytes bytes_;
  std::size_t size_ = 0;
};

}  // namespace host
