#pragma once

#include <cmath>
#include <cstdint>

#include "core/regions/region.h"  // Region

namespace test {

// From its lower left corner; millimetres.
inline core::Region rectangle(double x, double y, double width, double height) {
  const auto units = [](double mm) { return static_cast<std::int32_t>(std::lround(mm * 1e4)); };
  return core::Region::from_clean_rings({{{units(x), units(y)},
                                          {units(x + width), units(y)},
                                          {units(x + width), units(y + height)},
                                          {units(x), units(y + height)}}});
}

}  // namespace test
