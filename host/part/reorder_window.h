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

class ReorderWindow {
 public:
  ReorderWindow() = default;
  // Starts with these.
  explicit ReorderWindow(std::vector<core::Triangle> triangles);

  void push(const core::Triangle& triangle);
  // REQUIRES: not empty. COSTS: O(log size()).
  [[nodiscard]] core::Triangle pop();

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }

 private:
  std::vector<core::Triangle> heap_;  // the lowest in front
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
