// Which winding numbers count as inside. Every operation on regions is one of these questions:
//
//     rings weighted 1 each                winding > 0     union
//     operands a and b                     winding >= 2    intersection
//     a weighted 1, b weighted -1          winding > 0     a − b
//     a weighted 1, b weighted -1          winding != 0    a xor b
//     rings weighted 1 each                winding odd     contours that nest, turned as they like
#pragma once

#include <cstdint>

namespace core {

struct WindingRule {
  enum class Kind { kAtLeast, kNonZero, kOdd };
  Kind kind = Kind::kAtLeast;
  std::int32_t least = 1;

  [[nodiscard]] bool inside(std::int32_t winding) const {
    switch (kind) {
      case Kind::kNonZero:
        return winding != 0;
      case Kind::kOdd:
        return winding % 2 != 0;
      case Kind::kAtLeast:
        break;
    }
    return winding >= least;
  }
};

}  // namespace core
