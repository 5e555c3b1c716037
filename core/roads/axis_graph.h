// The medial axis of a region up to a clearance, as a graph with straight edges.
//
// Its central edges run between two sides of the region. The others are spurs into corners of 30°
// and more, which have no beads of their own: those of the body go round them (ridge.h). Edges are
// split where a curve needs it, where the room passes a count's limit (beading.h), and wherever a
// user wants it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"             // Ring
#include "core/roads/beading.h"        // Beading, BeadState
#include "core/roads/contour_sites.h"  // ContourSites
#include "core/vector.h"               // Vector

namespace core {

struct VoronoiDiagram;

// Corners of 30° and more: 1 / sin 15°.
inline constexpr double kCornerReach = 3.86;
// A rib on a body that is longer than about half its width and this is no corner; of the spacing.
inline constexpr double kFlatMax = 0.4;

struct AxisNode {
  Vector at;
  double radius = 0;  // of the largest disc; linear along edges
  bool open = false;  // where the diagram was cut off: the axis goes on
};

struct AxisEdge {
  std::uint32_t from = 0;  // nodes
  std::uint32_t to = 0;
  std::uint32_t left = 0;  // sites on either side, going from `from` to `to`
  std::uint32_t right = 0;
  bool central = false;
  int count = 0;          // of beads, where central
  BeadState states[2]{};  // at `from` and at `to`
};

class AxisGraph {
 public:
  // nullopt: the region's contours touch, or no diagram passes its checks.
  // REQUIRES: a clean region's rings.
  [[nodiscard]] static std::optional<AxisGraph> make(const std::vector<Ring>& rings,
                                                     const Beading& beading);

  [[nodiscard]] const std::vector<AxisNode>& nodes() const { return nodes_; }
  [[nodiscard]] std::vector<AxisEdge>& edges() { return edges_; }
  [[nodiscard]] const std::vector<AxisEdge>& edges() const { return edges_; }
  [[nodiscard]] const ContourSites& sites() const { return sites_; }

  [[nodiscard]] double length(const AxisEdge& edge) const;

  // A new node at this share of the edge, which ends there now; a new edge goes on.
  // ENSURES: the new edge and the new node are the last ones. REQUIRES: 0 < share < 1.
  std::uint32_t split(std::uint32_t edge, double share);

 private:
  explicit AxisGraph(ContourSites sites) : sites_(std::move(sites)) {}

  bool add_edges(const VoronoiDiagram& diagram, double clearance, const Beading& beading);
  void add_central(std::uint32_t edge, const Beading& beading);

  ContourSites sites_;
  std::vector<AxisNode> nodes_;
  std::vector<AxisEdge> edges_;
};

// Edges by node.
class EdgesAt {
 public:
  // Of those edges for which `chosen` is true.
  template <typename Chosen>
  EdgesAt(const AxisGraph& graph, const Chosen& chosen) : starts_(graph.nodes().size() + 1, 0) {
    for (const AxisEdge& edge : graph.edges()) {
      if (!chosen(edge)) continue;
      ++starts_[edge.from];
      ++starts_[edge.to];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) start = (sum += start);
    edges_.resize(sum);
    for (std::uint32_t i = 0; i < graph.edges().size(); ++i) {
      if (!chosen(graph.edges()[i])) continue;
      edges_[--starts_[graph.edges()[i].from]] = i;
      edges_[--starts_[graph.edges()[i].to]] = i;
    }
  }

  [[nodiscard]] std::uint32_t count(std::uint32_t node) const {
    return starts_[node + 1] - starts_[node];
  }
  [[nodiscard]] const std::uint32_t* begin(std::uint32_t node) const {
    return edges_.data() + starts_[node];
  }
  [[nodiscard]] const std::uint32_t* end(std::uint32_t node) const {
    return edges_.data() + starts_[node + 1];
  }
  // The other edge at a node that has two.
  [[nodiscard]] std::uint32_t other(std::uint32_t node, std::uint32_t edge) const {
    return *begin(node) != edge ? *begin(node) : *(begin(node) + 1);
  }

 private:
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> edges_;
};

}  // namespace core
