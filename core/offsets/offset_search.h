// Which edges can reach which offset elements: one neighbour search for all depths.
//
// Consecutive edges are gathered in chunks of up to 8, each with a box. The elements that a chunk
// raises up to the deepest depth D lie in its raised box, and an edge can trim them only from
// within D of that box. A tree of the chunks' boxes (box_tree.h) finds all chunks that are so near
// and not of the same run. Long slanting edges have several boxes. More may be found than are
// needed, never fewer, so the tree decides nothing.
//
//       raised box  ┌───────────┐   D
//                   │  ‾‾‾‾‾‾   │◄─────► box of another chunk: a neighbour
//       edges       └─╱──────╲──┘
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/offsets/offset_input.h"  // OffsetInput
#include "core/regions/box_tree.h"      // BoxTree, RingOrder

namespace core {

struct OffsetBox {
  double min_x, min_y, max_x, max_y;

  void add(double x, double y) {
    min_x = x < min_x ? x : min_x;
    max_x = x > max_x ? x : max_x;
    min_y = y < min_y ? y : min_y;
    max_y = y > max_y ? y : max_y;
  }
  // Squared distance between the boxes; 0 when they meet.
  [[nodiscard]] double distance_squared(const OffsetBox& other) const {
    const double left = other.min_x - max_x, right = min_x - other.max_x;
    const double down = other.min_y - max_y, up = min_y - other.max_y;
    const double dx = left > right ? left : right, dy = down > up ? down : up;
    const double gap_x = dx > 0 ? dx : 0, gap_y = dy > 0 ? dy : 0;
    return gap_x * gap_x + gap_y * gap_y;
  }
};

struct OffsetChunk {
  OffsetBox box;
  std::int32_t first, last;  // its edges, half open
  std::int32_t run;          // the run that all its edges belong to, or -1
  bool open;                 // a corner's arc belongs to no run: its own run matters to it
};

class OffsetSearch {
 public:
  // COSTS: O(n log n + what is found).
  void prepare(const OffsetInput& contours, double deepest);

  [[nodiscard]] const std::vector<OffsetChunk>& chunks() const { return chunks_; }
  [[nodiscard]] double deepest() const { return deepest_; }
  // The chunks near `chunk`, itself included if it matters.
  [[nodiscard]] std::span<const std::int32_t> neighbours(std::size_t chunk) const {
    return std::span(neighbours_)
        .subspan(neighbours_first_[chunk], neighbours_first_[chunk + 1] - neighbours_first_[chunk]);
  }

 private:
  void gather_chunks(const OffsetInput& contours);
  void start_chunk(const OffsetInput& contours, std::int32_t index);
  void plant_tree(const OffsetInput& contours);
  void find_neighbours(const OffsetInput& contours, std::size_t chunk);
  [[nodiscard]] OffsetBox raised_box(const OffsetInput& contours, const OffsetChunk& chunk) const;
  template <typename Visit>
  void for_parts(const OffsetInput& contours, const OffsetChunk& chunk, Visit visit) const;
  [[nodiscard]] std::int32_t part_count(const OffsetChunk& chunk) const;

  double deepest_ = 0;
  std::vector<OffsetChunk> chunks_;
  std::vector<std::int32_t> neighbours_;
  std::vector<std::size_t> neighbours_first_;

  BoxTree tree_;
  double part_max_ = 0;                     // of the shorter side of a part's box
  std::vector<std::size_t> contour_first_;  // the first chunk of each contour
  RingOrder order_;
  std::vector<std::int32_t> seen_by_;  // per chunk: the last chunk that found it
};

}  // namespace core
