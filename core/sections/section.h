// A vertical cut: what a plane across the part meets of each layer, as intervals along one line.
//
//     region ╭──────╮      line y = at ──▶   ┄┄┄┄┄┄├──────┤┄┄┄┄┄├──┤┄┄┄┄▶ x
//     roads  ━━━━━━━━                              intervals
//
// The line runs half a unit above `at`, so that it passes between the grid's points: no corner lies
// on it, and every contour is crossed an even number of times.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/units.h"           // Length

namespace core {

// The plane x = at, or y = at.
struct SectionLine {
  enum class Across { kX, kY };
  Across across = Across::kY;
  Length at;
};

// Along the line, in units: y where the plane is x = at, x where it is y = at.
struct Interval {
  std::int64_t from = 0;
  std::int64_t to = 0;
  auto operator<=>(const Interval&) const = default;
};

// Ascending; none empty, none touch.
using Intervals = std::vector<Interval>;

// Ends are rounded to the nearest unit. COSTS: O(points), and sorting what is met.
[[nodiscard]] Intervals section_of(const Region& region, const SectionLine& line);

// Of a road as it is seen from above, with round ends. COSTS: as above.
[[nodiscard]] Intervals section_of(const Road& road, const SectionLine& line);

// Any intervals, made ascending, the touching ones joined, the empty ones left out.
[[nodiscard]] Intervals joined(Intervals intervals);

// COSTS: linear.
[[nodiscard]] Intervals intersect(const Intervals& a, const Intervals& b);
[[nodiscard]] Intervals subtract(const Intervals& a, const Intervals& b);

[[nodiscard]] Length total_length(const Intervals& intervals);

}  // namespace core
