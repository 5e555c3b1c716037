// Puts triangles that come nearly in order of lowest z into that order, holding a few of them.
//
//     push ──> ( the lowest of those held leaves ) ──> pop
//
// With room for K, the order comes out right exactly when no triangle has more than K before it
// that are higher.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/geometry.h"  // Triangle

namespace host {

class ReorderWindow {
 public:
  ReorderWindow() = default;
  // Begins with these.
  explicit ReorderWindow(std::vector<core::Triangle> triangles);

  void push(const core::Triangle& triangle);
  // REQUIRES: not empty. COSTS: O(log size()).
  [[nodiscard]] core::Triangle pop();

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }

 private:
  std::vector<core::Triangle> heap_;  // the lowest in front
};

// Tells whether a row of triangles is nearly in order, in constant memory and in one pass.
//
//     ░░░░░░░░ block ░░░░░░░░ block ░░░░░░░░ block         none lower than any that came two
//      highest of all ─────────────────> none lower        blocks before: two blocks are K
//
// Says yes only where a ReorderWindow with room for K does; it may say no although one would.
class OrderGauge {
 public:
  // REQUIRES: window >= 2
  explicit OrderGauge(std::size_t window) : block_(window / 2) {}

  void add(const core::Triangle& triangle);

  [[nodiscard]] bool in_order() const { return in_order_; }

 private:
  std::size_t block_;
  std::size_t in_block_ = 0;
  // Highest of the lowest z: in this block, up to the last one's end, up to the one's before.
  std::int64_t here_ = INT64_MIN, before_ = INT64_MIN, long_before_ = INT64_MIN;
  bool in_order_ = true;
};

}  // namespace host
