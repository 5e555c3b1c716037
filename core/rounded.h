// Rounding to the grid without a call of the C library, which takes several times as long.
#pragma once

#include <cstdint>

#include "core/geometry.h"  // Point
#include "core/vector.h"    // Vector

namespace core {

// The nearest whole number, halves away from zero. REQUIRES: |value| < 2^31 − 1.
[[nodiscard]] inline std::int32_t rounded(double value) {
  return static_cast<std::int32_t>(value + (value < 0 ? -0.5 : 0.5));
}

[[nodiscard]] inline Point rounded(Vector at) { return {rounded(at.x), rounded(at.y)}; }

}  // namespace core
