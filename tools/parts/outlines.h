// Plates: flat bodies of one or several outlines, with holes, cut into facets without gaps.
#pragma once

#include <vector>

#include "tools/parts/part_maker.h"
#include "tools/parts/shapes.h"

namespace parts {

// Outlines that don't meet: outer ones counter-clockwise, holes clockwise, seen from above. z is
// that of the plate's bottom.
using Outlines = std::vector<CornerRing>;

[[nodiscard]] CornerRing rectangle(Corner at, double width, double depth);
[[nodiscard]] CornerRing reversed(CornerRing ring);

// The walls of a plate of some height on the outlines.
void plate_sides(const FacetSink& sink, const Outlines& outlines, double height);

// A flat face that fills the outlines, with their corners alone.
// COSTS: O(corners²), a few ms for some thousand.
void plate_face(const FacetSink& sink, const Outlines& outlines, Looking looking);

// Closed: sides and both faces.
void plate(const FacetSink& sink, const Outlines& outlines, double height);

}  // namespace parts
