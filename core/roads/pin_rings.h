// Roads of a pin: an island so small and round that the axis of its beading is little more than a
// point. Rings of one width around its middle fill it exactly:
//
//     ╭───────╮     R: the largest disc's radius, δ: what a bead's round sides need (beading.h)
//     │╭─────╮│     n rings, each with the share p = (R − δ/2) / n of the room,
//     ││  ·  ││     p + δ wide, the outermost half its width inside the contour
//     │╰─────╯│
//     ╰───────╯
//
// A pin's contour touches its largest disc nearly all around, as that of a regular polygon does:
// then R is 2 · area / perimeter.
#pragma once

#include <optional>
#include <vector>

#include "core/regions/region.h"  // Region
#include "core/roads/road.h"      // Road
#include "core/settings.h"        // Settings
#include "core/units.h"           // Length

namespace core {

// The rings, from the outside in; nothing where the island is no pin, where more rings fit than
// there are perimeters, or where not even the narrowest road does.
// COSTS: its box; for small islands an offset or three.
[[nodiscard]] std::optional<std::vector<Road>> pin_rings(const Region& island, Length height,
                                                         const Settings& settings);

}  // namespace core
