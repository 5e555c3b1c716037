// Distances between paths of straight lines and arcs, by brute force.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace test {

using PathPoint = std::array<double, 2>;
using Path = std::vector<PathPoint>;

// Points along an arc, at most `step` apart, without the start, with the exact end.
inline void add_arc(PathPoint from, PathPoint to, PathPoint centre, bool clockwise, double step,
                    Path& path) {
  const double begin = std::atan2(from[1] - centre[1], from[0] - centre[0]);
  const double end = std::atan2(to[1] - centre[1], to[0] - centre[0]);
  const double side = clockwise ? -1 : 1;
  double turn = (end - begin) * side;
  while (turn <= 0) turn += 2 * std::numbers::pi;
  const double radius = std::hypot(from[0] - centre[0], from[1] - centre[1]);
  const int steps = 1 + static_cast<int>(turn * radius / step);
  for (int i = 1; i < steps; ++i) {
    const double angle = begin + side * turn * i / steps;
    path.push_back({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  path.push_back(to);
}

inline double distance_to_segment(PathPoint p, PathPoint a, PathPoint b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double squared = dx * dx + dy * dy;
  const double along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
  const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

// Largest distance of one path's points from the other's lines, both divided into steps of `step`.
inline double farthest_off(const Path& path, const Path& other, double step) {
  double farthest = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double size = std::hypot(path[i][0] - path[i - 1][0], path[i][1] - path[i - 1][1]);
    const int steps = 1 + static_cast<int>(size / step);
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const PathPoint at = {path[i - 1][0] + t * (path[i][0] - path[i - 1][0]),
                            path[i - 1][1] + t * (path[i][1] - path[i - 1][1])};
      double nearest = INFINITY;
      for (std::size_t j = 1; j < other.size() && nearest > farthest; ++j) {
        nearest = std::min(nearest, distance_to_segment(at, other[j - 1], other[j]));
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

}  // namespace test
