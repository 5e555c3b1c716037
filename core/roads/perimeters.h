// Perimeters (also called walls or shells): roads along the contour, as many and as wide as fill
// the part.
//
// Where an island is wide all over, a perimeter is the slice's offset at its depth. Where it has
// narrow places, roads change their width and number along the medial axis (beading.h,
// bead_counts.h), so that such a place is filled exactly, by roads along the contours
// (bead_lines.h) and along the axis (centre_beads.h):
//
//     ────────────────────╮
//     ═══════════════╗    ╰────────────   four roads, then three, then one
//     ──────────────╮╚══════════
//       interior ╮  ╰══════════════════
//     ───────────┴──╯╔══════════
//     ═══════════════╝    ╭────────────
//     ────────────────────╯
//
// Pins, islands that are round and small, have rings of one width (pin_rings.h).
//
// What the perimeters leave is the interior, for solid and sparse infill.
#pragma once

#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/beading.h"   // Beading
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// One island with what was cut from it (SliceOffsets).
struct IslandOffsets {
  Region region;
  std::vector<Region> perimeters;  // from the outside in
  Region wide_core;
  Region interior;
};

struct Perimeters {
  std::vector<Road> roads;
  Region interior;
};

// COSTS: O(points) where the island is wide all over; otherwise a medial axis up to the clearance
// of a wide place (narrow_diagram.h), and O(n log n).
[[nodiscard]] Perimeters perimeters(IslandOffsets island, Length height, const Settings& settings);

}  // namespace core
