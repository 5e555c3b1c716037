// The ridge of the Voronoi mountain inside a region, without the spurs into its corners.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram

namespace core {

// What is taken for a corner: a disc of radius r in it lies r · reach from its tip, and the sine of
// half its angle is 1 / reach.
struct CornerRule {
  double reach = 2;  // of radii: 1 / sin of half the angle; 2 for 60°
  // Discs of this radius and more may widen more slowly than that, but only for such a length: a
  // short rib on a wide body is no corner.
  double radius_min = std::numeric_limits<double>::infinity();
  double flat_max = 0;
};

// A graph on the diagram's vertices; edges are named by one of their halves.
class Ridge {
 public:
  // The diagram is cut off at `open_height`. Lines that reach it are not free ends: what ends there
  // is treated as if it ended in a fork.
  // REQUIRES: diagram outlives the ridge.
  Ridge(const VoronoiDiagram& diagram, double open_height);

  // A spur, the branch from a free end to the first fork, goes when it reaches beyond the disc
  // about that fork by no more than in a corner of `rule.reach`. What spurs of its own a branch
  // has lost counts as its reach. Where all branches of a fork would go, the two that reach
  // farthest stay.
  // COSTS: O(edges) for each generation of spurs on spurs.
  void drop_spurs(const CornerRule& rule = {});

  // Halves of the edges that are left, one for each.
  [[nodiscard]] std::vector<std::uint32_t> edges() const;

  // On the region's contour, where a line ends even if another one starts there.
  [[nodiscard]] bool on_contour(std::uint32_t vertex) const;

 private:
  struct Branch {
    std::vector<std::uint32_t> edges;
    std::uint32_t end = 0;
    double reach = 0;  // from its end to the farthest that it covers
    double least = std::numeric_limits<double>::infinity();  // reach less what its disc would have
    bool corner = true;
  };

  [[nodiscard]] bool is_open(std::uint32_t vertex) const;
  [[nodiscard]] bool is_end(std::uint32_t vertex) const;
  [[nodiscard]] double length(std::uint32_t edge) const;
  [[nodiscard]] Branch branch_from(std::uint32_t edge, const CornerRule& rule) const;
  void widen(Branch& branch, std::uint32_t edge, const CornerRule& rule) const;
  [[nodiscard]] std::uint32_t only_other(std::uint32_t vertex, std::uint32_t edge) const;
  template <typename Visit>
  void for_leaving(std::uint32_t vertex, const Visit& visit) const;
  void remove(std::uint32_t edge);
  void remove(const Branch& branch);

  const VoronoiDiagram& diagram_;
  double open_height_;
  std::vector<std::uint32_t> starts_;   // by vertex, into leaving_
  std::vector<std::uint32_t> leaving_;  // halves, those that are left and those that went
  std::vector<std::uint8_t> left_;      // by half
  std::vector<std::uint32_t> degree_;   // by vertex: halves left that leave it
  std::vector<double> reach_;           // by vertex: how far discs ever reached
};

}  // namespace core
