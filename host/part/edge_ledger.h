// Whether a surface is closed and which way its facets are turned, from seeing each facet once, in
// constant memory.
//
// In a sound surface every edge is walked once in either direction. Each directed edge adds a
// number made from its ends, and its reverse takes the same away; a closed surface leaves 0. A sum
// of 0 by chance, from a surface with holes, has odds of one in 2^64.
//
// Where a facet is turned over against its neighbour, their edge runs the same way twice. The sums
// are kept in cells, by edge, with the edge's place: a cell in which a single edge is left over
// tells where it is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry.h"  // Triangle, Box

namespace host {

class EdgeLedger {
 public:
  // REQUIRES: the corners are three points
  void add(const core::Triangle& triangle);

  [[nodiscard]] bool closed() const { return sum_ == 0; }

  struct Turned {
    std::int64_t edges = 0;  // that run the same way twice
    bool exact = true;       // false: about so many
    bool placed = true;      // false: it is not known where
    core::Box box;           // around them in the plane; empty where it is not known
    core::Vertex lowest;     // the middle of one of the lowest
  };
  // Nothing where no edge is known to run the same way twice.
  // COSTS: a look at every cell.
  [[nodiscard]] std::optional<Turned> turned() const;

 private:
  struct Cell {
    std::int64_t count = 0;
    std::uint64_t number = 0;
    // Of both ends together, as often as counted.
    std::uint64_t x = 0;
    std::uint64_t y = 0;
    std::uint64_t z = 0;
  };

  // From p to q, whose numbers these are.
  void add_edge(const core::Vertex& p, std::uint64_t p_number, const core::Vertex& q,
                std::uint64_t q_number);

  std::uint64_t sum_ = 0;
  std::uint64_t parity_ = 0;  // 0: every edge is there an even number of times
  std::vector<Cell> cells_{kCells};
  static constexpr std::size_t kCells = 1'024;
};

}  // namespace host
