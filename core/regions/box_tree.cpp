#include "core/regions/box_tree.h"

#include <algorithm>

namespace core {
namespace {

// The bits of a number of 32 bits, each with a 0 before it.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0x0000FFFF0000FFFF;
  bits = (bits | bits << 8) & 0x00FF00FF00FF00FF;
  bits = (bits | bits << 4) & 0x0F0F0F0F0F0F0F0F;
  bits = (bits | bits << 2) & 0x3333333333333333;
  return (bits | bits << 1) & 0x5555555555555555;
}

}  // namespace

void BoxTree::clear() {
  groups_.clear();
  levels_.clear();
  items_.clear();
  open_ = 0;
}

void BoxTree::finish() {
  close_group();
  if (groups_.empty()) return;
  levels_.push_back(0);
  for (std::size_t first = 0, end = groups_.size(); end - first > 1;
       first = end, end = groups_.size()) {
    levels_.push_back(static_cast<std::uint32_t>(end));
    for (std::size_t i = first; i < end; i += BoxGroup::kSize) {
      BoxGroup above;
      const std::size_t count = std::min<std::size_t>(BoxGroup::kSize, end - i);
      for (std::size_t lane = 0; lane < count; ++lane) {
        above.set(static_cast<std::uint32_t>(lane), groups_[i + lane].around());
      }
      groups_.push_back(above);
    }
  }
}

// Where a point lies on a curve that fills the plane, so that neighbours on it are near.
std::uint64_t RingOrder::place_of(Point p) {
  const auto from_corner = [](std::int32_t value) {
    return static_cast<std::uint64_t>(std::int64_t{value} - INT32_MIN);
  };
  return spread(from_corner(p.x)) | spread(from_corner(p.y)) << 1;
}

void RingOrder::start(std::size_t count) {
  places_.clear();
  order_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    places_.emplace_back(0, i);
    order_.push_back(i);
  }
}

void RingOrder::sort() {
  std::sort(places_.begin(), places_.end());
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = places_[i].second;
}

}  // namespace core
