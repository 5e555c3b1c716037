// Offset elements by their definition, for tests of the steps of polygon_offset.h: the point of an
// edge's line or of a corner's arc, and its distance to all edges, one by one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/offsets/offset_input.h"

namespace test {

struct ElementPoint {
  double x = 0;
  double y = 0;
};

// On the line at `depth` to the left of edge i, `along` units from the edge's start.
inline ElementPoint on_line(const core::OffsetInput& contours, std::size_t i, double along,
                            double depth) {
  const core::OffsetEdge& edge = contours.edges()[i];
  const double ux = edge.dx * edge.inverse_length, uy = edge.dy * edge.inverse_length;
  return {edge.x + ux * along - uy * depth, edge.y + uy * along + ux * depth};
}

// On the arc about the reflex corner i; `share` 0 … 1 from the edge before it to its own.
inline ElementPoint on_arc(const core::OffsetInput& contours, std::size_t i, double share,
                           double depth) {
  const core::OffsetEdge& edge = contours.edges()[i];
  const core::OffsetEdge& before = contours.edges()[static_cast<std::size_t>(edge.previous)];
  const double from = std::atan2(before.dx, -before.dy);
  double turn = std::atan2(edge.dx, -edge.dy) - from;
  if (turn > 0) turn -= 2 * std::acos(-1.0);
  const double angle = from + share * turn;
  return {edge.x + depth * std::cos(angle), edge.y + depth * std::sin(angle)};
}

inline double distance_to_edge(const core::OffsetEdge& edge, ElementPoint p) {
  const double px = p.x - edge.x, py = p.y - edge.y;
  const double t = std::clamp(
      (px * edge.dx + py * edge.dy) * edge.inverse_length * edge.inverse_length, 0.0, 1.0);
  return std::hypot(px - t * edge.dx, py - t * edge.dy);
}

inline double distance_to_all(const core::OffsetInput& contours, ElementPoint p) {
  double nearest = std::numeric_limits<double>::max();
  for (const core::OffsetEdge& edge : contours.edges()) {
    nearest = std::min(nearest, distance_to_edge(edge, p));
  }
  return nearest;
}

}  // namespace test
