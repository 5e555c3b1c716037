// The medial axis of narrow regions: one road of varying width for each gap that whole roads don't
// fit into.
//
//      ____________________
//     |                    |      width = 2 · clearance, the distance to the nearest boundary;
//     |··o-----o-----o-----o      lines run along the ridge of the Voronoi mountain, spurs into
//     |____________________|      corners are dropped, open ends reach the region's own end
//
// Source: the Voronoi diagram of the contours (DETC2000/DAC-14285), its ridge filtered in the
// manner of Slic3r's MedialAxis (Ranellucci, 2014).
#pragma once

#include <vector>

#include "core/geometry.h"  // Point
#include "core/region.h"    // Region
#include "core/units.h"     // Length

namespace core {

// A road's centre line with the width that fills the region there.
struct ThickPolyline {
  std::vector<Point> points;
  std::vector<Length> widths;  // one for each point; between two points it changes linearly
  bool closed = false;         // the last point joins the first and is not repeated
};

// The lines of `region` where its width lies within [width_min, width_max].
// REQUIRES: 0 < width_min <= width_max.
// ENSURES: points.size() == widths.size() >= 2; every point lies within the region. A point's
// width is twice its distance to the boundary, except at an open end that was drawn on to the
// region's end, where it is the width of the point before.
// COSTS: as VoronoiMountain.
[[nodiscard]] std::vector<ThickPolyline> medial_axis(const Region& region, Length width_min,
                                                     Length width_max);

}  // namespace core
