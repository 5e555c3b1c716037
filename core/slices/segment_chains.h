// From loose segments to closed rings: where a plane cuts a mesh, every facet leaves one segment.
//
// Segments chain by equal points, which the two facets on an edge agree upon bit for bit. In a
// sound mesh one segment comes into every point for each that leaves it, and nothing is to be
// decided. Meshes that are not sound are taken as a person would take them:
//
//   a segment there twice       once (a doubled facet)
//   a segment and its reverse   neither (two bodies share a wall), or one where that leaves the
//                               points around them in pairs (a doubled facet, turned over). A whole
//                               ring of such segments that meets nothing else is kept: only the
//                               caller knows whether it lies within a body (a body that is there
//                               twice, once inside out)
//   a flipped facet             goes with the rest of its chain: chains turn as most of their
//                               length does
//   an open chain               closed_across_gaps() below
//
// The result does not depend on the order of the segments, but for OnOneLine of those that are
// there twice. The segments of a sound mesh are chained faster by sound_rings.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry.h"        // Point, Ring, Segment
#include "core/slices/on_line.h"  // OnOneLine, SegmentIndex
#include "core/slices/slice.h"    // SliceDefects
#include "core/units.h"           // Length

namespace core {

// Points joined by segments in one go, and how the segments are turned.
struct Chain {
  struct Tally {
    std::int64_t facets = 0;
    double length_units = 0;
  };
  std::vector<Point> points;
  std::vector<SegmentIndex> segments;  // from each point to the next
  Tally along;                         // turned as the points run
  Tally against;  // turned the other way: flipped facets, if they are the lesser part

  [[nodiscard]] double length_units() const { return along.length_units + against.length_units; }
  void reverse();
};

struct Chains {
  std::vector<Chain> closed;  // the last point joins the first
  std::vector<Chain> open;
  std::vector<Chain> cancelled;  // closed, counter-clockwise: each segment's reverse was there too
  std::int64_t doubled_facets = 0;
};

// COSTS: O(n log n).
[[nodiscard]] Chains chain_segments(const std::vector<Segment>& segments);

// Joins ends of open chains, nearest first:
//   - up to `gap_max` any two ends;
//   - beyond it, only where one chain ends and another (or itself) starts, so that the part stays
//     on its side, among the kWideGapChainsMax longest chains;
//   - no chain onto itself, and beyond gap_max nothing at all, where the gaps would be longer than
//     kGapShareMax of what is there: that would make a body out of a sheet. One facet missing from
//     a box leaves a chain around the rest of it, and is closed.
// Chains that do not come to be closed are dropped. Adds to `defects`.
//
// COSTS: O(n log n) each for the doublings of distance from one unit to gap_max.
[[nodiscard]] std::vector<Chain> closed_across_gaps(std::vector<Chain> open, Length gap_max,
                                                    SliceDefects& defects);

inline constexpr double kGapShareMax = 0.9;
inline constexpr std::size_t kWideGapChainsMax = 64;

struct SliceRings {
  std::vector<Ring> rings;
  std::vector<Ring> cancelled;
  bool operator==(const SliceRings&) const = default;
};

// All of the above: every ring turned as most of its length is, without the points between two
// segments on one line.
[[nodiscard]] SliceRings rings_of(const std::vector<Segment>& segments, Length gap_max,
                                  const OnOneLine& on_one_line, SliceDefects& defects);

}  // namespace core
