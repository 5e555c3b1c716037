// What can be known of a mesh from seeing each facet once, in constant memory: its extent, whether
// it nearly is in order of height, whether its surface is closed and turned one way
// (edge_ledger.h), where no facet stands, which corners lie outermost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"                // Triangle
#include "core/units.h"                   // LayerIndex, Length
#include "host/formats/mesh_extent.h"     // MeshExtent
#include "host/part/edge_ledger.h"        // EdgeLedger
#include "host/part/height_fill.h"        // HeightFill
#include "host/part/outermost_corners.h"  // OutermostCorners
#include "host/part/reorder_window.h"     // OrderGauge

namespace host {

// Two corners at one point.
[[nodiscard]] bool is_degenerate(const core::Triangle& triangle);
// Three corners, and not flat: some plane crosses it.
[[nodiscard]] bool can_be_cut(const core::Triangle& triangle);

class MeshSurvey {
 public:
  // `window` is what the gauge of order assumes.
  explicit MeshSurvey(std::size_t window) : order_(window) {}

  // Returns can_be_cut().
  bool add(const core::Triangle& triangle);

  // Of all facets, flat ones included.
  [[nodiscard]] const MeshExtent& extent() const { return extent_; }
  // Highest corner of those that a plane can cross; nothing: there is none.
  [[nodiscard]] std::optional<std::int64_t> highest_cut() const { return highest_cut_; }
  // Two corners at one point.
  [[nodiscard]] std::int64_t degenerate() const { return degenerate_; }
  [[nodiscard]] bool in_order() const { return order_.in_order(); }
  [[nodiscard]] bool closed() const { return edges_.closed(); }
  // Edges between facets that are turned over against one another; nothing: none is known.
  [[nodiscard]] std::optional<EdgeLedger::Turned> turned() const { return edges_.turned(); }

  // Layers between others that no facet reaches: the part goes on above them in the air. Of many
  // narrow gaps the narrowest may be missed (kHeightGapsMax).
  struct EmptyLayers {
    core::LayerIndex count = 0;
    core::LayerIndex first = 0;  // counted from 0
  };
  [[nodiscard]] EmptyLayers empty_layers(core::Length layer_height);

  // The longest stretch of height above the lowest point that no facet reaches.
  struct Gap {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };
  [[nodiscard]] Gap widest_gap();

  // The facet that spans most of the height, by its highest corner.
  struct TallFacet {
    std::int64_t span = 0;
    FacetCorner corner;
  };
  [[nodiscard]] const TallFacet& tallest() const { return tallest_; }
  // Of facets that a plane can cross; downwards and sidewards of all.
  [[nodiscard]] const OutermostCorners& outermost() const { return outermost_; }
  [[nodiscard]] const HeightFill& fill() const { return fill_; }

 private:
  struct Span {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };

  void unite_spans();

  MeshExtent extent_;
  std::optional<std::int64_t> highest_cut_;
  OutermostCorners outermost_;
  HeightFill fill_;
  TallFacet tallest_;
  std::int64_t facets_ = 0;
  std::int64_t degenerate_ = 0;
  EdgeLedger edges_;
  OrderGauge order_;
  std::vector<Span> spans_;  // heights of facets: the first ones apart and in order
  std::size_t united_ = 0;   // so many of them
};

// What is told of edges between facets that are turned over, in the file's own coordinates.
[[nodiscard]] std::string turned_text(const EdgeLedger::Turned& turned);

// "is it in inches …?", where the size makes one think so.
[[nodiscard]] std::optional<std::string> unit_question(const MeshExtent& extent);

// A warning where the size makes one think that the file is in another unit: "… in inches?".
[[nodiscard]] std::optional<std::string> unit_warning(const MeshExtent& extent);

}  // namespace host
