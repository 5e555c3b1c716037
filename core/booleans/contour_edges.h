// The edges of every ring that takes part in one boolean operation, in one flat array.
//
//     points   a0 a1 a2 a0 | b0 b1 b2 b3 b0 | …       edge e runs from points[e] to points[e + 1]
//     edges    0  1  2     | 4  5  6  7     | …
//
// A ring's weight is what crossing it from right to left adds to the winding number. So every
// operation is a question about one sum (winding_rule.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry.h"  // Point, Ring

namespace core {

// Of edges; the first of a ring is also the number of its first point.
using EdgeIndex = std::uint32_t;

struct ContourRing {
  EdgeIndex first = 0;
  EdgeIndex end = 0;  // one behind the last edge
  std::int32_t weight = 0;
  std::uint32_t operand = 0;

  [[nodiscard]] std::uint32_t size() const { return end - first; }
};

class ContourEdges {
 public:
  // Memory is kept for the next operation.
  void clear();

  // REQUIRES: coordinates within ±kCoordinateMax; operands come in ascending order; the ring has
  // no repeated neighbours and at least 3 points.
  void add(const Ring& ring, std::int32_t weight, std::uint32_t operand);

  // The same for a ring of any kind. Repeated points are left out, and corners at which the ring
  // runs straight on or straight back. That changes no winding number. Nothing may be left.
  void add_mended(const Ring& ring, std::int32_t weight, std::uint32_t operand);

  [[nodiscard]] std::span<const ContourRing> rings() const { return rings_; }
  // The size of an array by edge (some of it stays unused).
  [[nodiscard]] std::uint32_t index_end() const {
    return static_cast<std::uint32_t>(points_.size());
  }
  [[nodiscard]] Point from(EdgeIndex edge) const { return points_[edge]; }
  [[nodiscard]] Point to(EdgeIndex edge) const { return points_[edge + 1]; }
  // Neighbours on the ring.
  [[nodiscard]] EdgeIndex before(EdgeIndex edge) const {
    return edge == ring(edge).first ? ring(edge).end - 1 : edge - 1;
  }
  [[nodiscard]] EdgeIndex after(EdgeIndex edge) const {
    return edge + 1 == ring(edge).end ? ring(edge).first : edge + 1;
  }
  [[nodiscard]] std::uint32_t ring_index(EdgeIndex edge) const { return ring_of_[edge]; }
  [[nodiscard]] const ContourRing& ring(EdgeIndex edge) const { return rings_[ring_of_[edge]]; }
  [[nodiscard]] const Point* points() const { return points_.data(); }
  // |dx| + |dy| of all edges.
  [[nodiscard]] std::uint64_t length_units() const { return length_units_; }

 private:
  void close_ring(EdgeIndex first, std::int32_t weight, std::uint32_t operand);

  std::vector<Point> points_;
  std::vector<std::uint32_t> ring_of_;
  std::vector<ContourRing> rings_;
  std::uint64_t length_units_ = 0;
};

}  // namespace core
