// The sites of a region's contours, in their order: edges, and the reflex corners between them.
//
//        ──edge──▶o          A disc that grows from a point of a site touches it along the
//      normal ↓    ╲ edge    normal there. Along an edge that is one direction; about a reflex
//      of the edge  ╲        corner they turn from the normal of the edge before to that of
//                    ▼       the edge after it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry.h"  // Ring
#include "core/vector.h"    // Vector

namespace core {

struct ContourSite {
  Vector at;      // the edge's start, or the corner
  Vector first;   // normals into the region where the site begins
  Vector last;    // and where it ends; of length 1
  double length;  // 0: a corner

  [[nodiscard]] bool is_corner() const { return length == 0; }
};

class ContourSites {
 public:
  explicit ContourSites(const std::vector<Ring>& rings);

  [[nodiscard]] const ContourSite& operator[](std::uint32_t site) const { return sites_[site]; }
  // Sites of ring i: from starts()[i] to starts()[i + 1].
  [[nodiscard]] const std::vector<std::uint32_t>& starts() const { return starts_; }

  static constexpr std::uint32_t kNone = UINT32_MAX;

  // The edge from a to b, or, where they are equal, the reflex corner there; kNone: there is none,
  // or there are two. COSTS: O(log n).
  [[nodiscard]] std::uint32_t find(Point a, Point b) const;

  // How far along the site a point is that touches it: units, or the angle from the first normal.
  [[nodiscard]] double parameter(std::uint32_t site, Vector point) const;

  // The direction in which a point lies from where it touches the site, and the place so far along
  // that direction.
  [[nodiscard]] Vector direction(std::uint32_t site, Vector point) const;
  [[nodiscard]] Vector foot(std::uint32_t site, Vector point) const;

 private:
  struct Name {
    Point a, b;
    std::uint32_t site = 0;
  };

  std::vector<ContourSite> sites_;
  std::vector<std::uint32_t> starts_;
  std::vector<Name> names_;  // sorted
};

}  // namespace core
