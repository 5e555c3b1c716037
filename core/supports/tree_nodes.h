// The branches of trees, cut by one layer: a list of nodes that goes down with the layers.
//
//     layer n+1    o   o     o        nodes move towards one another, by a step at most, and away
//                   ╲ ╱     ╱         from the part; where one lies within another, they are one
//     layer n        O     o          branch, as stiff as both
//
// A node is free to move where its own way down allows it: to the bed while it is outside what
// tree_reach.h avoids, else to the part, which it comes down on.
//
// SOURCE: nodes that are drawn towards their nearest neighbours from the top down are Cura's and
// PrusaSlicer's tree supports, and those of Vanek et al., Clever Support (2014). Merged branches
// here keep the sum of r^4, to which a rod's stiffness is proportional.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry.h"                // Point
#include "core/settings.h"                // Settings
#include "core/supports/tree_obstacle.h"  // TreeObstacle
#include "core/units.h"                   // Length

namespace core {

// More branches don't start. 1.5 MiB; a ceiling of 600 mm by 600 mm needs 40,000 to begin with.
inline constexpr std::size_t kTreeNodesMax = 65'536;

struct TreeNode {
  Point at;
  double radius = 0;    // in units
  bool to_bed = false;  // else it comes down on the part, or is not known to do neither
};

// What nodes meet in a layer.
struct TreeLayer {
  Length bottom;                          // of the layer, over the bed
  Length height;                          // of the layer
  Length step;                            // that nodes have moved by at most
  const TreeObstacle* avoided = nullptr;  // by those that go to the bed
  const TreeObstacle* blocked = nullptr;  // for all others; null: there are none

  [[nodiscard]] const TreeObstacle& around(const TreeNode& node) const {
    return node.to_bed || blocked == nullptr ? *avoided : *blocked;
  }
};

class TreeNodes {
 public:
  // REQUIRES: settings in their ranges.
  explicit TreeNodes(const Settings& settings) : settings_(settings) {}

  // One layer down. COSTS: O(nodes · neighbours by x).
  void descend(const TreeLayer& layer);

  // A new branch, unless there are kTreeNodesMax.
  void start(const TreeNode& node);

  // Leaves out those for which it is true.
  template <typename Ends>
  void end_where(const Ends& ends) {
    std::erase_if(nodes_, ends);
  }

  // By position: x, then y.
  [[nodiscard]] const std::vector<TreeNode>& all() const { return nodes_; }

  // Whether one stands within the distance.
  [[nodiscard]] bool any_near(Point point, Length distance) const;

 private:
  void sort();
  [[nodiscard]] std::optional<Point> goal(std::size_t number, const TreeLayer& layer) const;
  [[nodiscard]] std::vector<std::size_t> neighbours(std::size_t number, double within) const;
  [[nodiscard]] Point moved(const TreeNode& node, std::optional<Point> goal,
                            const TreeLayer& layer) const;
  void merge();
  [[nodiscard]] double grown(double radius, const TreeLayer& layer) const;

  Settings settings_;
  std::vector<TreeNode> nodes_;
};

}  // namespace core
