// Perimeters where areas of the slice have other numbers of them (Slice::areas):
//
//     ══════════════════════════════   Those that both sides have go on over the border. The others
//     ══════════════════════════════   end at it, and the interior is wider beside them: nothing is
//          interior    │════════════   laid twice, and nothing is left open.
//     ─────────────────┘════════════
//                       interior
//
// An island is planned for each number that it has somewhere, and of each plan is kept what lies
// where its number holds. Where narrow places are filled otherwise by another number, just at a
// border, roads may meet with a step there.
#pragma once

#include "core/roads/perimeters.h"      // IslandOffsets, Perimeters
#include "core/settings.h"              // Settings
#include "core/slices/changed_areas.h"  // ChangedAreas
#include "core/slices/slice.h"          // Slice
#include "core/units.h"                 // Length

namespace core {

// Ends that meet at a border are no farther apart than this share of a road's width: other roads
// are twice as far away.
inline constexpr double kBorderJoinMax = 0.5;

// Where the number is another one than the settings'; areas don't overlap.
[[nodiscard]] ChangedAreas perimeter_areas(const Slice& slice, const Settings& settings);

struct AreaPerimeters {
  Perimeters around;
  Region innermost;  // as far as the innermost perimeter's centre line
};

// REQUIRES: settings.perimeters >= 1; areas as perimeter_areas() has them, some.
// COSTS: for each further number in the island its offsets and its perimeters, and some booleans.
[[nodiscard]] AreaPerimeters area_perimeters(IslandOffsets island, const ChangedAreas& areas,
                                             Length height, const Settings& settings);

}  // namespace core
