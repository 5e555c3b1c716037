#include "core/regions/box_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/random_regions.h"

using core::Box;
using core::BoxTree;
using test::Random;

namespace {

Box random_box(Random& random, int place, int size) {
  const core::Point at{random.integer(-place, place), random.integer(-place, place)};
  return {at, {at.x + random.integer(0, size), at.y + random.integer(0, size)}};
}

struct Tree {
  std::vector<Box> boxes;
  BoxTree tree;

  Tree(Random& random, int count, int size) { plant(random, count, size); }
  void plant(Random& random, int count, int size) {
    boxes.clear();
    tree.clear();
    for (int i = 0; i < count; ++i) {
      if (random.integer(0, 9) == 0) tree.keep_together(static_cast<std::size_t>(i % 9));
      boxes.push_back(random_box(random, 1'000, size));
      tree.add(boxes.back(), static_cast<BoxTree::Item>(i));
    }
    tree.finish();
  }
};

}  // namespace

TEST_CASE("a tree finds the boxes that overlap one, each once, in the order they were added") {
  Random random(1);
  std::size_t found = 0;
  Tree tree(random, 0, 1);
  for (int count : {0, 1, 7, 8, 9, 63, 64, 65, 600, 5'000, 3}) {
    CAPTURE(count);
    tree.plant(random, count, 150);
    for (int i = 0; i < 50; ++i) {
      const Box query = random_box(random, 1'200, 300);
      std::vector<BoxTree::Item> wanted, items;
      for (BoxTree::Item k = 0; k < tree.boxes.size(); ++k) {
        if (tree.boxes[k].overlaps(query)) wanted.push_back(k);
      }
      tree.tree.for_items_in(query, [&](BoxTree::Item item) { items.push_back(item); });
      CHECK(items == wanted);
      found += items.size();
    }
  }
  CHECK_GT(found, 1'000u);
}

TEST_CASE("a tree finds every two boxes that overlap, once, and stops when it is told to") {
  Random random(2);
  std::size_t found = 0;
  for (int count : {0, 1, 8, 9, 70, 600, 2'000}) {
    CAPTURE(count);
    const Tree tree(random, count, 120);
    std::set<std::pair<BoxTree::Item, BoxTree::Item>> wanted, pairs;
    for (BoxTree::Item i = 0; i < tree.boxes.size(); ++i) {
      for (BoxTree::Item k = i + 1; k < tree.boxes.size(); ++k) {
        if (tree.boxes[i].overlaps(tree.boxes[k])) wanted.emplace(i, k);
      }
    }
    std::size_t visits = 0;
    CHECK_FALSE(tree.tree.any_pair([&](BoxTree::Item i, BoxTree::Item k) {
      pairs.emplace(std::min(i, k), std::max(i, k));
      ++visits;
      return false;
    }));
    CHECK(pairs == wanted);
    CHECK_EQ(visits, wanted.size());
    found += visits;
    std::size_t left = (visits + 1) / 2;
    const bool stopped =
        tree.tree.any_pair([&](BoxTree::Item, BoxTree::Item) { return --left == 0; });
    CHECK_EQ(stopped, visits > 0);
    CHECK_EQ(left, 0u);
  }
  CHECK_GT(found, 1'000u);
}

TEST_CASE("many rings are put in an order in which neighbours are near") {
  // A grid of places, visited at random: the way from one to the next is some steps, not a grid's
  // width.
  std::vector<core::Point> places;
  for (int x = 0; x < 32; ++x) {
    for (int y = 0; y < 32; ++y) places.push_back({x * 100, y * 100});
  }
  Random random(3);
  for (std::size_t i = places.size() - 1; i > 0; --i) {
    std::swap(places[i], places[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  core::RingOrder order;
  const auto all = order.near_by_near(places.size(), [&](std::uint32_t i) { return places[i]; });
  REQUIRE_EQ(all.size(), places.size());
  CHECK_EQ(std::set<std::uint32_t>(all.begin(), all.end()).size(), places.size());
  double way = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    const core::Point a = places[all[i - 1]], b = places[all[i]];
    way += std::abs(a.x - b.x) + std::abs(a.y - b.y);
  }
  CHECK_LT(way / static_cast<double>(all.size()), 300);
  const auto few = order.near_by_near(8, [&](std::uint32_t i) { return places[i]; });
  for (std::uint32_t i = 0; i < 8; ++i) CHECK_EQ(few[i], i);
}
