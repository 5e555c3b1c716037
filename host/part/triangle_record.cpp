#include "host/part/triangle_record.h"

#include <array>
#include <cstdint>

namespace host {
namespace {

// Differences are modulo 2^64, so that every pair of heights has one.
char* put(std::int64_t from, std::int64_t to, char* into) {
  const std::uint64_t way = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
  std::uint64_t left = way << 1 ^ (way >> 63 != 0 ? UINT64_MAX : 0);
  while (left >= 0x80) {
    *into++ = static_cast<char>(left | 0x80);
    left >>= 7;
  }
  *into++ = static_cast<char>(left);
  return into;
}

std::int64_t get(std::int64_t from, const char*& bytes) {
  std::uint64_t read = 0;
  for (int shift = 0;; shift += 7) {
    const auto byte = static_cast<unsigned char>(*bytes++);
    read |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
    if (byte < 0x80) break;
  }
  const std::uint64_t way = read >> 1 ^ ((read & 1) != 0 ? UINT64_MAX : 0);
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(from) + way);
}

}  // namespace

void write_triangle(const core::Triangle& triangle, const core::Vertex& before, std::string& into) {
  std::array<char, kTriangleRecordBytesMax> record;
  char* end = record.data();
  const core::Vertex* base = &before;
  for (const core::Vertex& corner : triangle.corners) {
    end = put(base->x, corner.x, end);
    end = put(base->y, corner.y, end);
    end = put(base->z, corner.z, end);
    base = triangle.corners.data();
  }
  into.append(record.data(), end);
}

const char* read_triangle(const char* bytes, const core::Vertex& before, core::Triangle& triangle) {
  const core::Vertex* base = &before;
  for (core::Vertex& corner : triangle.corners) {
    corner.x = static_cast<std::int32_t>(get(base->x, bytes));
    corner.y = static_cast<std::int32_t>(get(base->y, bytes));
    corner.z = get(base->z, bytes);
    base = triangle.corners.data();
  }
  return bytes;
}

}  // namespace host
