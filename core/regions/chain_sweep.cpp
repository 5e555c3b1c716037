#include "core/regions/chain_sweep.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace core {
namespace {

constexpr std::size_t kChainEdgesMax = 16;
constexpr std::size_t kColumnsMax = 4096;
// Above this many columns, chains stand in no more than two each, on the mean.
constexpr std::size_t kColumnsAlways = 32;

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

struct Chain {
  Box box;
  std::uint32_t ring;
  std::uint32_t first, last;  // edges first … last - 1; edge i goes from corner i to the next
  int up;                     // 1, -1, or 0 when level
};

// What a ring's lowest, of those its leftmost corner tells.
struct LowestCorner {
  Point corner;
  bool counter_clockwise;
  bool nesting_checked = false;
};

class Sweep {
 public:
  // Memory is kept for the next call.
  bool clear(std::span<const Ring> rings) {
    rings_ = rings;
    chains_.clear();
    lowest_corners_.clear();
    for (std::uint32_t i = 0; i < rings_.size(); ++i) {
      if (!add_ring(i)) return false;
    }
    std::sort(chains_.begin(), chains_.end(),
              [](const Chain& a, const Chain& b) { return a.box.min.y < b.box.min.y; });
    choose_columns();
    for (std::uint32_t i = 0; i < chains_.size(); ++i) {
      if (!enter(i)) return false;
    }
    return true;
  }

 private:
  Point corner(std::uint32_t ring, std::uint32_t i) const {
    const Ring& points = rings_[ring];
    return points[i < points.size() ? i : i - points.size()];
  }

  // False when the ring is too short, repeats a corner or runs back over itself.
  bool add_ring(std::uint32_t index) {
    const Ring& ring = rings_[index];
    const auto size = static_cast<std::uint32_t>(ring.size());
    if (size < 3) return false;
    std::uint32_t lowest = 0;
    int right = 0, up = 0;
    for (std::uint32_t i = 0; i < size; ++i) {
      const Point a = ring[i], b = corner(index, i + 1);
      const int edge_right = sign(std::int64_t{b.x} - a.x), edge_up = sign(std::int64_t{b.y} - a.y);
      if (edge_right == 0 && edge_up == 0) return false;
      if (a.y < ring[lowest].y || (a.y == ring[lowest].y && a.x < ring[lowest].x)) lowest = i;
      const bool same_way = i > 0 && right * edge_right >= 0 && up * edge_up >= 0;
      if (!same_way && runs_back(ring[i > 0 ? i - 1 : size - 1], a, b)) return false;
      if (!same_way || i - chains_.back().first == kChainEdgesMax) {
        chains_.push_back({{}, index, i, i, 0});
        chains_.back().box.add(a);
        right = up = 0;
      }
      right |= edge_right;
      up |= edge_up;
      Chain& chain = chains_.back();
      chain.box.add(b);
      chain.last = i + 1;
      chain.up = up;
    }
    const Point before = ring[lowest > 0 ? lowest - 1 : size - 1];
    const std::int64_t turn = cross(before, ring[lowest], corner(index, lowest + 1));
    lowest_corners_.push_back({ring[lowest], turn > 0});
    return true;
  }

  static bool runs_back(Point a, Point b, Point c) {
    if (cross(a, b, c) != 0) return false;
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x) +
               (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - b.y) <
           0;
  }

  // As many as pay for themselves, equally wide.
  void choose_columns() {
    Box box;
    std::uint64_t chains_width = 0;
    for (const Chain& chain : chains_) {
      box.add(chain.box.min);
      box.add(chain.box.max);
      chains_width += static_cast<std::uint64_t>(std::int64_t{chain.box.max.x} - chain.box.min.x);
    }
    const std::size_t wanted = std::clamp<std::size_t>(chains_.size() / 8, 1, kColumnsMax);
    west_ = box.min.x;
    const std::int64_t width = chains_.empty() ? 0 : std::int64_t{box.max.x} - box.min.x;
    const auto columns = [&] { return static_cast<std::size_t>(width >> shift_) + 1; };
    shift_ = 0;
    while (columns() > wanted) ++shift_;
    while (columns() > kColumnsAlways && (chains_width >> shift_) > chains_.size()) ++shift_;
    if (reaching_.size() < columns()) reaching_.resize(columns());
    for (std::size_t i = 0; i < columns(); ++i) reaching_[i].clear();
  }

  [[nodiscard]] std::size_t column_of(std::int32_t x) const {
    return static_cast<std::size_t>((std::int64_t{x} - west_) >> shift_);
  }

  // Tests a chain against those that reach up to it, and its ring for how it nests.
  bool enter(std::uint32_t index) {
    const Chain& chain = chains_[index];
    const LowestCorner& lowest = lowest_corners_[chain.ring];
    if (!lowest.nesting_checked && chain.box.min.y == lowest.corner.y && !nests(chain.ring))
      return false;
    const std::size_t first = column_of(chain.box.min.x), last = column_of(chain.box.max.x);
    for (std::size_t column = first; column <= last; ++column) {
      std::vector<Reach>& reaching = reaching_[column];
      std::size_t kept = 0;
      for (const Reach reach : reaching) {
        if (reach.top < chain.box.min.y) continue;
        reaching[kept++] = reach;
        if (reach.left > chain.box.max.x || reach.right < chain.box.min.x) continue;
        // Both may stand in several columns: the first common one is enough.
        if (column != first && column_of(reach.left) != column) continue;
        if (meet(chains_[reach.chain], chain)) return false;
      }
      reaching.resize(kept);
      reaching.push_back({chain.box.min.x, chain.box.max.x, chain.box.max.y, index});
    }
    return true;
  }

  // Whether the ring stands where one that turns its way may stand.
  bool nests(std::uint32_t ring) {
    LowestCorner& lowest = lowest_corners_[ring];
    lowest.nesting_checked = true;
    int winding = 0;
    for (std::size_t column = 0; column <= column_of(lowest.corner.x); ++column) {
      for (const Reach& reach : reaching_[column]) {
        if (column_of(reach.left) != column || reach.left > lowest.corner.x) continue;
        winding += winding_about(reach.chain, lowest.corner);
      }
    }
    return winding == (lowest.counter_clockwise ? 0 : 1);
  }

  // What the chain adds to the winding number about p, counted along the ray to the left.
  int winding_about(std::uint32_t index, Point p) const {
    const Chain& chain = chains_[index];
    if (chain.up == 0 || chain.box.min.y >= p.y || chain.box.max.y < p.y) return 0;
    if (chain.box.max.x < p.x) return -chain.up;
    for (std::uint32_t i = chain.first; i < chain.last; ++i) {
      const Point a = corner(chain.ring, i), b = corner(chain.ring, i + 1);
      if (std::min(a.y, b.y) >= p.y || std::max(a.y, b.y) < p.y) continue;
      return sign(cross(a, b, p)) * chain.up < 0 ? -chain.up : 0;
    }
    return 0;
  }

  // The chain's edges that come into the box. They follow one another, as a chain goes one way.
  struct Stretch {
    std::uint32_t first, last;
  };
  Stretch stretch_in(const Chain& chain, const Box& box) const {
    const auto comes_in = [&](std::uint32_t i) {
      return box_of(Segment{corner(chain.ring, i), corner(chain.ring, i + 1)}).overlaps(box);
    };
    Stretch stretch{chain.first, chain.last};
    while (stretch.first < chain.last && !comes_in(stretch.first)) ++stretch.first;
    for (stretch.last = stretch.first; stretch.last < chain.last && comes_in(stretch.last);) {
      ++stretch.last;
    }
    return stretch;
  }

  bool meet(const Chain& a, const Chain& b) const {
    const Box common{{std::max(a.box.min.x, b.box.min.x), std::max(a.box.min.y, b.box.min.y)},
                     {std::min(a.box.max.x, b.box.max.x), std::min(a.box.max.y, b.box.max.y)}};
    // Chains that follow one another have nothing in common there but their corner.
    const bool follow = a.ring == b.ring && (a.last == b.first || b.last == a.first);
    if (follow && common.min == common.max) return false;
    const Stretch of_a = stretch_in(a, common);
    if (of_a.first == of_a.last) return false;
    const Stretch of_b = stretch_in(b, common);
    const auto size = static_cast<std::uint32_t>(rings_[a.ring].size());
    for (std::uint32_t i = of_a.first; i < of_a.last; ++i) {
      const Segment one{corner(a.ring, i), corner(a.ring, i + 1)};
      for (std::uint32_t j = of_b.first; j < of_b.last; ++j) {
        const Segment other{corner(b.ring, j), corner(b.ring, j + 1)};
        if (!box_of(other).overlaps(box_of(one))) continue;
        // Neighbours meet in their corner; that none runs back was seen before.
        const std::uint32_t apart = i > j ? i - j : j - i;
        if (a.ring == b.ring && (apart == 1 || apart == size - 1)) continue;
        if (touch(one, other)) return true;
      }
    }
    return false;
  }

  // Closed segments with overlapping boxes have a point in common.
  static bool touch(const Segment& a, const Segment& b) {
    if (sign(cross(a.from, a.to, b.from)) * sign(cross(a.from, a.to, b.to)) > 0) return false;
    return sign(cross(b.from, b.to, a.from)) * sign(cross(b.from, b.to, a.to)) <= 0;
  }

  struct Reach {
    std::int32_t left, right, top;
    std::uint32_t chain;
  };

  std::span<const Ring> rings_;
  std::vector<Chain> chains_;
  std::vector<LowestCorner> lowest_corners_;
  // Chains that reach up to the sweep, or did, in every column of x that they pass.
  std::vector<std::vector<Reach>> reaching_;
  std::int32_t west_ = 0;
  int shift_ = 0;
};

}  // namespace

bool keep_clear(const std::vector<Ring>& rings) {
  thread_local Sweep sweep;
  return sweep.clear(rings);
}

}  // namespace core
