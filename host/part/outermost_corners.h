// The corners that lie farthest out in each of the six directions, and from which facets they are:
// a mesh that is far larger than it should be is often so by one or two corners that went astray.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "core/geometry.h"  // Triangle, Vertex

namespace host {

// So many corners at one end are thought to have gone astray, and no more: a solid that ends flat
// has at least three there.
inline constexpr std::size_t kStrayCornersMax = 2;

enum class Direction { kLeft, kRight, kFront, kBack, kDown, kUp };
inline constexpr std::size_t kDirections = 6;

struct FacetCorner {
  core::Vertex at;
  std::int64_t facet = 0;  // counted from 1, in the file's order
};

// "facet 13 has a corner at 0, 0, 20 mm", in the file's own place.
[[nodiscard]] std::string corner_text(const FacetCorner& corner);

class OutermostCorners {
 public:
  // `upwards`: whether its highest corners count; of a facet that no plane crosses they do not.
  void add(const core::Triangle& triangle, std::int64_t facet, bool upwards) {
    for (const core::Vertex& at : triangle.corners) {
      // Hardly any corner lies farther out than those that are known.
      if (-std::int64_t{at.x} > limits_[0]) offer(Direction::kLeft, {at, facet});
      if (at.x > limits_[1]) offer(Direction::kRight, {at, facet});
      if (-std::int64_t{at.y} > limits_[2]) offer(Direction::kFront, {at, facet});
      if (at.y > limits_[3]) offer(Direction::kBack, {at, facet});
      if (-at.z > limits_[4]) offer(Direction::kDown, {at, facet});
      if (at.z > limits_[5] && upwards) offer(Direction::kUp, {at, facet});
    }
  }

  // The end of the mesh in that direction, as far as at most kStrayCornersMax corners make it: how
  // far it would reach less without them, and the outermost of them.
  struct End {
    FacetCorner corner;
    std::int64_t alone = 0;  // units that only these corners reach
    std::int64_t rest = 0;   // where the others end, on the axis
  };
  // Nothing: there are too few corners.
  [[nodiscard]] std::optional<End> end(Direction direction) const;

 private:
  // Farthest first, no two at one place.
  struct Farthest {
    std::array<FacetCorner, kStrayCornersMax + 1> corners;
    std::size_t count = 0;
  };
  void offer(Direction direction, const FacetCorner& corner);

  std::array<Farthest, kDirections> ends_;
  // How far the last one of each reaches, when there are enough. By Direction.
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::min();
  std::array<std::int64_t, kDirections> limits_{kNone, kNone, kNone, kNone, kNone, kNone};
};

}  // namespace host
