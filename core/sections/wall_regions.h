// Why a spot of the wall is wall: the paper's three regions (DETC2000/DAC-14285, figures 3 to 10),
// each without the ones before it, as its figures shade them.
//
//     region 1  own         within the wall's depth of the slice's own contours
//     region 2  uncovered   not covered by every slice within reach above and below: horizontal
//                           and near-horizontal faces
//     region 3  neighbours  covered, but within the wall's depth of the contours of one of them
//
//     own = S_n − I(S_n)    uncovered = I(S_n) − ⋂ S_i    neighbours = I(S_n) ∩ ⋂ S_i − ⋂ I(S_i)
//
// Where the wall is a ball, I(S_i) is at the depth that its distance gives, and "within reach"
// means nearer than the wall's thickness. The three together are S_n − ⋂ I(S_i), the wall that the
// splitter makes. What is solid beyond that is `further`: too narrow for loose roads
// (regularise.h), or all that is solid where the build style decides instead (wall_style.h).
#pragma once

#include "core/regions/region.h"         // Region
#include "core/sections/layer_window.h"  // LayerWindow
#include "core/sections/section.h"       // Intervals, SectionLine

namespace core {

struct WallRegions {
  Region own;
  Region uncovered;
  Region neighbours;
  Region further;
};

// Of window.layer().
// COSTS: two intersections and at most one offset for each neighbour, four further operations.
[[nodiscard]] WallRegions wall_regions(const LayerWindow& window);

// The same along a line, with the slice and the loose region.
struct WallSection {
  Intervals slice;
  Intervals own;
  Intervals uncovered;
  Intervals neighbours;
  Intervals further;
  Intervals loose;
};

// COSTS: O(points of the window's slices and offsets); no region operation, and no offset unless
// neighbours differ in height.
[[nodiscard]] WallSection wall_section(const LayerWindow& window, const SectionLine& line);

// Pieces of `further` narrower than this are rounding, and left out.
inline constexpr Length kFurtherWidthMin = Length::from_units(20);

}  // namespace core
