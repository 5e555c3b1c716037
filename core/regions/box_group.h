// Eight boxes, which are compared with another one at once.
//
// Written with vectors of four numbers, as GCC and Clang have them on every processor. Compared one
// by one, boxes would cost several times as much, most of it for branches that nothing predicts.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "core/geometry.h"  // Box, Point

namespace core {

class BoxGroup {
  using Lanes [[gnu::vector_size(16)]] = std::int32_t;
  static Lanes all(std::int32_t value) { return Lanes{value, value, value, value}; }

 public:
  static constexpr std::uint32_t kSize = 8;

  // Empty boxes, which overlap nothing.
  BoxGroup() {
    left_.fill(INT32_MAX);
    bottom_.fill(INT32_MAX);
    right_.fill(INT32_MIN);
    top_.fill(INT32_MIN);
  }

  void set(std::uint32_t lane, const Box& box) {
    left_[lane] = box.min.x;
    bottom_[lane] = box.min.y;
    right_[lane] = box.max.x;
    top_[lane] = box.max.y;
  }
  [[nodiscard]] Box box(std::uint32_t lane) const {
    return {{left_[lane], bottom_[lane]}, {right_[lane], top_[lane]}};
  }

  // The boxes of eight edges, each from one of the points to the next. REQUIRES: 9 points.
  void set_edges(const Point* points) {
    set_four_edges(points, 0);
    set_four_edges(points + 4, 4);
  }

  // Around all of them.
  [[nodiscard]] Box around() const {
    return {{least(left_), least(bottom_)}, {greatest(right_), greatest(top_)}};
  }

  // The longest of the boxes' shorter sides. REQUIRES: none is empty.
  [[nodiscard]] std::int32_t widest() const {
    std::array<std::int32_t, kSize> shorter;
    for (std::size_t i = 0; i < kSize; i += 4) {
      const Lanes width = load(&right_[i]) - load(&left_[i]);
      const Lanes height = load(&top_[i]) - load(&bottom_[i]);
      store(lesser(width, height), &shorter[i]);
    }
    return greatest(shorter);
  }

  // A box that many groups are compared with.
  class Query {
   public:
    explicit Query(const Box& box)
        : left_(all(box.min.x)),
          bottom_(all(box.min.y)),
          right_(all(box.max.x)),
          top_(all(box.max.y)) {}

   private:
    friend class BoxGroup;
    Lanes left_, bottom_, right_, top_;
  };

  // Bit i is set when box i overlaps this one.
  [[nodiscard]] std::uint32_t overlapping(const Query& box) const {
    const Lanes low = half(box, 0, Lanes{1, 2, 4, 8});
    const Lanes high = half(box, 4, Lanes{16, 32, 64, 128});
    std::array<std::uint64_t, 2> pairs;
    const Lanes both = low | high;
    std::memcpy(pairs.data(), &both, sizeof both);
    const std::uint64_t pair = pairs[0] | pairs[1];
    return static_cast<std::uint32_t>(pair | pair >> 32);
  }
  [[nodiscard]] std::uint32_t overlapping(const Box& box) const { return overlapping(Query(box)); }

 private:
  static Lanes load(const std::int32_t* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
  }
  static void store(Lanes lanes, std::int32_t* to) { std::memcpy(to, &lanes, sizeof lanes); }
  static Lanes lesser(Lanes a, Lanes b) { return a < b ? a : b; }
  static Lanes greater(Lanes a, Lanes b) { return a > b ? a : b; }
  static std::int32_t least(const std::array<std::int32_t, kSize>& values) {
    const Lanes four = lesser(load(&values[0]), load(&values[4]));
    return std::min(std::min(four[0], four[1]), std::min(four[2], four[3]));
  }
  static std::int32_t greatest(const std::array<std::int32_t, kSize>& values) {
    const Lanes four = greater(load(&values[0]), load(&values[4]));
    return std::max(std::max(four[0], four[1]), std::max(four[2], four[3]));
  }

  void set_four_edges(const Point* points, std::size_t first) {
    std::array<Lanes, 2> x, y;  // of the points before and behind
    for (std::size_t i = 0; i < 2; ++i) {
      const Lanes two = load(&points[i].x), other_two = load(&points[i + 2].x);
      x[i] = __builtin_shufflevector(two, other_two, 0, 2, 4, 6);
      y[i] = __builtin_shufflevector(two, other_two, 1, 3, 5, 7);
    }
    store(lesser(x[0], x[1]), &left_[first]);
    store(lesser(y[0], y[1]), &bottom_[first]);
    store(greater(x[0], x[1]), &right_[first]);
    store(greater(y[0], y[1]), &top_[first]);
  }

  [[nodiscard]] Lanes half(const Query& box, std::size_t first, Lanes bits) const {
    const Lanes apart = (load(&left_[first]) > box.right_) | (load(&bottom_[first]) > box.top_) |
                        (box.left_ > load(&right_[first])) | (box.bottom_ > load(&top_[first]));
    return ~apart & bits;
  }

  alignas(16) std::array<std::int32_t, kSize> left_, bottom_, right_, top_;
};

// visit(lane) for the bits that are set.
template <typename Visit>
inline void for_lanes(std::uint32_t bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::uint32_t>(std::countr_zero(bits)));
}

}  // namespace core
