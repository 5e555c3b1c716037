#include "core/regions/clear_contours.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/regions/box_tree.h"  // BoxTree, RingOrder

namespace core {
namespace {

constexpr std::uint32_t kChainEdgesMax = 16;

// Which ways edges go: bits for right, left, up and down.
constexpr std::uint32_t kUp = 4, kDown = 8;
std::uint32_t ways(Point a, Point b) {
  return static_cast<std::uint32_t>(b.x > a.x) | static_cast<std::uint32_t>(b.x < a.x) << 1 |
         static_cast<std::uint32_t>(b.y > a.y) << 2 | static_cast<std::uint32_t>(b.y < a.y) << 3;
}
// Right and left, or up and down.
bool turns_back(std::uint32_t ways) { return (ways & ways >> 1 & 5) != 0; }
// In x and in y.
bool turns_round(std::uint32_t before, std::uint32_t after) {
  const std::uint32_t both = before | after;
  return (both & both >> 1 & 5) == 5;
}

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// The corner c of a -> b -> c lies on the edge before it, or that on the edge after it.
bool runs_back(Point a, Point b, Point c) {
  if (cross(a, b, c) != 0) return false;
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x) +
             (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - b.y) <
         0;
}

// Closed segments with overlapping boxes have a point in common.
bool touch(const Segment& a, const Segment& b) {
  if (sign(cross(a.from, a.to, b.from)) * sign(cross(a.from, a.to, b.to)) > 0) return false;
  return sign(cross(b.from, b.to, a.from)) * sign(cross(b.from, b.to, a.to)) <= 0;
}

class ClearContours {
 public:
  // Memory is kept for the next call.
  bool check(const std::vector<Ring>& rings) {
    points_.clear();
    rings_.clear();
    chains_.clear();
    tree_.clear();
    ring_tree_.clear();
    const auto first_of = [&](std::uint32_t i) { return rings[i].empty() ? Point{} : rings[i][0]; };
    for (const std::uint32_t i : order_.near_by_near(rings.size(), first_of)) {
      if (!add_ring(rings[i])) return false;
    }
    tree_.finish();
    ring_tree_.finish();
    const bool met = tree_.any_pair([this](std::uint32_t a, std::uint32_t b) {
      return (b != a + 1 || chains_[b].turns_round) && meet(chains_[a], chains_[b]);
    });
    if (met) return false;
    if (rings.size() == 1) return rings_[0].counter_clockwise;
    return std::all_of(rings_.begin(), rings_.end(),
                       [this](const ClosedRing& ring) { return nests(ring); });
  }

 private:
  // Edge i goes from points_[i] to points_[i + 1].
  struct Chain {
    std::uint32_t first, last;  // edges first … last - 1
    std::uint32_t ring;
    std::uint32_t ways;
    // May run back in x and in y over the chain before it, or there is none on its ring. Otherwise
    // both lie on either side of a line along an axis, on which they have but their corner in
    // common: none runs back over an edge.
    bool turns_round;
  };
  struct ClosedRing {
    std::uint32_t first, end;  // its edges
    Point lowest;              // of its lowest corners the leftmost one
    bool counter_clockwise;
  };

  // False when the ring is too short, repeats a corner or runs back over itself.
  bool add_ring(const Ring& ring) {
    if (ring.size() < 3) return false;
    const auto first = static_cast<std::uint32_t>(points_.size());
    const auto end = first + static_cast<std::uint32_t>(ring.size());
    points_.insert(points_.end(), ring.begin(), ring.end());
    points_.push_back(ring.front());
    const Point* points = points_.data();
    std::uint32_t chain_first = first, chain_ways = 0, lowest = first;
    ring_box_ = Box();
    for (std::uint32_t i = first; i < end; ++i) {
      const Point a = points[i], b = points[i + 1];
      const std::uint32_t edge_ways = ways(a, b);
      if (edge_ways == 0) return false;
      const Point low = points[lowest];
      lowest = a.y < low.y || (a.y == low.y && a.x < low.x) ? i : lowest;
      const std::uint32_t both = chain_ways | edge_ways;
      if (!turns_back(both) && i - chain_first < kChainEdgesMax) {
        chain_ways = both;
        continue;
      }
      if (runs_back(points[i - 1], a, b)) return false;
      add_chain(first, chain_first, i, chain_ways);
      chain_first = i;
      chain_ways = edge_ways;
    }
    add_chain(first, chain_first, end, chain_ways);
    if (runs_back(points[end - 1], points[first], points[first + 1])) return false;
    const Point before = points[lowest > first ? lowest - 1 : end - 1];
    const bool left = cross(before, points[lowest], points[lowest + 1]) > 0;
    ring_tree_.add(ring_box_, static_cast<std::uint32_t>(rings_.size()));
    rings_.push_back({first, end, points[lowest], left});
    return true;
  }

  void add_chain(std::uint32_t ring_first, std::uint32_t first, std::uint32_t last,
                 std::uint32_t ways) {
    const Box box = box_of(Segment{points_[first], points_[last]});
    ring_box_.add(box.min);
    ring_box_.add(box.max);
    tree_.add(box, static_cast<std::uint32_t>(chains_.size()));
    const bool round = first == ring_first || turns_round(chains_.back().ways, ways);
    chains_.push_back({first, last, static_cast<std::uint32_t>(rings_.size()), ways, round});
  }

  [[nodiscard]] Segment edge(std::uint32_t i) const { return {points_[i], points_[i + 1]}; }
  [[nodiscard]] Box box(const Chain& chain) const {
    return box_of(Segment{points_[chain.first], points_[chain.last]});
  }

  // Whether the ring stands where one that turns its way may stand.
  bool nests(const ClosedRing& ring) const {
    std::size_t around = 0;  // itself and rings that may go around it
    ring_tree_.for_items_in({ring.lowest, ring.lowest}, [&](std::uint32_t) { ++around; });
    if (around == 1) return ring.counter_clockwise;
    int winding = 0;
    tree_.for_items_in(Box{{INT32_MIN, ring.lowest.y}, ring.lowest}, [&](std::uint32_t chain) {
      winding += winding_about(chains_[chain], ring.lowest);
    });
    return winding == (ring.counter_clockwise ? 0 : 1);
  }

  // What the chain adds to the winding number about p, counted along the ray to the left.
  int winding_about(const Chain& chain, Point p) const {
    const Box around = box(chain);
    const int up = (chain.ways & kUp) != 0 ? 1 : (chain.ways & kDown) != 0 ? -1 : 0;
    if (up == 0 || around.min.y >= p.y || around.max.y < p.y) return 0;
    if (around.max.x < p.x) return -up;
    for (std::uint32_t i = chain.first; i < chain.last; ++i) {
      const auto [a, b] = edge(i);
      if (std::min(a.y, b.y) >= p.y || std::max(a.y, b.y) < p.y) continue;
      return sign(cross(a, b, p)) * up < 0 ? -up : 0;
    }
    return 0;
  }

  // The chain's edges that come into the box. They follow one another, as a chain goes one way.
  struct Stretch {
    std::uint32_t first, last;
  };
  [[nodiscard]] Stretch stretch_in(const Chain& chain, const Box& box) const {
    Stretch stretch{chain.first, chain.last};
    while (stretch.first < chain.last && !box_of(edge(stretch.first)).overlaps(box)) {
      ++stretch.first;
    }
    stretch.last = stretch.first;
    while (stretch.last < chain.last && box_of(edge(stretch.last)).overlaps(box)) ++stretch.last;
    return stretch;
  }

  bool meet(const Chain& a, const Chain& b) const {
    const Box box_a = box(a), box_b = box(b);
    const Box common{{std::max(box_a.min.x, box_b.min.x), std::max(box_a.min.y, box_b.min.y)},
                     {std::min(box_a.max.x, box_b.max.x), std::min(box_a.max.y, box_b.max.y)}};
    const Stretch of_a = stretch_in(a, common);
    if (of_a.first == of_a.last) return false;
    const Stretch of_b = stretch_in(b, common);
    const ClosedRing& ring = rings_[a.ring];
    for (std::uint32_t i = of_a.first; i < of_a.last; ++i) {
      const Segment one = edge(i);
      for (std::uint32_t j = of_b.first; j < of_b.last; ++j) {
        const Segment other = edge(j);
        if (!box_of(other).overlaps(box_of(one))) continue;
        // Neighbours meet in their corner; that none runs back was seen before.
        const std::uint32_t apart = i > j ? i - j : j - i;
        if (a.ring == b.ring && (apart == 1 || apart == ring.end - ring.first - 1)) continue;
        if (touch(one, other)) return true;
      }
    }
    return false;
  }

  std::vector<Point> points_;  // ring by ring, each with its first point once more
  std::vector<ClosedRing> rings_;
  std::vector<Chain> chains_;
  BoxTree tree_;       // of the chains
  BoxTree ring_tree_;  // of the rings
  Box ring_box_;       // of the ring that is being added
  RingOrder order_;
};

}  // namespace

bool keep_clear(const std::vector<Ring>& rings) {
  thread_local ClearContours contours;
  return contours.check(rings);
}

}  // namespace core
