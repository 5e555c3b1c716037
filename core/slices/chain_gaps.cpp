#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/slices/segment_chains.h"

namespace core {
namespace {

using End = std::size_t;  // 2i: where chain i starts; 2i + 1: where it ends

constexpr End kFree = std::numeric_limits<End>::max();

std::int64_t squared_distance(Point a, Point b) {
  const std::int64_t dx = std::int64_t{a.x} - b.x, dy = std::int64_t{a.y} - b.y;
  return dx * dx + dy * dy;
}

class GapCloser {
 public:
  explicit GapCloser(std::vector<Chain> chains)
      : chains_(std::move(chains)),
        joined_(2 * chains_.size(), kFree),
        other_end_(2 * chains_.size()),
        length_units_(2 * chains_.size()),
        gap_units_(2 * chains_.size(), 0) {
    for (End end = 0; end < other_end_.size(); ++end) {
      other_end_[end] = end ^ 1;
      length_units_[end] = chains_[end / 2].length_units();
    }
  }

  // Within twice the distance of the round before, no cell has more than a few free ends: those
  // closer together were joined then. So no round costs more than O(n log n).
  void join_nearest(std::int64_t gap_max) {
    for (std::int64_t reach = 1; gap_max > 0; reach = std::min(2 * reach, gap_max)) {
      join_in_order(pairs_within(reach), Rule::kAnyEnds);
      if (reach == gap_max) break;
    }
  }

  void join_wide() {
    std::vector<End> ends = free_ends();
    if (ends.size() > 2 * kWideGapChainsMax) {
      std::stable_sort(ends.begin(), ends.end(),
                       [this](End a, End b) { return length_units_[a] > length_units_[b]; });
      ends.resize(2 * kWideGapChainsMax);
    }
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = i + 1; j < ends.size(); ++j) pairs.push_back(pair(ends[i], ends[j]));
    }
    join_in_order(std::move(pairs), Rule::kEndToBegin);
  }

  [[nodiscard]] std::vector<Chain> closed(Length gap_max, SliceDefects& defects) {
    std::vector<bool> visited(chains_.size(), false);
    std::vector<Chain> rings;
    // Runs of joined chains that have a free end do not close.
    for (const End end : free_ends()) {
      if (visited[end / 2]) continue;
      for (End at = end; at != kFree; at = joined_[at ^ 1]) visited[at / 2] = true;
      ++defects.dropped_chains;
    }
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (!visited[i]) rings.push_back(ring_from(2 * i, visited, gap_max, defects));
    }
    return rings;
  }

 private:
  struct Pair {
    std::int64_t squared = 0;
    End a = 0;
    End b = 0;
    auto operator<=>(const Pair&) const = default;
  };
  enum class Rule { kAnyEnds, kEndToBegin };

  [[nodiscard]] Point point(End end) const {
    const std::vector<Point>& points = chains_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  [[nodiscard]] Pair pair(End a, End b) const {
    return {squared_distance(point(a), point(b)), std::min(a, b), std::max(a, b)};
  }

  [[nodiscard]] std::vector<End> free_ends() const {
    std::vector<End> ends;
    for (End end = 0; end < joined_.size(); ++end) {
      if (joined_[end] == kFree) ends.push_back(end);
    }
    return ends;
  }

  struct Cell {
    std::int64_t column = 0;
    std::int64_t row = 0;
    End end = 0;
    auto operator<=>(const Cell&) const = default;
  };

  [[nodiscard]] std::vector<Pair> pairs_within(std::int64_t reach) const {
    std::vector<Cell> cells;
    for (const End end : free_ends()) {
      const Point p = point(end);
      cells.push_back(
          {(p.x + (std::int64_t{1} << 32)) / reach, (p.y + (std::int64_t{1} << 32)) / reach, end});
    }
    std::sort(cells.begin(), cells.end());
    std::vector<Pair> pairs;
    for (const Cell& cell : cells) {
      for (std::int64_t column = cell.column - 1; column <= cell.column + 1; ++column) {
        auto near = std::lower_bound(cells.begin(), cells.end(), Cell{column, cell.row - 1, 0});
        for (; near != cells.end() && near->column == column && near->row <= cell.row + 1; ++near) {
          if (near->end <= cell.end) continue;
          const Pair found = pair(cell.end, near->end);
          if (found.squared <= reach * reach) pairs.push_back(found);
        }
      }
    }
    return pairs;
  }

  void join_in_order(std::vector<Pair> pairs, Rule rule) {
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [squared, a, b] : pairs) {
      if (joined_[a] != kFree || joined_[b] != kFree) continue;
      if (rule == Rule::kEndToBegin && a % 2 == b % 2) continue;
      const double gap = std::sqrt(static_cast<double>(squared));
      const bool onto_itself = other_end_[a] == b;
      const double length = length_units_[a] + (onto_itself ? 0 : length_units_[b]);
      const double gaps = gap + gap_units_[a] + (onto_itself ? 0 : gap_units_[b]);
      const bool limited = onto_itself || rule == Rule::kEndToBegin;
      if (limited && gaps > kGapShareMax * length) continue;
      joined_[a] = b;
      joined_[b] = a;
      const End first = other_end_[a], last = other_end_[b];
      other_end_[first] = last;
      other_end_[last] = first;
      length_units_[first] = length_units_[last] = length;
      gap_units_[first] = gap_units_[last] = gaps;
    }
  }

  [[nodiscard]] Chain ring_from(End start, std::vector<bool>& visited, Length gap_max,
                                SliceDefects& defects) {
    Chain ring;
    End at = start;
    do {
      Chain& piece = chains_[at / 2];
      visited[at / 2] = true;
      const double gap = std::sqrt(static_cast<double>(pair(at ^ 1, joined_[at ^ 1]).squared));
      const auto width = Length::from_units(static_cast<std::int64_t>(std::ceil(gap)));
      defects.widest_gap = std::max(defects.widest_gap, width);
      if (width > gap_max) ++defects.wide_chains;
      ++defects.closed_chains;
      if (at % 2 == 1) piece.reverse();
      ring.points.insert(ring.points.end(), piece.points.begin(), piece.points.end());
      ring.segments.insert(ring.segments.end(), piece.segments.begin(), piece.segments.end());
      ring.segments.push_back(kNoSegment);
      ring.along.facets += piece.along.facets;
      ring.along.length_units += piece.along.length_units;
      ring.against.facets += piece.against.facets;
      ring.against.length_units += piece.against.length_units;
      at = joined_[at ^ 1];
    } while (at != start);
    if (ring.against.length_units > ring.along.length_units) ring.reverse();
    return ring;
  }

  std::vector<Chain> chains_;
  std::vector<End> joined_;           // the end this one is joined to
  std::vector<End> other_end_;        // of the run of joined chains that ends here
  std::vector<double> length_units_;  // of that run's chains
  std::vector<double> gap_units_;     // of the gaps between them
};

}  // namespace

std::vector<Chain> closed_across_gaps(std::vector<Chain> open, Length gap_max,
                                      SliceDefects& defects) {
  GapCloser closer(std::move(open));
  closer.join_nearest(gap_max.units());
  closer.join_wide();
  return closer.closed(gap_max, defects);
}

}  // namespace core
