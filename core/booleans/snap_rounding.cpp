#include "core/booleans/snap_rounding.h"

#include <algorithm>
#include <cstdlib>

#include "core/booleans/hot_pixel.h"  // passes_pixel, crossing_pixel

namespace core {
namespace {

constexpr std::size_t kTableMin = 64;

std::size_t hash(Point p) {
  const std::uint64_t both =
      (std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32) | static_cast<std::uint32_t>(p.y);
  return static_cast<std::size_t>((both * 0x9E3779B97F4A7C15u) >> 32);
}

// Both ends on the far side of one of the box's sides. Counted, because branches that nothing
// predicts cost more than comparisons.
inline bool apart(const Box& box, Point c, Point d) {
  const int west = int{c.x < box.min.x} & int{d.x < box.min.x};
  const int east = int{c.x > box.max.x} & int{d.x > box.max.x};
  const int south = int{c.y < box.min.y} & int{d.y < box.min.y};
  const int north = int{c.y > box.max.y} & int{d.y > box.max.y};
  return (west | east | south | north) != 0;
}

Box box_of(Point a, Point b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
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

void SnapRounding::run(const ContourEdges& edges, const EdgeGrid& grid, Meetings meetings) {
  nodes_.clear();
  table_.assign(kTableMin, 0);
  passages_.clear();
  bent_.assign(edges.index_end(), 0);
  newly_bent_.clear();
  runs_along_.assign(edges.rings().size(), 0);
  if (meetings == Meetings::kAll) {
    find_all_meetings(edges, grid);
  } else {
    find_meetings_across(edges, grid);
  }
  NodeIndex settled = 0;
  do {
    for (; settled < nodes_.size(); ++settled) {
      find_passages(edges, grid, settled);
      while (!newly_bent_.empty()) {
        const EdgeIndex edge = newly_bent_.back();
        newly_bent_.pop_back();
        bend(edges, grid, edge);
      }
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

void SnapRounding::find_meetings_across(const ContourEdges& edges, const EdgeGrid& grid) {
  for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
    const std::span<const EdgeIndex> here = grid.edges_in(cell);
    if (here.size() < 2) continue;
    const std::uint32_t last = edges.ring(here.back()).operand;
    // One run of edges for each operand; each is tried against all that follow.
    for (std::size_t begin = 0, end = 0; begin < here.size(); begin = end) {
      const std::uint32_t operand = edges.ring(here[begin]).operand;
      if (operand == last) break;
      while (edges.ring(here[end]).operand == operand) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        const Point a = edges.from(here[i]), b = edges.to(here[i]);
        const Box box = box_of(a, b);
        for (std::size_t j = end; j < here.size(); ++j) {
          const Point c = edges.from(here[j]), d = edges.to(here[j]);
          if (!apart(box, c, d)) meet(edges, here[i], here[j]);
        }
      }
    }
  }
}

void SnapRounding::find_all_meetings(const ContourEdges& edges, const EdgeGrid& grid) {
  for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
    const std::span<const EdgeIndex> here = grid.edges_in(cell);
    for (std::size_t i = 0; i < here.size(); ++i) {
      const Point a = edges.from(here[i]), b = edges.to(here[i]);
      const Box box = box_of(a, b);
      for (std::size_t j = i + 1; j < here.size(); ++j) {
        const Point c = edges.from(here[j]), d = edges.to(here[j]);
        if (apart(box, c, d)) continue;
        // Neighbours meet only in their common end: no ring runs straight back.
        const ContourRing& ring = edges.ring(here[i]);
        if (here[j] == here[i] + 1 && here[j] != ring.end) continue;
        if (here[i] == ring.first && here[j] + 1 == ring.end) continue;
        meet(edges, here[i], here[j]);
      }
    }
  }
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

void SnapRounding::find_passages(const ContourEdges& edges, const EdgeGrid& grid, NodeIndex node) {
  const Point p = nodes_[node];
  for (const EdgeIndex e : grid.edges_in(grid.cell_of(p))) {
    const Point a = edges.from(e), b = edges.to(e);
    if (p == b || !passes_pixel(a, b, p)) continue;
    passages_.push_back({e, steps(a, p), node});
    if (bent_[e] == 0 && cross(a, b, p) != 0) {
      bent_[e] = 1;
      newly_bent_.push_back(e);
    }
  }
}

void SnapRounding::bend(const ContourEdges& edges, const EdgeGrid& grid, EdgeIndex edge) {
  const Point a = edges.from(edge), b = edges.to(edge);
  const EdgeIndex before = edges.before(edge), after = edges.after(edge);
  const Box box = box_of(a, b);
  grid.for_cells(a, b, [&](std::uint32_t cell) {
    for (const EdgeIndex other : grid.edges_in(cell)) {
      const Point c = edges.from(other), d = edges.to(other);
      if (apart(box, c, d) || other == edge) continue;
      if (other != after && passes_pixel(a, b, c)) add_node(c);
      if (other != before && passes_pixel(c, d, a)) add_node(a);
      if (other != after && passes_pixel(c, d, b)) add_node(b);
    }
  });
}

void SnapRounding::sort_passages() {
  std::sort(passages_.begin(), passages_.end(),
            [](const Passage& p, const Passage& q) { return order(p) < order(q); });
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
