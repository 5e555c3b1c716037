#include "core/booleans/snap_rounding.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "core/booleans/hot_pixel.h"  // passes_pixel, crossing_pixel

namespace core {
namespace {

constexpr std::size_t kTableMin = 64;

std::size_t hash(Point p) { return static_cast<std::size_t>(hash_of(p) >> 32); }

// The first boxes of some, with one around them.
struct Gathered {
  BoxGroup boxes;
  Box box;
  std::size_t size = 0;
};

// As many of `count`, at least one, as are better searched for together.
template <typename BoxAt>
Gathered gather(const EdgeTree& tree, std::size_t count, BoxAt box_at) {
  Gathered group;
  for (; group.size < count && group.size < BoxGroup::kSize; ++group.size) {
    const Box box = box_at(group.size);
    Box more = group.box;
    more.add(box);
    if (group.size > 0 && !tree.narrow(more)) break;
    group.box = more;
    group.boxes.set(static_cast<std::uint32_t>(group.size), box);
  }
  return group;
}

bool same_side(std::int64_t turn, std::int64_t other) {
  return (turn > 0 && other > 0) || (turn < 0 && other < 0);
}

// For a point on the line through a and b.
bool within(Point a, Point p, Point b) { return between(a.x, p.x, b.x) && between(a.y, p.y, b.y); }

std::uint32_t steps(Point a, Point b) {
  return static_cast<std::uint32_t>(std::abs(std::int64_t{b.x} - a.x) +
                                    std::abs(std::int64_t{b.y} - a.y));
}

std::uint64_t order(const Passage& passage) {
  return (std::uint64_t{passage.edge} << 32) | passage.along;
}

}  // namespace

void SnapRounding::run(const ContourEdges& edges, const EdgeTree& tree, Meetings meetings) {
  nodes_.clear();
  table_.assign(kTableMin, 0);
  passages_.clear();
  bent_.assign(edges.index_end(), 0);
  newly_bent_.clear();
  runs_along_.assign(edges.rings().size(), 0);
  if (meetings == Meetings::kAll) {
    tree.for_all_pairs([&](EdgeIndex e, EdgeIndex f) {
      if (e != f && !neighbours(edges, e, f)) meet(edges, e, f);
    });
  } else {
    tree.for_pairs_across([&](EdgeIndex e, EdgeIndex f) { meet(edges, e, f); });
  }
  std::size_t settled = 0;
  do {
    while (settled < nodes_.size()) {
      settled = find_passages(edges, tree, settled);
      if (settled == nodes_.size()) bend_edges(edges, tree);
    }
    sort_passages();
    find_spurs(edges);
    if (settled == nodes_.size()) find_coinciding_ring(edges);
  } while (settled < nodes_.size());
}

// Rings that share all their corners have got no node yet; one is enough.
void SnapRounding::find_coinciding_ring(const ContourEdges& edges) {
  std::size_t passage = 0;
  for (std::uint32_t i = 0; i < edges.rings().size(); ++i) {
    const ContourRing& ring = edges.rings()[i];
    const std::size_t first = passage;
    while (passage < passages_.size() && passages_[passage].edge < ring.end) ++passage;
    if (passage > first || runs_along_[i] == 0) continue;
    runs_along_[i] = 0;
    add_node(edges.from(ring.first));
  }
}

// A corner whose two edges pass the same node next has become the tip of a spur without width.
void SnapRounding::find_spurs(const ContourEdges& edges) {
  for (std::size_t i = 0, first = 0; i < passages_.size(); ++i) {
    const ContourRing& ring = edges.ring(passages_[i].edge);
    if (passages_[first].edge < ring.first) first = i;
    const bool last = i + 1 == passages_.size() || passages_[i + 1].edge >= ring.end;
    const Passage &from = passages_[i], &to = passages_[last ? first : i + 1];
    if (from.node != to.node || to.along == 0 || from.edge == to.edge) continue;
    const EdgeIndex after = edges.after(from.edge);
    if (to.edge == after) add_node(edges.from(after));
  }
}

// Neighbours on a ring meet only in their common end: no ring runs straight back.
bool SnapRounding::neighbours(const ContourEdges& edges, EdgeIndex e, EdgeIndex f) {
  const auto [low, high] = std::minmax(e, f);
  const ContourRing& ring = edges.ring(low);
  return (high == low + 1 && high != ring.end) || (low == ring.first && high + 1 == ring.end);
}

// An edge's last point is left to the next edge, which is entered in the same cells about it.
void SnapRounding::meet(const ContourEdges& edges, EdgeIndex e, EdgeIndex f) {
  const Point a = edges.from(e), b = edges.to(e), c = edges.from(f), d = edges.to(f);
  const std::int64_t turn_c = cross(a, b, c), turn_d = cross(a, b, d);
  if (same_side(turn_c, turn_d)) return;
  const std::int64_t turn_a = cross(c, d, a), turn_b = cross(c, d, b);
  if (same_side(turn_a, turn_b)) return;
  if (turn_a != 0 && turn_b != 0 && turn_c != 0 && turn_d != 0) {
    add_node(crossing_pixel(a, b, c, d));
    return;
  }
  if (a == c) {
    meet_at_corner(edges, e, f);
    return;
  }
  if (turn_c == 0 && c != b && within(a, c, b)) add_node(c);
  if (turn_a == 0 && a != d && within(c, a, d)) add_node(a);
}

// Where two rings share a run of corners, one way or the other, only its ends need be nodes.
void SnapRounding::meet_at_corner(const ContourEdges& edges, EdgeIndex e, EdgeIndex f) {
  const Point before_e = edges.from(edges.before(e)), after_e = edges.to(e);
  const Point before_f = edges.from(edges.before(f)), after_f = edges.to(f);
  if ((before_e == before_f && after_e == after_f) ||
      (before_e == after_f && after_e == before_f)) {
    runs_along_[edges.ring_index(e)] = 1;
    runs_along_[edges.ring_index(f)] = 1;
  } else {
    add_node(edges.from(e));
  }
}

void SnapRounding::add_node(Point p) {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash(p) & mask;
  for (; table_[slot] != 0; slot = (slot + 1) & mask) {
    if (nodes_[table_[slot] - 1] == p) return;
  }
  nodes_.push_back(p);
  table_[slot] = static_cast<NodeIndex>(nodes_.size());
  if (2 * nodes_.size() > table_.size()) grow_table();
}

void SnapRounding::grow_table() {
  const std::size_t mask = 2 * table_.size() - 1;
  table_.assign(mask + 1, 0);
  for (NodeIndex node = 0; node < nodes_.size(); ++node) {
    std::size_t slot = hash(nodes_[node]) & mask;
    while (table_[slot] != 0) slot = (slot + 1) & mask;
    table_[slot] = node + 1;
  }
}

// Nodes that were found one after the other are near one another: a group is searched for at once.
std::size_t SnapRounding::find_passages(const ContourEdges& edges, const EdgeTree& tree,
                                        std::size_t first) {
  const auto box_at = [&](std::size_t node) { return Box{nodes_[node], nodes_[node]}; };
  const Gathered group =
      gather(tree, nodes_.size() - first, [&](std::size_t i) { return box_at(first + i); });
  tree.for_edges_in(group.box, kNoOperand, [&](EdgeIndex e) {
    const Point a = edges.from(e), b = edges.to(e);
    for_lanes(group.boxes.overlapping(box_of(Segment{a, b})), [&](std::uint32_t lane) {
      const Point p = nodes_[first + lane];
      if (p == b || !passes_pixel(a, b, p)) return;
      passages_.push_back({e, steps(a, p), static_cast<NodeIndex>(first + lane)});
      if (bent_[e] == 0 && cross(a, b, p) != 0) {
        bent_[e] = 1;
        newly_bent_.push_back(e);
      }
    });
  });
  return first + group.size;
}

// Edges one behind the other are searched around at once.
void SnapRounding::bend_edges(const ContourEdges& edges, const EdgeTree& tree) {
  std::sort(newly_bent_.begin(), newly_bent_.end());
  for (std::size_t first = 0; first < newly_bent_.size();) {
    const auto line = [&](std::size_t i) {
      return Segment{edges.from(newly_bent_[first + i]), edges.to(newly_bent_[first + i])};
    };
    const Gathered group =
        gather(tree, newly_bent_.size() - first, [&](std::size_t i) { return box_of(line(i)); });
    const auto search = [&](const Box& box) {
      tree.for_edges_in(box, kNoOperand, [&](EdgeIndex other) {
        const Box other_box = box_of(Segment{edges.from(other), edges.to(other)});
        for_lanes(group.boxes.overlapping(other_box),
                  [&](std::uint32_t lane) { bend(edges, newly_bent_[first + lane], other); });
      });
    };
    if (group.size > 1) {
      search(group.box);
    } else {
      tree.for_boxes(line(0).from, line(0).to, search);
    }
    first += group.size;
  }
  newly_bent_.clear();
}

void SnapRounding::bend(const ContourEdges& edges, EdgeIndex edge, EdgeIndex other) {
  if (other == edge) return;
  const Point a = edges.from(edge), b = edges.to(edge);
  const Point c = edges.from(other), d = edges.to(other);
  const bool follows = c == b && other == edges.after(edge);
  const bool leads = d == a && other == edges.before(edge);
  if (!follows && passes_pixel(a, b, c)) add_node(c);
  if (!leads && passes_pixel(c, d, a)) add_node(a);
  if (!follows && passes_pixel(c, d, b)) add_node(b);
}

// By edge first, as edges are numbered; few passages are left to be put in order on each. The tree
// may find an edge at a node more than once.
void SnapRounding::sort_passages() {
  if (passages_.empty()) return;
  next_passage_.assign(bent_.size() + 1, 0);
  for (const Passage& passage : passages_) ++next_passage_[passage.edge + 1];
  for (std::size_t i = 1; i < next_passage_.size(); ++i) next_passage_[i] += next_passage_[i - 1];
  by_edge_.resize(passages_.size());
  for (const Passage& passage : passages_) by_edge_[next_passage_[passage.edge]++] = passage;
  passages_.clear();
  for (std::size_t i = 0, end = 0; i < by_edge_.size(); i = end) {
    end = next_passage_[by_edge_[i].edge];
    const auto first = by_edge_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = by_edge_.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(first, last, [](const Passage& p, const Passage& q) { return p.along < q.along; });
    std::unique_copy(first, last, std::back_inserter(passages_),
                     [](const Passage& p, const Passage& q) { return p.along == q.along; });
  }
}

void SnapRounding::add_node_to_rings_without(const ContourEdges& edges) {
  const std::size_t found = passages_.size();
  std::size_t i = 0;
  for (const ContourRing& ring : edges.rings()) {
    if (i < found && passages_[i].edge < ring.end) {
      while (i < found && passages_[i].edge < ring.end) ++i;
      continue;
    }
    passages_.push_back({ring.first, 0, static_cast<NodeIndex>(nodes_.size())});
    nodes_.push_back(edges.from(ring.first));
  }
  sort_passages();
}

std::span<const Passage> SnapRounding::passages_of(EdgeIndex edge) const {
  const auto begin = std::lower_bound(
      passages_.begin(), passages_.end(), std::uint64_t{edge} << 32,
      [](const Passage& passage, std::uint64_t value) { return order(passage) < value; });
  auto end = begin;
  while (end != passages_.end() && end->edge == edge) ++end;
  return {begin, end};
}

}  // namespace core
