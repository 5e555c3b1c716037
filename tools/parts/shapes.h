// Pieces of curved parts: rings of corners, and the bands between them.
#pragma once

#include <functional>
#include <numbers>
#include <vector>

#include "tools/parts/part_maker.h"  // Corner, FacetSink

namespace parts {

inline constexpr double kPi = std::numbers::pi;

// Closed, counter-clockwise seen from above.
using CornerRing = std::vector<Corner>;

// Split along a-c; counter-clockwise seen from outside.
void quad(const FacetSink& sink, Corner a, Corner b, Corner c, Corner d);

[[nodiscard]] CornerRing circle(int corners, double radius, Corner centre);

// Radius of a wall at an angle (radians) and a height.
using Wall = std::function<double(double angle, double z)>;
[[nodiscard]] CornerRing wall_ring(const Wall& wall, int corners, Corner centre);

// A band between two rings with equally many corners. Its outside is away from the axis, or
// towards it.
enum class Facing { kOutward, kInward };
void band(const FacetSink& sink, const CornerRing& low, const CornerRing& high, Facing facing);

// A flat ring between two contours with equally many corners, or a cap on one.
enum class Looking { kUp, kDown };
void flat_ring(const FacetSink& sink, const CornerRing& outer, const CornerRing& inner,
               Looking looking);
void cap(const FacetSink& sink, const CornerRing& ring, Corner centre, Looking looking);

// A tube between two walls, from the centre's height up, in `steps` bands.
struct TubeShape {
  int corners = 0;
  int steps = 0;
  double height = 0;
  Wall outer;
  Wall inner;
};
void tube_between(const FacetSink& sink, const TubeShape& shape, Corner centre);

}  // namespace parts
