// Facts about a mesh from one pass over its facets, in constant memory: its extent, whether the
// facets are nearly in order of height, whether the surface is closed and oriented alike
// (edge_ledger.h), heights without facets, the outermost corners, how high layers may be
// (core/slices/height_limits.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"                // Triangle
#include "core/slices/height_limits.h"    // HeightLimits
#include "core/slices/layer_heights.h"    // LayerHeights
#include "core/units.h"                   // LayerIndex, Length
#include "host/formats/mesh_extent.h"     // MeshExtent
#include "host/part/edge_ledger.h"        // EdgeLedger
#include "host/part/height_fill.h"        // HeightFill
#include "host/part/opened_part.h"        // FacetObserver
#include "host/part/outermost_corners.h"  // OutermostCorners
#include "host/part/reorder_window.h"     // OrderGauge

namespace host {

// Two corners are the same point.
[[nodiscard]] bool is_degenerate(const core::Triangle& triangle);
// True for a facet that some horizontal plane crosses: not degenerate, not horizontal.
[[nodiscard]] bool can_be_cut(const core::Triangle& triangle);

// True for a facet that leans outwards: its outer side looks down, by more than files are rounded.
[[nodiscard]] bool faces_down(const core::Triangle& triangle);

class MeshSurvey {
 public:
  // `window`: for the OrderGauge. `limits`: of layers' heights, if they are wanted. `on_facet`:
  // sees each facet, too, if it isn't empty.
  explicit MeshSurvey(std::size_t window, std::optional<core::HeightLimits> limits = std::nullopt,
                      FacetObserver on_facet = {})
      : order_(window), limits_(std::move(limits)), on_facet_(std::move(on_facet)) {}

  // Returns can_be_cut().
  bool add(const core::Triangle& triangle);

  // Of all facets, flat ones included.
  [[nodiscard]] const MeshExtent& extent() const { return extent_; }
  // Highest corner of the facets that a plane can cross; nullopt if there are none.
  [[nodiscard]] std::optional<std::int64_t> highest_cut() const { return highest_cut_; }
  // Highest corner of the facets that face down; nullopt if there are none.
  [[nodiscard]] std::optional<std::int64_t> highest_facing_down() const { return facing_down_; }
  // Whether nothing of the part hangs: no facet faces down over this height, and all are oriented.
  [[nodiscard]] bool nothing_hangs_over(core::Length height) const;
  // Facets that are degenerate.
  [[nodiscard]] std::int64_t degenerate() const { return degenerate_; }
  [[nodiscard]] bool in_order() const { return order_.in_order(); }
  [[nodiscard]] bool closed() const { return edges_.closed(); }
  // Edges between facets that are oriented differently; nullopt if none is known.
  [[nodiscard]] std::optional<EdgeLedger::Turned> turned() const { return edges_.turned(); }

  // Layers that no facet reaches although the part continues above them. If there are many narrow
  // gaps, the narrowest may be missed (kHeightGapsMax).
  struct EmptyLayers {
    core::LayerIndex count = 0;
    core::LayerIndex first = 0;  // counted from 0
  };
  [[nodiscard]] EmptyLayers empty_layers(const core::LayerHeights& heights);

  // The longest stretch of height above the lowest point that no facet reaches.
  struct Gap {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };
  [[nodiscard]] Gap widest_gap();

  // The facet that spans the most height, with its highest corner.
  struct TallFacet {
    std::int64_t span = 0;
    FacetCorner corner;
  };
  [[nodiscard]] const TallFacet& tallest() const { return tallest_; }
  // Upwards, of the facets that a plane can cross; in the other directions, of all facets.
  [[nodiscard]] const OutermostCorners& outermost() const { return outermost_; }
  [[nodiscard]] const HeightFill& fill() const { return fill_; }
  // What the facets' slopes allow; nullopt if it was not wanted.
  [[nodiscard]] const std::optional<core::HeightLimits>& limits() const { return limits_; }

 private:
  struct Span {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };

  void unite_spans();

  MeshExtent extent_;
  std::optional<std::int64_t> highest_cut_, facing_down_;
  OutermostCorners outermost_;
  HeightFill fill_;
  TallFacet tallest_;
  std::int64_t facets_ = 0;
  std::int64_t degenerate_ = 0;
  EdgeLedger edges_;
  OrderGauge order_;
  std::optional<core::HeightLimits> limits_;
  FacetObserver on_facet_;
  std::vector<Span> spans_;  // heights of facets; the first united_ are disjoint and in order
  std::size_t united_ = 0;
};

// The warning about facets that are oriented differently, in the file's own coordinates.
[[nodiscard]] std::string turned_text(const EdgeLedger::Turned& turned);

// "is it in inches …?" if the size suggests that; nullopt otherwise.
[[nodiscard]] std::optional<std::string> unit_question(const MeshExtent& extent);

// A warning if the size suggests that the file is in another unit: "… in inches?".
[[nodiscard]] std::optional<std::string> unit_warning(const MeshExtent& extent);

}  // namespace host
