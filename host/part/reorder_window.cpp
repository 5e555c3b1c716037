#include "host/part/reorder_window.h"

#include <algorithm>

#include "core/check.h"  // RIND_CHECK

namespace host {
namespace {

bool lower(const core::Triangle& a, const core::Triangle& b) { return a.lowest_z() < b.lowest_z(); }
bool later(const core::Triangle& a, const core::Triangle& b) { return lower(b, a); }

}  // namespace

ReorderWindow::ReorderWindow(std::vector<core::Triangle> triangles)
    : held_(std::move(triangles)), count_(held_.size()) {
  if (!std::is_sorted(held_.begin(), held_.end(), lower)) {
    std::sort(held_.begin(), held_.end(), lower);
  }
  moves_left_ = kMovesEach * count_;
}

void ReorderWindow::make_room() {
  const std::size_t room = std::max({held_.capacity(), 2 * count_, std::size_t{16}});
  std::rotate(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(first_), held_.end());
  first_ = 0;
  held_.resize(room);
}

void ReorderWindow::make_heap() {
  std::rotate(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(first_), held_.end());
  held_.resize(count_);
  std::make_heap(held_.begin(), held_.end(), later);
  is_heap_ = true;
}

void ReorderWindow::push(const core::Triangle& triangle) {
  ++count_;
  if (is_heap_) {
    held_.push_back(triangle);
    return std::push_heap(held_.begin(), held_.end(), later);
  }
  if (count_ > held_.size()) {
    --count_;
    make_room();
    ++count_;
  }
  std::size_t place = count_ - 1;
  moves_left_ += kMovesEach;
  for (; place > 0 && moves_left_ > 0 && lower(triangle, at(place - 1)); --place, --moves_left_) {
    at(place) = at(place - 1);
  }
  at(place) = triangle;
  if (moves_left_ == 0) make_heap();
}

core::Triangle ReorderWindow::pop() {
  RIND_CHECK(count_ > 0);
  --count_;
  if (is_heap_) {
    std::pop_heap(held_.begin(), held_.end(), later);
    const core::Triangle lowest = held_.back();
    held_.pop_back();
    return lowest;
  }
  const core::Triangle lowest = at(0);
  if (++first_ == held_.size()) first_ = 0;
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
