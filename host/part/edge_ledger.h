// Finds out whether a surface is closed and its facets are oriented alike, in one pass over the
// facets and in constant memory.
//
// In a sound surface, every edge occurs once in each direction. Each directed edge adds a number
// computed from its ends; the reverse edge subtracts the same number. The sum over a closed surface
// is 0. A surface with holes gives 0 with a probability of 2^-64.
//
// If two neighbouring facets are oriented differently, their common edge runs the same way twice.
// The edges are hashed into cells with a sum each, and with the sum of their coordinates: a cell in
// which one edge remains gives the position of that edge.
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
    bool exact = true;       // false: `edges` is an estimate
    bool placed = true;      // false: the positions are not known
    core::Box box;           // around them in the plane; empty if not known
    core::Vertex lowest;     // the middle of one of the lowest edges
  };
  // Nullopt if no edge is known to run the same way twice. COSTS: O(cells).
  [[nodiscard]] std::optional<Turned> turned() const;

 private:
  struct Cell {
    std::int64_t count = 0;
    std::uint64_t number = 0;
    // Sums over both ends, with the edge's sign.
    std::uint64_t x = 0;
    std::uint64_t y = 0;
    std::uint64_t z = 0;
  };

  // The edge from p to q; each end with its hash.
  void add_edge(const core::Vertex& p, std::uint64_t p_number, const core::Vertex& q,
                std::uint64_t q_number);

  std::uint64_t sum_ = 0;
  std::uint64_t parity_ = 0;  // 0: every edge occurs an even number of times
  std::vector<Cell> cells_{kCells};
  static constexpr std::size_t kCells = 1'024;
};

}  // namespace host
