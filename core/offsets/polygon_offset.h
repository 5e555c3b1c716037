// The foot of the Voronoi mountain: offsets up to the deepest depth asked for, without the diagram.
//
// The offset at depth d is the cut of the mountain at z = d (voronoi_mountain.h). Its contours
// consist of what every site raises there: an edge its parallel line, a reflex corner its arc. Of
// each such element those points stay that are farther than d from all other sites: the capsules
// of nearby edges are cut away in closed form (offset_trim.h). What stays ends where the element
// meets the one of another site, that is where a Voronoi edge passes through z = d:
//
//          line of a           arc of v           a piece of a that ends at v's capsule goes on
//      ───────────────┐      ╭──────────          with the piece of v that begins at a's capsule:
//                (a,v)└──▶──╯                     linked by the pair of names, never by nearness
//
// Why not the other ways: a whole diagram costs ten times as much and is not always right; a sweep
// over the raw offset curve (Clipper's way) pays for crossings, of which fine contours at a large
// depth have thousands an edge, only to throw them away.
//
// General position. Everything that is degenerate at one depth only (three sites equally near to a
// point at height d, parallel walls 2d apart, contours that just meet) belongs to one of finitely
// many critical depths. So the cut is made at d + 0.00006 units instead, sixteen thousandth of what
// the result is rounded to, and if that is critical too, a little deeper still: between critical
// depths the contours are disjoint closed curves. What is degenerate at all depths is decided by
// exact integer predicates: collinear edges, convex or reflex, edges in line, corners on edges,
// corners at one point (offset_input.h).
//
// The check. Decisions that depend on rounding can only be inconsistent with one another when some
// depth within about 1e-9 units is critical. Then some piece's end finds no partner, or two find
// the same: linking is a permutation of the pieces or the depth counts as critical, and a retry is
// made. So what is returned are closed contours whose pieces all lie at their depth. When all
// retries fail the whole diagram is asked; both are counted.
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
  // sites within 2d of an edge that survives, O(n · k). Allocates only what is more than ever
  // before in scratch memory and in `out`, whose memory is reused.
  void offset(const Region& region, std::span<const Length> depths, std::span<OffsetContours> out);

  // For callers that need one depth once.
  [[nodiscard]] OffsetContours offset(const Region& region, Length depth);

  // Depths that were critical and were made a little deeper, since birth.
  [[nodiscard]] std::int64_t retries() const;
  // Offsets that had to be cut from a whole diagram, since birth.
  [[nodiscard]] std::int64_t fallbacks() const;

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace core
