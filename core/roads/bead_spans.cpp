#include <algorithm>
#include <tuple>

#include "core/roads/bead_lines.h"

namespace core {
namespace {

// Two nodes lower than this are at the same corner of the contour. Units.
constexpr double kCornerRadius = 8;

// Sides nearer than this along their site may be in any order. Units.
constexpr double kNearTie = 1;

// More of them are left as they are.
constexpr std::size_t kNearTiesMax = 64;

// A side of an edge, and how far along its site the edge is touched from there.
struct Side {
  double along = 0;
  std::uint32_t site = 0;
  std::uint32_t edge = 0;
  bool forward = true;
};

// Where a line along the contour enters and leaves the edge on this side.
std::uint32_t start_of(const AxisGraph& graph, const Side& side) {
  const AxisEdge& edge = graph.edges()[side.edge];
  return side.forward ? edge.from : edge.to;
}

std::uint32_t end_of(const AxisGraph& graph, const Side& side) {
  const AxisEdge& edge = graph.edges()[side.edge];
  return side.forward ? edge.to : edge.from;
}

// Pieces of an axis that leaves the contour at a right angle are all touched from one place. Each
// comes after the one whose end it starts at.
void link_near_ties(const AxisGraph& graph, std::vector<Side>& sides) {
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side& before = sides[i - 1];
    const std::uint32_t end = end_of(graph, before);
    if (before.site != sides[i].site || start_of(graph, sides[i]) == end) continue;
    const double along_max = sides[i].along + kNearTie;
    for (std::size_t j = i + 1; j < std::min(sides.size(), i + kNearTiesMax); ++j) {
      if (sides[j].site != before.site || sides[j].along > along_max) break;
      if (start_of(graph, sides[j]) != end) continue;
      std::rotate(sides.begin() + static_cast<std::ptrdiff_t>(i),
                  sides.begin() + static_cast<std::ptrdiff_t>(j),
                  sides.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      break;
    }
  }
}

std::vector<Side> sides_in_order(const AxisGraph& graph) {
  std::vector<Side> sides;
  sides.reserve(2 * graph.edges().size());
  for (std::uint32_t i = 0; i < graph.edges().size(); ++i) {
    const AxisEdge& edge = graph.edges()[i];
    const Vector middle = (graph.nodes()[edge.from].at + graph.nodes()[edge.to].at) * 0.5;
    // A cell lies on the left of its border, and the contour goes the other way.
    sides.push_back({graph.sites().parameter(edge.left, middle), edge.left, i, false});
    sides.push_back({graph.sites().parameter(edge.right, middle), edge.right, i, true});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.site, a.along, a.edge, a.forward) <
           std::tie(b.site, b.along, b.edge, b.forward);
  });
  link_near_ties(graph, sides);
  return sides;
}

BeadSpanEnds ends_of(const AxisGraph& graph, const BeadSpan& span) {
  if (span.from == BeadSpan::kOpen) return {};
  const ContourSites& sites = graph.sites();
  const Vector from = graph.nodes()[span.from].at, to = graph.nodes()[span.to].at;
  return {sites.foot(span.site, from), sites.direction(span.site, from), sites.foot(span.last, to),
          sites.direction(span.last, to)};
}

}  // namespace

BeadSpans::BeadSpans(const AxisGraph& graph) {
  const std::vector<std::uint32_t>& rings = graph.sites().starts();
  const std::vector<Side> sides = sides_in_order(graph);
  spans_.reserve(sides.size() + rings.size());
  auto side = sides.begin();
  for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
    starts_.push_back(spans_.size());
    for (; side != sides.end() && side->site < rings[ring + 1]; ++side) {
      const AxisEdge& edge = graph.edges()[side->edge];
      add(graph,
          {side->edge, side->site, side->site, side->forward ? edge.from : edge.to,
           side->forward ? edge.to : edge.from, side->forward},
          ring);
    }
    close(graph, ring);
  }
  starts_.push_back(spans_.size());
  if (!sound_) return;
  ends_.reserve(spans_.size());
  for (const BeadSpan& span : spans_) ends_.push_back(ends_of(graph, span));
}

void BeadSpans::add(const AxisGraph& graph, const BeadSpan& span, std::size_t ring) {
  if (spans_.size() > starts_[ring]) join(graph, spans_.back(), span);
  spans_.push_back(span);
}

// What lies between two sides that don't meet.
void BeadSpans::join(const AxisGraph& graph, BeadSpan before, BeadSpan span) {
  const AxisNode& end = graph.nodes()[before.to];
  const AxisNode& start = graph.nodes()[span.from];
  if (before.to == span.from) return;
  if (end.open && start.open) {
    spans_.push_back({BeadSpan::kOpen, before.last, span.site, before.to, span.from});
  } else if (end.radius > kCornerRadius || start.radius > kCornerRadius) {
    sound_ = false;
  }
}

void BeadSpans::close(const AxisGraph& graph, std::size_t ring) {
  if (spans_.size() == starts_[ring]) {
    spans_.push_back({BeadSpan::kOpen, graph.sites().starts()[ring],
                      graph.sites().starts()[ring + 1] - 1, BeadSpan::kOpen, BeadSpan::kOpen});
    return;
  }
  const BeadSpan first = spans_[starts_[ring]];
  const std::size_t count = spans_.size();
  join(graph, spans_.back(), first);
  if (spans_.size() > count) spans_.back().round = spans_.back().site == spans_.back().last;
}

}  // namespace core
