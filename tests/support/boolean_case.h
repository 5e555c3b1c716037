// One case for the booleans out of any bytes: made of rings on a coarse grid, so that corners,
// edges and whole rings coincide all the time. Random tests and the fuzzer share it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/booleans/boolean.h"  // FillRule
#include "core/geometry.h"          // Ring

namespace test {

struct BooleanCase {
  // Three operands as they come: rings that cross, fold back, repeat.
  std::vector<core::Ring> rings[3];
  core::FillRule rule = core::FillRule::kNonZero;
  // Units from one grid line to the next: 1 (all is rounding) to 2^25.
  std::int32_t scale = 1;
  // The second operand gets all rings of the first one as well.
  bool shares_rings = false;
};

[[nodiscard]] BooleanCase boolean_case(std::span<const std::uint8_t> bytes);

// Every operation on it: results are clean, contain what they should (points that keep clear of all
// edges are asked, by winding numbers of the operands), and don't depend on the operands' order.
// Returns what was wrong, or nothing.
[[nodiscard]] std::string check_operations(const BooleanCase& input);

// What comparisons with Boost.Polygon found.
struct BooleanComparison {
  std::int64_t compared = 0;  // results
  std::int64_t wider = 0;     // that differ by more than 2 units: Boost.Polygon is off there
  double widest = 0;          // difference, units
};

// The same against Boost.Polygon: where the difference has a piece wider than 2 units, points of it
// that keep clear of the operands' edges say who is right. Only for coordinates at which
// Boost.Polygon is right as a rule. Returns what was wrong with ours, or nothing.
[[nodiscard]] std::string check_against_reference(const BooleanCase& input,
                                                  BooleanComparison& comparison);

}  // namespace test
