// The nearest of a set of points that only shrinks: a tree of boxes, each halved across its longer
// side down to a few points. A box that has lost all of its points is passed by, so that what was
// left behind, far away, is found as fast as what is near.
//
// Keywords: k-d tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"  // Point

namespace core {

class NearestPoint {
 public:
  struct Entry {
    Point point;
    std::size_t owner = 0;  // what the caller knows it by
    std::size_t index = 0;  // which of the owner's points
  };

  // COSTS: O(entries log entries). REQUIRES: fewer than 2^32; best, but not needed, an owner's in
  // one run.
  explicit NearestPoint(std::vector<Entry> entries);

  // Takes all of an owner's points away. REQUIRES: the owner had a point at first.
  // COSTS: O(log entries) for each of them.
  void remove_owner(std::size_t owner);

  // The nearest that is left; of equally near ones the first as they were given.
  // COSTS: O(log entries) as a rule.
  [[nodiscard]] std::optional<Entry> nearest(Point to) const;

 private:
  struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  struct Place {
    Point point;
    std::uint32_t entry = 0;
  };

  struct Node {
    Box box;                     // of the points at first
    std::uint32_t begin = 0;     // into places_
    std::uint32_t left = 0;      // how many points are left; in a leaf, those from `begin` on
    std::uint32_t parent = 0;    // the root: itself
    std::uint32_t far_side = 0;  // the second half's node, the first half's is the next; 0: a leaf
  };

  struct Best {
    std::optional<std::uint32_t> entry;
    double distance2 = 0;
  };

  // The node of a run of places_, and all below it.
  void add_node(std::uint32_t begin, std::uint32_t end, std::uint32_t parent);
  void look(std::uint32_t number, Point to, Best& best) const;

  std::vector<Entry> entries_;
  std::vector<Range> of_owner_;         // the entries from its first to its last
  std::vector<Place> places_;           // of all entries, each leaf's in one run
  std::vector<std::uint32_t> leaf_of_;  // by entry
  std::vector<Node> nodes_;             // each before those below it
};

}  // namespace core
