// Trims every offset element of a region's contours, at one depth d or several. Of an edge's line
// and of a reflex corner's arc, only the points stay that no capsule covers (offset_cut.h).
//
// What is covered at one depth is covered at all greater ones: the straight way from a point of an
// element back to its own site is nearest to that site all along. So an element goes through the
// depths in ascending order; when nothing is left, nothing is at the greater ones. At the first,
// the edges are gathered that reach what is left of it at any depth: any at which its neighbours
// and the edge that covered the last element leave something. (Gathered anew for depths some times
// as deep, whatever that factor, they took longer: measured.)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/offsets/offset_cut.h"     // LineCut, ArcCut
#include "core/offsets/offset_input.h"   // OffsetInput
#include "core/offsets/offset_search.h"  // OffsetSearch
#include "core/offsets/offset_span.h"    // OffsetSpan, TrimmedPiece

namespace core {

class OffsetTrim {
 public:
  // Returns false when contours touch at a corner that raises an arc and were not mended yet.
  // REQUIRES: depths in ascending order, at least one, none greater than the search's.
  // COSTS: O(n · sites within 2d of what survives).
  [[nodiscard]] bool trim(const OffsetInput& contours, const OffsetSearch& search,
                          std::span<const double> depths);

  // What survived at depths[at], by element; an element's pieces follow one another in its
  // direction.
  [[nodiscard]] std::span<TrimmedPiece> pieces(std::size_t at) { return pieces_[at].all(); }
  // Element e's pieces are pieces(at)[first(at, e) … first(at, e + 1)).
  [[nodiscard]] std::int32_t first(std::size_t at, OffsetSite element) const {
    return first_[static_cast<std::size_t>(element) * depths_.size() + at];
  }

 private:
  enum class Left { kSome, kNothing, kUnknown };  // unknown: contours touch here

  template <bool kWide>
  bool trim_all();
  void add_whole_line(std::int32_t index);
  template <bool kWide>
  void trim_line(std::int32_t index, std::span<const std::int32_t> near);
  template <bool kWide>
  void add_line_cut(const OffsetEdge& e, std::int32_t other);
  template <bool kWide>
  Left gather_line_cuts(std::int32_t index, std::span<const std::int32_t> near);
  template <bool kWide>
  Left gather_line_cuts(std::int32_t index, const OffsetChunk& chunk);
  void add_whole_arc(std::int32_t index);
  template <bool kWide>
  bool trim_arc(std::int32_t index, std::span<const std::int32_t> near);
  void start_arc(std::int32_t index, double depth);
  template <bool kWide>
  Left add_arc_cut(std::int32_t index, std::int32_t other);
  template <bool kWide>
  Left gather_arc_cuts(std::int32_t index, std::span<const std::int32_t> near);
  template <bool kWide>
  Left gather_arc_cuts(std::int32_t index, const OffsetChunk& chunk);
  Left cut_line(const LineCut& cut, double depth);
  Left cut_arc(const ArcCut& cut, double depth);
  Left cut_arc_at(std::int32_t index, double depth);

  [[nodiscard]] const OffsetEdge& edge(std::int32_t i) const {
    return (*edges_)[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] const OffsetCorner& corner(std::int32_t i) const {
    return (*corners_)[static_cast<std::size_t>(i)];
  }
  // The site of the corner i, whichever contour it was written in.
  [[nodiscard]] OffsetSite corner_site(std::int32_t i) const { return 2 * corner(i).owner + 1; }
  [[nodiscard]] EdgeSites sites(std::int32_t i) const {
    return {2 * i, corner_site(i), corner_site(edge(i).end_corner)};
  }
  // Before and after a line, where nothing cuts it.
  [[nodiscard]] OffsetSite site_before(std::int32_t index) const {
    return corner(index).reflex ? 2 * index + 1 : 2 * edge(index).previous;
  }
  [[nodiscard]] OffsetSite site_after(std::int32_t index) const {
    const std::int32_t next = edge(index).next;
    return corner(next).reflex ? 2 * next + 1 : 2 * next;
  }

  const OffsetInput* contours_ = nullptr;
  const std::vector<OffsetEdge>* edges_ = nullptr;
  const std::vector<OffsetCorner>* corners_ = nullptr;
  const OffsetSearch* search_ = nullptr;
  std::vector<double> depths_;
  double reach_ = 0;  // down to which the element at hand may survive
  // The edge that covered an element last: likely the next element, too.
  std::int32_t last_coverer_ = -1;
  OffsetSpan span_;
  OffsetCuts<LineCut> line_cuts_;  // of the element that is being trimmed
  OffsetCuts<ArcCut> arc_cuts_;
  OffsetArc arc_{};                    // known once there is a cut
  std::vector<TrimmedPieces> pieces_;  // by depth
  std::vector<std::int32_t> first_;    // by element, then by depth
};

}  // namespace core
