// The medial axis of narrow regions: for each gap that whole roads don't fit into, one centre line
// of varying width.
//
//      ____________________
//     |                    |      width = 2 · clearance, the distance to the nearest boundary;
//     |  o-----o-----o-----o      lines run along the ridge of the Voronoi mountain
//     |____________________|
//
// A road has round ends, half its width long. So a line ends where its round end touches the
// region's end, and all its discs together are what the region holds of that width. Spurs into
// corners wider than 60° are dropped, because the round end loses no more there than at any corner
// of a wall. Sharper corners are wedges, and are followed until they are narrower than width_min.
// Three or more lines that meet all end in the point where they meet.
//
// SOURCE: the Voronoi diagram of the contours (DETC2000/DAC-14285), its ridge filtered for the
// purpose of Slic3r's MedialAxis (Ranellucci, 2014). Spurs are told by how far they reach beyond
// the disc that they leave from.
//
// Keywords: gap fill, thin walls, skeleton.
#pragma once

#include <vector>

#include "core/geometry.h"        // Point
#include "core/regions/region.h"  // Region
#include "core/units.h"           // Length

namespace core {

// A road's centre line with the width that fills the region there.
struct ThickPolyline {
  std::vector<Point> points;
  std::vector<Length> widths;  // one for each point; between two points it changes linearly
  bool closed = false;         // the last point joins the first and is not repeated
};

// The lines of `region` where its width lies within [width_min, width_max].
// REQUIRES: 0 < width_min <= width_max.
// ENSURES: points.size() == widths.size() >= 2 (3 when closed), neighbours differ; every point
// lies within the region and its width is twice its distance to the boundary, both to a unit, or to
// 10 units where two vertices of the diagram nearly meet (narrow_diagram.h).
// If every Voronoi diagram of the region fails its checks, however turned, there are no lines and
// the gap stays open. That has never been seen.
// COSTS: as make_narrow_diagram(); where that has no answer, as VoronoiMountain.
[[nodiscard]] std::vector<ThickPolyline> medial_axis(const Region& region, Length width_min,
                                                     Length width_max);

}  // namespace core
