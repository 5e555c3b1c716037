// Finds boxes that overlap: groups of eight, boxes around the groups, and so on up to one group.
//
//     ┌──────────────────┐    Boxes that are added one after the other share groups, so those had
//     │┌──┬─┐   ┌──┬────┐│    better be near. Where there are many rings, RingOrder puts
//     ││  ├─┤   │  ├──┐ ││    them in such an order.
//     │└──┴─┘   └──┴──┴─┘│
//     └──────────────────┘
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry.h"           // Box, Ring
#include "core/regions/box_group.h"  // BoxGroup

namespace core {

class BoxTree {
 public:
  using Item = std::uint32_t;

  // Memory is kept for the next boxes.
  void clear();
  // REQUIRES: the box is not empty. An item may have several boxes.
  void add(const Box& box, Item item) {
    if (open_ == BoxGroup::kSize) close_group();
    if (open_ == 0) {
      groups_.emplace_back();
      items_.emplace_back();
    }
    groups_.back().set(open_, box);
    items_.back()[open_++] = item;
  }
  // The next box starts a group of its own, if so many boxes do not fit into the open one.
  void keep_together(std::size_t boxes) {
    if (open_ + boxes > BoxGroup::kSize) close_group();
  }
  // No box is added after it. COSTS: O(boxes), as all of the above together.
  void finish();

  // visit(Item) for the boxes that overlap this one, in the order in which they were added.
  // REQUIRES of all that follow: finish() was called.
  template <typename Visit>
  void for_items_in(const Box& box, Visit visit) const {
    if (!levels_.empty()) search(BoxGroup::Query(box), levels_.size() - 1, 0, visit);
  }

  // visit(Item, Item) for every two boxes that overlap; true, and no further, once it returns true.
  template <typename Visit>
  [[nodiscard]] bool any_pair(Visit visit) const {
    return !levels_.empty() && any_within(levels_.size() - 1, 0, visit);
  }

 private:
  using Lanes = std::array<Item, BoxGroup::kSize>;

  void close_group() { open_ = 0; }
  [[nodiscard]] const BoxGroup& group(std::size_t level, std::uint32_t i) const {
    return groups_[levels_[level] + i];
  }
  template <typename Visit>
  void search(const BoxGroup::Query& box, std::size_t level, std::uint32_t i, Visit& visit) const;
  template <typename Visit>
  [[nodiscard]] bool any_within(std::size_t level, std::uint32_t i, Visit& visit) const;
  template <typename Visit>
  [[nodiscard]] bool any_between(std::size_t level, std::uint32_t i, std::uint32_t k,
                                 const Box& around_k, Visit& visit) const;

  // Level by level; the box in lane j of group i is around group 8 · i + j of the level below.
  std::vector<BoxGroup> groups_;
  std::vector<std::uint32_t> levels_;  // the first group of each
  std::vector<Lanes> items_;           // by group of level 0
  std::uint32_t open_ = 0;             // boxes in the group that is being filled
};

// Numbers of rings, as they are, or, if there are more than a few, so that neighbours are near.
class RingOrder {
 public:
  // The first points of `count` rings. What is returned holds until the next call.
  template <typename FirstOf>
  std::span<const std::uint32_t> near_by_near(std::size_t count, FirstOf first_of) {
    start(count);
    if (count > kRingsAsTheyAre) {
      for (auto& [place, ring] : places_) place = place_of(first_of(ring));
      sort();
    }
    return order_;
  }

 private:
  static constexpr std::size_t kRingsAsTheyAre = 8;
  static std::uint64_t place_of(Point p);
  void start(std::size_t count);
  void sort();

  std::vector<std::pair<std::uint64_t, std::uint32_t>> places_;
  std::vector<std::uint32_t> order_;
};

// Implementation details follow.

template <typename Visit>
void BoxTree::search(const BoxGroup::Query& box, std::size_t level, std::uint32_t i,
                     Visit& visit) const {
  const std::uint32_t overlapping = group(level, i).overlapping(box);
  if (level == 0) {
    for_lanes(overlapping, [&](std::uint32_t lane) { visit(items_[i][lane]); });
  } else {
    for_lanes(overlapping, [&](std::uint32_t lane) {
      search(box, level - 1, BoxGroup::kSize * i + lane, visit);
    });
  }
}

template <typename Visit>
bool BoxTree::any_within(std::size_t level, std::uint32_t i, Visit& visit) const {
  const BoxGroup& all = group(level, i);
  for (std::uint32_t lane = 0; lane < BoxGroup::kSize; ++lane) {
    const Box box = all.box(lane);
    std::uint32_t overlapping = all.overlapping(box);
    if (overlapping == 0) break;  // empty, as all after it
    const std::uint32_t child = BoxGroup::kSize * i + lane;
    if (level > 0 && any_within(level - 1, child, visit)) return true;
    overlapping &= ~std::uint32_t{1} << lane;
    for (; overlapping != 0; overlapping &= overlapping - 1) {
      const auto other = static_cast<std::uint32_t>(std::countr_zero(overlapping));
      if (level == 0
              ? visit(items_[i][lane], items_[i][other])
              : any_between(level - 1, child, BoxGroup::kSize * i + other, all.box(other), visit)) {
        return true;
      }
    }
  }
  return false;
}

template <typename Visit>
bool BoxTree::any_between(std::size_t level, std::uint32_t i, std::uint32_t k, const Box& around_k,
                          Visit& visit) const {
  const BoxGroup &one = group(level, i), &other = group(level, k);
  for (std::uint32_t near = one.overlapping(around_k); near != 0; near &= near - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
    for (std::uint32_t met = other.overlapping(one.box(lane)); met != 0; met &= met - 1) {
      const auto lane_k = static_cast<std::uint32_t>(std::countr_zero(met));
      if (level == 0 ? visit(items_[i][lane], items_[k][lane_k])
                     : any_between(level - 1, BoxGroup::kSize * i + lane,
                                   BoxGroup::kSize * k + lane_k, other.box(lane_k), visit)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace core
