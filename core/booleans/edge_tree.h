// Finds edges that are near: groups of eight boxes, boxes around the groups, and so on.
//
//     ┌───────────────┐     The lowest boxes hold an edge each, or a part of a long slanting edge.
//     │┌──┐ ┌────┐    │     A group's edges follow one another on a ring, as neighbours there are
//     ││╭─┼┐│   ╱│┌──┐│     near. Groups that follow one another are grouped again; where there are
//     │└┼─┘│└──╱─┘└──┘│     many rings, these are put in order by their places first.
//     └─┴──┴──────────┘
//
// Each operand has a tree of its own. So what meets across operands is found by comparing two trees
// from their roots down, and nothing is done where one operand alone is.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/booleans/contour_edges.h"  // ContourEdges, EdgeIndex
#include "core/geometry.h"                // Box, Point
#include "core/regions/box_group.h"       // BoxGroup
#include "core/regions/box_tree.h"        // RingOrder

namespace core {

// No operand's number.
inline constexpr std::uint32_t kNoOperand = UINT32_MAX;

class EdgeTree {
 public:
  // COSTS: O(edges + rings · log(rings)). Memory is kept for the next
  // operation.
  void build(const ContourEdges& edges);

  // In all that follow, an edge may come more than once if it has several parts.

  // visit(EdgeIndex) for all edges whose boxes overlap this one, without those of operand `but`.
  // The visitor may make the box smaller.
  template <typename Visit>
  void for_edges_in(const BoxGroup::Query& box, std::uint32_t but, Visit visit) const;
  template <typename Visit>
  void for_edges_in(const Box& box, std::uint32_t but, Visit visit) const {
    for_edges_in(BoxGroup::Query(box), but, visit);
  }

  // Whether a box around several edges or points finds little more than their own boxes do.
  [[nodiscard]] bool narrow(const Box& box) const {
    return std::min(box.max.x - box.min.x, box.max.y - box.min.y) <= part_max_;
  }

  // visit(Box) for one or more boxes that hold the edge and the pixels that it passes.
  template <typename Visit>
  void for_boxes(Point a, Point b, Visit visit) const;

  // visit(EdgeIndex, EdgeIndex) for pairs of edges of different operands whose boxes overlap.
  template <typename Visit>
  void for_pairs_across(Visit visit) const;

  // The same for all edges.
  template <typename Visit>
  void for_all_pairs(Visit visit) const;

 private:
  // Groups of one level lie in one row. The box in lane i of group g is around group 8 · g + i of
  // the level below; on level 0 it is that of edge edges_[g][i].
  static constexpr std::size_t kLevelsMax = 11;
  using Lanes = std::array<EdgeIndex, BoxGroup::kSize>;
  struct Tree {
    std::uint32_t operand = 0;
    std::uint32_t level_count = 0;
    std::array<std::uint32_t, kLevelsMax> levels{};  // the first group of each
    Box box;
  };
  struct Node {
    std::uint32_t level;
    std::uint32_t group;
  };

  void add_edges(const ContourEdges& edges, const ContourRing& ring, Tree& tree);
  void close_group(Tree& tree);
  void add_levels(Tree& tree, std::uint32_t group_count);

  [[nodiscard]] const BoxGroup& group(const Tree& tree, Node node) const {
    return groups_[tree.levels[node.level] + node.group];
  }
  [[nodiscard]] EdgeIndex edge(const Tree& tree, Node node, std::uint32_t lane) const {
    return edges_[tree.levels[0] + node.group][lane];
  }
  static Node child(Node node, std::uint32_t lane) {
    return {node.level - 1, BoxGroup::kSize * node.group + lane};
  }
  static Node root(const Tree& tree) { return {tree.level_count - 1, 0}; }

  [[nodiscard]] std::int32_t part_count(const Box& box) const;
  template <typename Visit>
  static void for_parts(Point a, Point b, std::int32_t parts, Visit visit);
  template <typename Visit>
  void join(const Tree& one, Node i, const Tree& other, Node k, const Box& other_box,
            Visit& visit) const;
  template <typename Visit>
  void join_within(const Tree& tree, Node i, Visit& visit) const;

  // Trees are short-lived: those of the last operation lie one behind the other.
  std::vector<BoxGroup> groups_;
  std::vector<Box> boxes_;    // around groups of level 0, until they have parents
  std::vector<Lanes> edges_;  // by group of level 0
  std::vector<Tree> trees_;
  std::int32_t part_max_ = 0;  // of the shorter side of a box
  // The group of level 0 that is being filled.
  struct OpenGroup {
    BoxGroup boxes;
    Lanes edges{};
    Box box;
    std::uint32_t size = 0;
  };
  OpenGroup open_;
  // Room to work.
  RingOrder order_;
  std::vector<Box> level_;
};

// Implementation details follow.

inline std::int32_t EdgeTree::part_count(const Box& box) const {
  return std::min(box.max.x - box.min.x, box.max.y - box.min.y) / part_max_ + 1;
}

// visit(Box) for boxes that hold the edge and the pixels that it passes.
template <typename Visit>
void EdgeTree::for_parts(Point a, Point b, std::int32_t parts, Visit visit) {
  // Parts end less than a unit beside the edge, and pixels reach half a unit from it.
  constexpr std::int32_t kMargin = 2;
  const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
  Point from = a;
  for (std::int32_t i = 1; i <= parts; ++i) {
    const Point to{static_cast<std::int32_t>(a.x + dx * i / parts),
                   static_cast<std::int32_t>(a.y + dy * i / parts)};
    const Box box = box_of(Segment{from, to});
    visit(Box{{box.min.x - kMargin, box.min.y - kMargin},
              {box.max.x + kMargin, box.max.y + kMargin}});
    from = to;
  }
}

template <typename Visit>
void EdgeTree::for_edges_in(const BoxGroup::Query& box, std::uint32_t but, Visit visit) const {
  std::array<Node, kLevelsMax * BoxGroup::kSize> stack;
  for (const Tree& tree : trees_) {
    if (tree.operand == but) continue;
    std::size_t size = 0;
    stack[size++] = root(tree);
    while (size > 0) {
      const Node node = stack[--size];
      const std::uint32_t overlapping = group(tree, node).overlapping(box);
      if (node.level > 0) {
        for_lanes(overlapping, [&](std::uint32_t lane) { stack[size++] = child(node, lane); });
      } else {
        for_lanes(overlapping, [&](std::uint32_t lane) { visit(edge(tree, node, lane)); });
      }
    }
  }
}

template <typename Visit>
void EdgeTree::for_boxes(Point a, Point b, Visit visit) const {
  const Box box = box_of(Segment{a, b});
  if (narrow(box)) return visit(box);
  for_parts(a, b, part_count(box), visit);
}

// other_box: around group k.
template <typename Visit>
void EdgeTree::join(const Tree& one, Node i, const Tree& other, Node k, const Box& other_box,
                    Visit& visit) const {
  const BoxGroup &group_i = group(one, i), &group_k = group(other, k);
  for_lanes(group_i.overlapping(other_box), [&](std::uint32_t lane_i) {
    if (i.level > k.level) return join(one, child(i, lane_i), other, k, other_box, visit);
    for_lanes(group_k.overlapping(group_i.box(lane_i)), [&](std::uint32_t lane_k) {
      if (k.level == 0) return visit(edge(one, i, lane_i), edge(other, k, lane_k));
      join(one, child(i, lane_i), other, child(k, lane_k), group_k.box(lane_k), visit);
    });
  });
}

template <typename Visit>
void EdgeTree::join_within(const Tree& tree, Node i, Visit& visit) const {
  const BoxGroup& group_i = group(tree, i);
  for (std::uint32_t lane = 0; lane < BoxGroup::kSize; ++lane) {
    const Box box = group_i.box(lane);
    const std::uint32_t overlapping = group_i.overlapping(box);
    if (overlapping == 0) continue;  // an empty one
    if (i.level > 0) join_within(tree, child(i, lane), visit);
    for_lanes(overlapping >> lane & ~1u, [&](std::uint32_t above) {
      if (i.level == 0) return visit(edge(tree, i, lane), edge(tree, i, lane + above));
      join(tree, child(i, lane), tree, child(i, lane + above), group_i.box(lane + above), visit);
    });
  }
}

template <typename Visit>
void EdgeTree::for_pairs_across(Visit visit) const {
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    for (std::size_t k = i + 1; k < trees_.size(); ++k) {
      const Tree &one = trees_[i], &other = trees_[k];
      if (!one.box.overlaps(other.box)) continue;
      if (one.level_count >= other.level_count) {
        join(one, root(one), other, root(other), other.box, visit);
      } else {
        join(other, root(other), one, root(one), one.box, visit);
      }
    }
  }
}

template <typename Visit>
void EdgeTree::for_all_pairs(Visit visit) const {
  for (const Tree& tree : trees_) join_within(tree, root(tree), visit);
  for_pairs_across(visit);
}

}  // namespace core
