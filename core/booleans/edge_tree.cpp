#include "core/booleans/edge_tree.h"

#include <numeric>

namespace core {
namespace {

// The shorter side of a part's box in mean edges. Wider ones are found too often, narrower ones are
// more.
constexpr std::int32_t kPartInEdges = 2;
// The groups of more rings are put in order.
constexpr std::size_t kRingsInOrder = 8;

// The bits of a number of 16 bits, each with a 0 before it.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 8) & 0x00FF00FF;
  bits = (bits | bits << 4) & 0x0F0F0F0F;
  bits = (bits | bits << 2) & 0x33333333;
  return (bits | bits << 1) & 0x55555555;
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
    for (; end < rings.size() && rings[end].operand == tree.operand; ++end) {
      tree.box = around(tree.box, add_edges(edges, rings[end]));
    }
    if (end - i > kRingsInOrder) put_in_order(tree.levels[0], tree.box);
    trees_.push_back(tree);
  }
  const auto group_end = static_cast<std::uint32_t>(groups_.size());
  for (std::size_t i = 0; i < trees_.size(); ++i) {
    const std::uint32_t end = i + 1 < trees_.size() ? trees_[i + 1].levels[0] : group_end;
    add_levels(trees_[i], end - trees_[i].levels[0]);
  }
}

Box EdgeTree::add_edges(const ContourEdges& edges, const ContourRing& ring) {
  const Point* points = edges.points();
  BoxGroup group;
  Lanes lanes{};
  Box box, all;
  std::uint32_t size = 0;
  const auto close_group = [&] {
    groups_.push_back(group);
    edges_.push_back(lanes);
    boxes_.push_back(box);
    all = around(all, box);
    box = Box();
    size = 0;
  };
  const auto add = [&](EdgeIndex edge, const Box& part) {
    if (size == BoxGroup::kSize) close_group();
    group.set(size, part);
    lanes[size++] = edge;
    box = around(box, part);
  };
  for (EdgeIndex e = ring.first; e < ring.end; ++e) {
    if (size % BoxGroup::kSize == 0 && e + BoxGroup::kSize <= ring.end) {
      BoxGroup eight;
      eight.set_edges(points + e);
      if (eight.widest() <= part_max_) {
        if (size > 0) close_group();
        std::iota(lanes.begin(), lanes.end(), e);
        group = eight;
        box = eight.around();
        close_group();
        e += BoxGroup::kSize - 1;
        continue;
      }
    }
    const Segment line{points[e], points[e + 1]};
    const Box whole = box_of(line);
    if (narrow(whole)) {
      add(e, whole);
    } else {
      for_parts(line.from, line.to, part_count(whole), [&](const Box& part) { add(e, part); });
    }
  }
  if (size > 0) {
    while (size < BoxGroup::kSize) group.set(size++, Box());
    close_group();
  }
  return all;
}

// Along a curve that fills the plane, so that neighbours are near one another.
void EdgeTree::put_in_order(std::uint32_t first, const Box& box) {
  const auto extent =
      std::max(std::int64_t{box.max.x} - box.min.x, std::int64_t{box.max.y} - box.min.y);
  // Middles, doubled; parts' boxes reach a little further.
  const auto place = [](std::int32_t low, std::int32_t high, std::int32_t least) {
    return static_cast<std::uint64_t>(
        std::max(std::int64_t{0}, std::int64_t{low} + high - 2 * std::int64_t{least}));
  };
  int shift = 0;
  while ((2 * extent + 8) >> shift > 0xFFFF) ++shift;
  places_.clear();
  for (std::uint32_t i = first; i < groups_.size(); ++i) {
    const Box& at = boxes_[i];
    const std::uint64_t x = place(at.min.x, at.max.x, box.min.x) >> shift;
    const std::uint64_t y = place(at.min.y, at.max.y, box.min.y) >> shift;
    places_.emplace_back(spread(x) | spread(y) << 1, i);
  }
  std::sort(places_.begin(), places_.end());
  sorted_groups_.clear();
  sorted_boxes_.clear();
  sorted_edges_.clear();
  for (const auto& [at, i] : places_) {
    sorted_groups_.push_back(groups_[i]);
    sorted_boxes_.push_back(boxes_[i]);
    sorted_edges_.push_back(edges_[i]);
  }
  std::copy(sorted_groups_.begin(), sorted_groups_.end(), groups_.begin() + first);
  std::copy(sorted_boxes_.begin(), sorted_boxes_.end(), boxes_.begin() + first);
  std::copy(sorted_edges_.begin(), sorted_edges_.end(), edges_.begin() + first);
}

void EdgeTree::add_levels(Tree& tree, std::uint32_t group_count) {
  const auto begin = boxes_.begin() + static_cast<std::ptrdiff_t>(tree.levels[0]);
  sorted_boxes_.assign(begin, begin + group_count);
  tree.level_count = 1;
  while (sorted_boxes_.size() > 1) {
    tree.levels[tree.level_count++] = static_cast<std::uint32_t>(groups_.size());
    std::size_t above = 0;
    for (std::size_t i = 0; i < sorted_boxes_.size(); ++above) {
      BoxGroup group;
      Box all;
      for (std::uint32_t lane = 0; lane < BoxGroup::kSize && i < sorted_boxes_.size(); ++lane) {
        group.set(lane, sorted_boxes_[i]);
        all = around(all, sorted_boxes_[i++]);
      }
      groups_.push_back(group);
      sorted_boxes_[above] = all;
    }
    sorted_boxes_.resize(above);
  }
}

}  // namespace core
