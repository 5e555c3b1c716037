#include "host/part/height_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

constexpr int kNumberBits = 32;
constexpr std::uint64_t kHeightMax = std::numeric_limits<std::uint32_t>::max();

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

}  // namespace

void HeightOrder::sort(const std::vector<core::Triangle>& triangles) {
  RIND_CHECK(triangles.size() <= std::numeric_limits<std::uint32_t>::max());
  std::int64_t lowest = INT64_MAX, highest = INT64_MIN, before = INT64_MIN;
  bool in_order = true;
  for (const core::Triangle& triangle : triangles) {
    const std::int64_t z = triangle.lowest_z();
    in_order = in_order && z >= before;
    before = z;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  // Modulo 2^64, so that every two heights have a difference.
  const auto above = [lowest](std::int64_t z) {
    return static_cast<std::uint64_t>(z) - static_cast<std::uint64_t>(lowest);
  };
  keys_.resize(triangles.size());
  const bool fits = above(highest) <= kHeightMax;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    keys_[i] = i | (fits ? above(triangles[i].lowest_z()) << kNumberBits : 0);
  }
  if (in_order) return;
  if (fits) return sort_by_digits(above(highest));
  std::sort(keys_.begin(), keys_.end(), [&](std::uint64_t a, std::uint64_t b) {
    const std::int64_t za = triangles[a].lowest_z(), zb = triangles[b].lowest_z();
    return za != zb ? za < zb : a < b;
  });
}

void HeightOrder::sort_by_digits(std::uint64_t highest) {
  spare_.resize(keys_.size());
  for (int shift = 0; highest >> shift != 0; shift += kDigitBits) {
    const auto digit = [shift](std::uint64_t key) {
      return static_cast<std::size_t>(key >> (kNumberBits + shift)) % kDigits;
    };
    std::array<std::uint32_t, kDigits> places{};
    for (const std::uint64_t key : keys_) ++places[digit(key)];
    if (places[digit(keys_.front())] == keys_.size()) continue;
    std::uint32_t next = 0;
    for (std::uint32_t& place : places) next += std::exchange(place, next);
    for (const std::uint64_t key : keys_) spare_[places[digit(key)]++] = key;
    keys_.swap(spare_);
  }
  spare_ = {};
}

}  // namespace host
