// Shapes from a seed. The same seed gives the same shape everywhere.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/geometry.h"        // Ring
#include "core/regions/region.h"  // Region

namespace test {

// std distributions differ from library to library; these don't.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  // In [low, high], both included.
  int integer(int low, int high) { return low + static_cast<int>(unit() * (high - low + 1)); }

 private:
  std::mt19937_64 engine_;
};

// Points anywhere in a square: crosses itself all over.
core::Ring random_ring(Random& random, int points, double size_mm);

// A closed curve about a centre, its radius wavering; counter-clockwise, does not cross itself.
core::Ring random_blob(Random& random, int points, double x_mm, double y_mm, double radius_mm,
                       double roughness);

// Blobs united and holes subtracted: islands, holes, needles, about `points` points in all.
core::Region random_region(Random& random, int points, double size_mm);

}  // namespace test
