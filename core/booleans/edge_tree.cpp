#include "core/booleans/edge_tree.h"

#include <numeric>

namespace core {
namespace {

// The shorter side of a part's box in mean edges. Wider ones are found too often, narrower ones are
// more.
constexpr std::int32_t kPartInEdges = 2;
// More rings of an operand are put in order.
constexpr std::size_t kRingsInOrder = 8;

// The bits of a number of 32 bits, each with a 0 before it.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0x0000FFFF0000FFFF;
  bits = (bits | bits << 8) & 0x00FF00FF00FF00FF;
  bits = (bits | bits << 4) & 0x0F0F0F0F0F0F0F0F;
  bits = (bits | bits << 2) & 0x3333333333333333;
  return (bits | bits << 1) & 0x5555555555555555;
}

// Where a point lies on a curve that fills the plane, so that neighbours on it are near.
std::uint64_t place_of(Point p) {
  const auto from_corner = [](std::int32_t value) {
    return static_cast<std::uint64_t>(std::int64_t{value} - INT32_MIN);
  };
  return spread(from_corner(p.x)) | spread(from_corner(p.y)) << 1;
}

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
    order_.clear();
    for (; end < rings.size() && rings[end].operand == tree.operand; ++end) {
      order_.emplace_back(0, static_cast<std::uint32_t>(end));
    }
    if (order_.size() > kRingsInOrder) {
      for (auto& [place, ring] : order_) place = place_of(edges.from(rings[ring].first));
      std::sort(order_.begin(), order_.end());
    }
    for (const auto& [place, ring] : order_) {
      add_edges(edges, rings[ring], tree);
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
