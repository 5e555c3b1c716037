// The outermost corners in each of the six directions, with their facets. A mesh that is far too
// large is often so because of one or two stray corners.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "core/geometry.h"  // Triangle, Vertex

namespace host {

// At most so many corners at one end are taken as stray: a solid that ends flat has at least three
// there.
inline constexpr std::size_t kStrayCornersMax = 2;

enum class Direction { kLeft, kRight, kFront, kBack, kDown, kUp };
inline constexpr std::size_t kDirections = 6;

struct FacetCorner {
  core::Vertex at;
  std::int64_t facet = 0;  // counted from 1, in the file's order
};

// "facet 13 has a corner at 0, 0, 20 mm", in the file's own coordinates.
[[nodiscard]] std::string corner_text(const FacetCorner& corner);

class OutermostCorners {
 public:
  // `upwards`: whether its corners count in direction kUp; those of a facet that no plane crosses
  // don't.
  void add(const core::Triangle& triangle, std::int64_t facet, bool upwards) {
    for (const core::Vertex& at : triangle.corners) {
      // Fast path: hardly any corner lies farther out than the known ones.
      if (-std::int64_t{at.x} > limits_[0]) offer(Direction::kLeft, {at, facet});
      if (at.x > limits_[1]) offer(Direction::kRight, {at, facet});
      if (-std::int64_t{at.y} > limits_[2]) offer(Direction::kFront, {at, facet});
      if (at.y > limits_[3]) offer(Direction::kBack, {at, facet});
      if (-at.z > limits_[4]) offer(Direction::kDown, {at, facet});
      if (at.z > limits_[5] && upwards) offer(Direction::kUp, {at, facet});
    }
  }

  // How much less far the mesh would reach in a direction without its kStrayCornersMax outermost
  // corners.
  struct End {
    FacetCorner corner;      // the outermost
    std::int64_t alone = 0;  // units that only these corners reach
    std::int64_t rest = 0;   // where the other corners end, on the axis
  };
  // Nullopt if there are too few corners.
  [[nodiscard]] std::optional<End> end(Direction direction) const;

 private:
  // Farthest first, no two at the same point.
  struct Farthest {
    std::array<FacetCorner, kStrayCornersMax + 1> corners;
    std::size_t count = 0;
  };
  void offer(Direction direction, const FacetCorner& corner);

  std::array<Farthest, kDirections> ends_;
  // By Direction: how far the last of its corners reaches, once there are enough; kNone before.
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();
  std::array<std::int64_t, kDirections> limits_{kNone, kNone, kNone, kNone, kNone, kNone};
};

}  // namespace host
