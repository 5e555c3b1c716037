#include "host/part/reorder_window.h"

#include <algorithm>

#include "core/check.h"               // RIND_CHECK
#include "host/part/triangle_runs.h"  // lower

namespace host {
namespace {

bool later(const core::Triangle& a, const core::Triangle& b) { return lower(b, a); }

}  // namespace

ReorderWindow::ReorderWindow(std::vector<core::Triangle> triangles) : heap_(std::move(triangles)) {
  std::make_heap(heap_.begin(), heap_.end(), later);
}

void ReorderWindow::push(const core::Triangle& triangle) {
  heap_.push_back(triangle);
  std::push_heap(heap_.begin(), heap_.end(), later);
}

core::Triangle ReorderWindow::pop() {
  RIND_CHECK(!heap_.empty());
  std::pop_heap(heap_.begin(), heap_.end(), later);
  const core::Triangle lowest = heap_.back();
  heap_.pop_back();
  return lowest;
}

void OrderGauge::add(const core::Triangle& triangle) {
  const std::int64_t z = triangle.lowest_z();
  if (in_block_ == block_) {
    long_before_ = before_;
    before_ = std::max(before_, here_);
    here_ = INT64_MIN;
    in_block_ = 0;
  }
  ++in_block_;
  here_ = std::max(here_, z);
  in_order_ = in_order_ && z >= long_before_;
}

}  // namespace host
