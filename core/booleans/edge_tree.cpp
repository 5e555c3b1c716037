#include "core/booleans/edge_tree.h"

#include <numeric>

namespace core {
namespace {

// The shorter side of a part's box in mean edges. Wider ones are found too often, narrower ones are
// more.
constexpr std::int32_t kPartInEdges = 2;
inline Box around(const Box& a, const Box& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

}  // namespace

void EdgeTree::build(const ContourEdges& edges) {
  groups_.clear();
  boxes_.clear();
  edges_.clear();
  trees_.clear();
  const std::uint64_t mean = edges.length_units() / std::max(1u, edges.index_end());
  part_max_ = 1 + kPartInEdges * static_cast<std::int32_t>(mean);
  const std::span<const ContourRing> rings = edges.rings();
  for (std::size_t i = 0, end = 0; i < rings.size(); i = end) {
    Tree tree;
    tree.operand = rings[i].operand;
    tree.levels[0] = static_cast<std::uint32_t>(groups_.size());
    while (end < rings.size() && rings[end].operand == tree.operand) ++end;
    const auto first_of = [&](std::uint32_t ring) { return edges.from(rings[i + ring].first); };
    for (const std::uint32_t ring : order_.near_by_near(end - i, first_of)) {
      add_edges(edges, rings[i + ring], tree);
    }
    close_group(tree);
    trees_.push_back(tree);
  }
  const auto group_end = static_cast<std::uint32_t>(groups_.size());
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    const std::uint32_t end = i + 1 < trees_.size() ? trees_[i + 1].levels[0] : group_end;
    add_levels(trees_[i], end - trees_[i].levels[0]);
  }
}

void EdgeTree::close_group(Tree& tree) {
  if (open_.size == 0) return;
  while (open_.size < BoxGroup::kSize) open_.boxes.set(open_.size++, Box());
  groups_.push_back(open_.boxes);
  edges_.push_back(open_.edges);
  boxes_.push_back(open_.box);
  tree.box = around(tree.box, open_.box);
  open_.box = Box();
  open_.size = 0;
}

// Rings of few edges share groups, as neighbours in the order are near.
void EdgeTree::add_edges(const ContourEdges& edges, const ContourRing& ring, Tree& tree) {
  if (open_.size + ring.size() > BoxGroup::kSize) close_group(tree);
  const Point* points = edges.points();
  const auto add = [&](EdgeIndex edge, const Box& part) {
    if (open_.size == BoxGroup::kSize) close_group(tree);
    open_.boxes.set(open_.size, part);
    open_.edges[open_.size++] = edge;
    open_.box = around(open_.box, part);
  };
  for (EdgeIndex e = ring.first; e < ring.end; ++e) {
    if (open_.size == BoxGroup::kSize) close_group(tree);
    if (open_.size == 0 && e + BoxGroup::kSize <= ring.end) {
      groups_.emplace_back().set_edges(points + e);
      if (groups_.back().widest() <= part_max_) {
        Lanes& eight = edges_.emplace_back();
        std::iota(eight.begin(), eight.end(), e);
        tree.box = around(tree.box, boxes_.emplace_back(groups_.back().around()));
        e += BoxGroup::kSize - 1;
        continue;
      }
      groups_.pop_back();
    }
    const Segment line{points[e], points[e + 1]};
    const Box whole = box_of(line);
    if (narrow(whole)) {
      add(e, whole);
    } else {
      for_parts(line.from, line.to, part_count(whole), [&](const Box& part) { add(e, part); });
    }
  }
  if (ring.size() > BoxGroup::kSize) close_group(tree);
}

void EdgeTree::add_levels(Tree& tree, std::uint32_t group_count) {
  const auto begin = boxes_.begin() + static_cast<std::ptrdiff_t>(tree.levels[0]);
  level_.assign(begin, begin + group_count);
  tree.level_count = 1;
  while (level_.size() > 1) {
    tree.levels[tree.level_count++] = static_cast<std::uint32_t>(groups_.size());
    std::size_t above = 0;
    for (std::size_t i = 0; i < level_.size(); ++above) {
      BoxGroup group;
      Box all;
      for (std::uint32_t lane = 0; lane < BoxGroup::kSize && i < level_.size(); ++lane) {
        group.set(lane, level_[i]);
        all = around(all, level_[i++]);
      }
      groups_.push_back(group);
      level_[above] = all;
    }
    level_.resize(above);
  }
}

}  // namespace core
