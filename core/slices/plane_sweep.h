// Cuts a mesh into slices, plane by plane from the bed up, with only the triangles that cross the
// plane in memory.
//
//     each layer is cut halfway up (layer_heights.h)
//
//        a corner on the plane counts as above it, so every triangle that is cut has exactly two
//     ──/──\──  edges that cross, and leaves one segment, with the part on its left;
//      /____\   where an edge crosses is computed from its lower to its upper end, so that both
//               triangles on it get the same point, bit for bit:
//                   x = x0 + (x1 − x0) (z − z0) / (z1 − z0), rounded once, in integers
//
// The segments are chained (segment_chains.h; points between two facets of one upright wall are
// left out, exactly, so that walls that go straight up give equal slices), simplified, and cleaned
// by winding number other than 0: what several bodies share is inside, and a mesh that is inside
// out, or a body of it (inside_out.h), is a part all the same.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/geometry.h"               // Triangle, Segment
#include "core/result.h"                 // Result
#include "core/slices/layer_heights.h"   // LayerHeights
#include "core/slices/segment_chains.h"  // SliceRings
#include "core/slices/slice.h"           // Slice, SliceDefects
#include "core/units.h"                  // LayerIndex, Length

namespace core {

class PlaneSweep {
 public:
  struct Options {
    LayerHeights heights;
    // How many slices there are to be; nothing: until no triangle reaches the plane.
    std::optional<LayerIndex> layers;
    Length simplify_tolerance;  // REQUIRES: >= 0
    Length chain_gap_max;       // REQUIRES: >= 0
    // Where facets are known to be turned over (inside_out.h); nothing: nowhere.
    std::optional<Box> unsure{};
  };

  // Gives the next triangle in order of lowest z, or nothing at the end. REQUIRES: x and y within
  // ±kCoordinateMax.
  using TriangleSource = std::function<Result<std::optional<Triangle>>()>;

  PlaneSweep(const Options& options, TriangleSource source);

  // The next slice up, empty where the plane cuts nothing; nothing after the last one. An error is
  // the source's, and final.
  // COSTS: memory for the triangles that cross the plane.
  [[nodiscard]] Result<std::optional<Slice>> next();

  // The same way up, but only what is wrong with each slice: chains are made, and no region.
  [[nodiscard]] Result<std::optional<SliceDefects>> next_defects();

  // The most triangles that were in memory at once, crossing one plane.
  [[nodiscard]] std::int64_t peak_triangles_held() const { return peak_triangles_held_; }

 private:
  // To the next plane; false after the last one.
  [[nodiscard]] Result<bool> advance();
  [[nodiscard]] Status take_triangles_below(std::int64_t doubled_z);
  [[nodiscard]] SliceRings rings(SliceDefects& defects);
  // What the rings enclose. Turns those that are inside out, and says so.
  [[nodiscard]] Region region_of(SliceRings contours, SliceDefects& defects) const;
  // Makes segments_.
  void cut();

  Options options_;
  TriangleSource source_;
  LayerIndex next_index_ = 0;
  std::int64_t doubled_z_ = 0;  // of the plane that was reached last
  std::vector<Triangle> held_;
  std::vector<Segment> segments_;    // of the triangles held, in the same order
  std::optional<Triangle> waiting_;  // above the plane that was cut last
  bool source_ended_ = false;
  std::int64_t peak_triangles_held_ = 0;

  std::optional<bool> inside_out_;  // the first slice was

  // The last slice's, before and after it was cleaned: an equal one costs a comparison.
  SliceRings last_rings_;
  Region last_region_;
  SliceDefects last_turned_;  // of them, those that were found from the rings
};

}  // namespace core
