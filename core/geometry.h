// Plain shapes on the 100 nm grid.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;
  auto operator<=>(const Point&) const = default;
};

// Of its bits the high ones are mixed best: multiplied by 2^64 over the golden ratio (Knuth).
[[nodiscard]] inline std::uint64_t hash_of(Point p) {
  const std::uint64_t both =
      std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32 | static_cast<std::uint32_t>(p.y);
  return (both ^ both >> 29) * 0x9E3779B97F4A7C15;
}

// Twice the signed area of the triangle a b c: positive when c is left of a -> b.
// Exact: coordinates are within ±2^29, so the products are below 2^62.
inline std::int64_t cross(Point a, Point b, Point c) {
  const std::int64_t abx = std::int64_t{b.x} - a.x, aby = std::int64_t{b.y} - a.y;
  const std::int64_t acx = std::int64_t{c.x} - a.x, acy = std::int64_t{c.y} - a.y;
  return abx * acy - aby * acx;
}

struct Segment {
  Point from;
  Point to;
  auto operator<=>(const Segment&) const = default;
};

// Closed polyline; the last point joins the first and is not repeated.
using Ring = std::vector<Point>;

// Closed on all sides. Empty when min.x > max.x, as by default.
struct Box {
  Point min{INT32_MAX, INT32_MAX};
  Point max{INT32_MIN, INT32_MIN};

  [[nodiscard]] bool empty() const { return min.x > max.x; }
  void add(Point p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  void add(const Box& other) {
    if (other.empty()) return;
    add(other.min);
    add(other.max);
  }
  [[nodiscard]] bool overlaps(const Box& other) const {
    return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y &&
           other.min.y <= max.y;
  }
  auto operator<=>(const Box&) const = default;
};

[[nodiscard]] inline Box box_of(const Ring& ring) {
  Box box;
  for (const Point p : ring) box.add(p);
  return box;
}
[[nodiscard]] inline Box box_of(const Segment& segment) {
  return {{std::min(segment.from.x, segment.to.x), std::min(segment.from.y, segment.to.y)},
          {std::max(segment.from.x, segment.to.x), std::max(segment.from.y, segment.to.y)}};
}

// Ring by ring, in their order; edge i of a ring starts at its point i.
[[nodiscard]] inline std::vector<Segment> edges_of(const std::vector<Ring>& rings) {
  std::vector<Segment> edges;
  std::size_t count = 0;
  for (const Ring& ring : rings) count += ring.size();
  edges.reserve(count);
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
    }
  }
  return edges;
}

// A corner of the mesh, snapped to the grid when it was read.
struct Vertex {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int64_t z = 0;
  auto operator<=>(const Vertex&) const = default;
};

// Counter-clockwise seen from outside the part.
struct Triangle {
  std::array<Vertex, 3> corners;

  [[nodiscard]] std::int64_t lowest_z() const {
    return std::min({corners[0].z, corners[1].z, corners[2].z});
  }
  [[nodiscard]] std::int64_t highest_z() const {
    return std::max({corners[0].z, corners[1].z, corners[2].z});
  }
};

}  // namespace core
