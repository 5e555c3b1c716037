// Makes a case for the booleans from any bytes: rings on a coarse grid, so that corners, edges and
// whole rings often coincide. Random tests and the fuzzer share it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"  // FillRule
#include "core/geometry.h"          // Ring

namespace test {

struct BooleanCase {
  // Three raw operands: their rings may cross, fold back, repeat.
  std::vector<core::Ring> rings[3];
  core::FillRule rule = core::FillRule::kNonZero;
  // Units from one grid line to the next: 1 (all is rounding) to 2^25.
  std::int32_t scale = 1;
  // The second operand also has all rings of the first one.
  bool shares_rings = false;
};

[[nodiscard]] BooleanCase boolean_case(std::span<const std::uint8_t> bytes);

// Checks every operation on the case: results are clean, contain the right points (tested at points
// away from all edges, by the operands' winding numbers), and don't depend on the operands' order.
// Returns what was wrong; empty if nothing.
[[nodiscard]] std::string check_operations(const BooleanCase& input);

// Results of comparisons with Boost.Polygon.
struct BooleanComparison {
  std::int64_t compared = 0;  // results
  std::int64_t wider = 0;     // that differ by more than 2 units: Boost.Polygon is off there
  double widest = 0;          // difference, units
};

// The same against Boost.Polygon: if the difference has a piece wider than 2 units, points in it
// away from the operands' edges decide who is right. Only for coordinates at which Boost.Polygon is
// usually right. Returns what was wrong with ours; empty if nothing.
[[nodiscard]] std::string check_against_reference(const BooleanCase& input,
                                                  BooleanComparison& comparison);

}  // namespace test
