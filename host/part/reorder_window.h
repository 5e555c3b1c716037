// Sorts triangles that arrive nearly in order of lowest z, holding a few of them.
//
//     push ──> ( the lowest of those held leaves ) ──> pop
//
// With room for K triangles, the result is in order if and only if no triangle comes after more
// than K higher ones.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/geometry.h"  // Triangle

namespace host {

// Triangles that come in order are held in a ring; one that is a little late moves up past a few.
// Where this takes too long, all go into a heap, for good.
class ReorderWindow {
 public:
  ReorderWindow() = default;
  // Starts with these.
  explicit ReorderWindow(std::vector<core::Triangle> triangles);

  // COSTS: O(1) for triangles in order, amortised O(log size()) at worst.
  void push(const core::Triangle& triangle);
  // Of equally low ones, any. REQUIRES: not empty. COSTS: O(1); in a heap, O(log size()).
  [[nodiscard]] core::Triangle pop();

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t size() const { return count_; }

 private:
  // Places that triangles may move up in all, for each that is pushed.
  static constexpr std::size_t kMovesEach = 16;

  [[nodiscard]] core::Triangle& at(std::size_t i) {
    const std::size_t place = first_ + i;
    return held_[place < held_.size() ? place : place - held_.size()];
  }
  void make_room();
  void make_heap();

  std::vector<core::Triangle> held_;  // a ring of its size; or a heap, the lowest in front
  std::size_t first_ = 0;             // of the ring
  std::size_t count_ = 0;
  std::size_t moves_left_ = 0;
  bool is_heap_ = false;
};

// Decides whether a sequence of triangles is nearly in order, in one pass and in constant memory.
//
//     ░░░░░░░░ block ░░░░░░░░ block ░░░░░░░░ block         none lower than any that came two
//      highest of all ─────────────────> none lower        blocks before: two blocks are K
//
// in_order() implies that a ReorderWindow with room for K sorts the sequence; the reverse need not
// hold.
class OrderGauge {
 public:
  // REQUIRES: window >= 2
  explicit OrderGauge(std::size_t window) : block_(window / 2) {}

  void add(const core::Triangle& triangle);

  [[nodiscard]] bool in_order() const { return in_order_; }

 private:
  std::size_t block_;
  std::size_t in_block_ = 0;
  // Maxima of lowest z: in this block; up to the end of the last block; up to that of the one
  // before.
  std::int64_t here_ = INT64_MIN, before_ = INT64_MIN, long_before_ = INT64_MIN;
  bool in_order_ = true;
};

}  // namespace host
