// Polygon offset (inset, outset; a Minkowski sum with a disc, or its erosion) at many depths at
// once, without a Voronoi diagram.
//
// The offset at depth d is the cut of the Voronoi mountain at z = d (voronoi_mountain.h). Its
// contours consist of what every site raises there: an edge its parallel line, a reflex corner its
// arc. Of each such element only the points stay that are farther than d from all other sites; the
// capsules of nearby edges are cut away in closed form (offset_trim.h). What stays ends where the
// element meets the one of another site, which is where a Voronoi edge passes through z = d:
//
//          line of a           arc of v          a piece of a that ends at v's capsule is followed
//      ───────────────┐      ╭──────────         by the piece of v that starts at a's capsule: they
//                (a,v)└──▶──╯                    are linked by this pair of names, not by nearness
//
// Other methods. A whole diagram costs ten times as much and is not always right. A sweep over the
// raw offset curve (Clipper's method) computes all its crossings and then discards most: fine
// contours at a large depth have thousands an edge.
//
// General position. What is degenerate at one depth only (three sites equally near to a point at
// height d, parallel walls 2d apart, contours that just meet) belongs to one of finitely many
// critical depths. So the cut is made 0.00006 units deeper, 1/16000 of what the result is rounded
// to; if that is critical, too, a little deeper still. Between critical depths the contours are
// disjoint closed curves. What is degenerate at all depths is decided by exact integer predicates:
// collinear edges, convex or reflex, edges in line, corners on edges, corners at one point
// (offset_input.h).
//
// The check. Decisions that depend on rounding can contradict one another only when some depth
// within about 1e-9 units is critical. Then the end of some piece finds no partner, or two ends
// find the same one. So pieces must be linked by a permutation; otherwise the depth counts as
// critical and the next one is tried. What is returned are closed contours whose pieces all lie at
// their depth. When all tries fail, the whole diagram is asked. Retries and fallbacks are counted.
//
// Rounding. Each end is computed once and rounded once. Contours nearer than two units to one
// another can touch or cross afterwards; flatten() checks that exactly and cleans them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/offsets/offset_contours.h"  // OffsetContours
#include "core/regions/region.h"           // Region
#include "core/units.h"                    // Length

namespace core {

// Keeps its scratch memory: one for all the slices of a part. Not for two threads at a time.
class PolygonOffsetter {
 public:
  PolygonOffsetter();
  ~PolygonOffsetter();
  PolygonOffsetter(PolygonOffsetter&&) noexcept;
  PolygonOffsetter& operator=(PolygonOffsetter&&) noexcept;

  // out[i] becomes the offset at depths[i]: inwards for positive depths, outwards for negative
  // ones, the region's contours for 0. Depths on one side share the search for neighbours.
  //
  // REQUIRES: as many out as depths; the result within ±kCoordinateMax.
  // COSTS: O(n) for edges of about the depth's length or runs of fine ones (offset_runs.h); with k
  // sites within 2d of an edge that survives, O(n · k). The memory of `out` and the scratch memory
  // are reused: it allocates only when it needs more than ever before.
  void offset(const Region& region, std::span<const Length> depths, std::span<OffsetContours> out);

  // For callers that need one depth once.
  [[nodiscard]] OffsetContours offset(const Region& region, Length depth);

  // How many depths were critical so far, and were made a little deeper.
  [[nodiscard]] std::int64_t retries() const;
  // How many offsets so far had to be cut from a whole diagram.
  [[nodiscard]] std::int64_t fallbacks() const;

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace core
