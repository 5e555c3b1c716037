// The beads along the contours of a region, and the edge of its interior.
//
// The cell of a contour's site is walked below the medial axis, from one axis point to the next.
// Bead i lies at its depth on the way from the contour to the axis (beading.h):
//
//     axis    ●────●────────●─────●      Where a bead no longer fits, because the axis comes nearer
//             ┆ ┌──┼────────┼───┐ ┆      than its depth, or because fewer beads lie side by side
//     bead 1  ──┘  ┆        ┆   └──      there, its line goes over to the other side of the axis.
//             ┆    ┆        ┆     ┆      So all lines are closed.
//     contour ●────●────────●─────●
//
// Where the axis is farther away than is known, beads lie at the depths of wide places.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/roads/axis_graph.h"  // AxisGraph
#include "core/roads/beading.h"     // Beading
#include "core/vector.h"            // Vector

namespace core {

struct BeadPoint {
  Vector at;
  double room = 0;  // the bead's share of the room
};

// Open only where rounding has left an end without another one.
struct BeadLine {
  std::vector<BeadPoint> points;
  bool closed = false;
};

// One side of an axis edge, along the contour; or, where the axis is not known, what lies between
// two of them.
struct BeadSpan {
  static constexpr std::uint32_t kOpen = UINT32_MAX;

  std::uint32_t edge = kOpen;
  std::uint32_t site = 0;  // contour sites from this one
  std::uint32_t last = 0;  // to this one
  std::uint32_t from = 0;  // nodes at the ends; kOpen: the span is a whole ring
  std::uint32_t to = 0;
  bool forward = true;  // as the edge goes
  bool round = false;   // all round, back to the site where it starts
};

// Where the nodes at a span's ends touch its contour, and the directions from there to them.
// Nothing where the span is a whole ring.
struct BeadSpanEnds {
  Vector from_foot, from;
  Vector to_foot, to;
};

class BeadSpans {
 public:
  explicit BeadSpans(const AxisGraph& graph);

  // False where the axis does not go round the contours as it should; then there are no spans.
  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] const std::vector<BeadSpan>& spans() const { return spans_; }
  [[nodiscard]] const std::vector<BeadSpanEnds>& ends() const { return ends_; }  // by span
  // Spans of ring i: from starts()[i] to starts()[i + 1]; so are its sites.
  [[nodiscard]] const std::vector<std::size_t>& starts() const { return starts_; }

 private:
  void add(const AxisGraph& graph, const BeadSpan& span, std::size_t ring);
  void close(const AxisGraph& graph, std::size_t ring);
  void join(const AxisGraph& graph, BeadSpan before, BeadSpan span);

  bool sound_ = true;
  std::vector<BeadSpan> spans_;
  std::vector<BeadSpanEnds> ends_;
  std::vector<std::size_t> starts_;
};

// The lines of one level (Beading::levels), in the order of the contours. Chords stay within
// `tolerance` of arcs; in units.
// COSTS: O(spans), the points of arcs, and a sort of the places where lines go over.
[[nodiscard]] std::vector<BeadLine> bead_lines(const Beading& beading, const AxisGraph& graph,
                                               const BeadSpans& spans, int level, double tolerance);

}  // namespace core
