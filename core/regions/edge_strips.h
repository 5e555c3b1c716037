// Edges by height, for questions about what lies left and right of a point.
//
//     ────────────    The plane is cut into level strips, about as many as there are edges; each
//      ╱  ╲   ╱       knows the edges that reach into it. Tall edges make strips higher, so that
//     ╱────╲─╱────    all lists together hold kEntriesPerEdge numbers an edge, not more.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry.h"  // Box, Segment

namespace core {

class EdgeStrips {
 public:
  // COSTS: O(edges), time and memory. Level edges are in no strip.
  explicit EdgeStrips(std::vector<Segment> edges);

  [[nodiscard]] const Segment& operator[](std::uint32_t number) const { return edges_[number]; }

  // Numbers of the edges in the strip at this height, in their order; others don't reach it.
  [[nodiscard]] std::span<const std::uint32_t> at(std::int32_t y) const;

 private:
  static constexpr std::int64_t kEntriesPerEdge = 8;

  [[nodiscard]] std::int64_t strip(std::int64_t y) const { return (y - bottom_) / height_; }

  std::vector<Segment> edges_;
  std::int64_t bottom_ = 0;
  std::int64_t top_ = -1;
  std::int64_t height_ = 1;
  std::vector<std::uint32_t> starts_;   // by strip, into entries_
  std::vector<std::uint32_t> entries_;  // edges
};

}  // namespace core
