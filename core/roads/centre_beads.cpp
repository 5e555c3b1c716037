#include "core/roads/centre_beads.h"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.h"  // hypotenuse

namespace core {
namespace {

// Shorter ones are left out, in shares of the spacing.
constexpr double kLengthMin = 0.25;

// A bead runs into a place with more beads this far at most, in shares of the spacing.
constexpr double kReachMax = 4;

constexpr std::uint32_t kNone = UINT32_MAX;

double distance(Vector a, Vector b) { return hypotenuse(b.x - a.x, b.y - a.y); }

class CentreBeads {
 public:
  CentreBeads(const Beading& beading, const AxisGraph& graph)
      : beading_(beading),
        graph_(graph),
        central_(graph, [](const AxisEdge& edge) { return edge.central; }),
        odd_(graph,
             [&](const AxisEdge& edge) { return edge.central && beading.has_centre(edge.count); }),
        used_(graph.edges().size(), 0) {}

  [[nodiscard]] std::vector<BeadLine> lines() {
    for (std::uint32_t node = 0; node < graph_.nodes().size(); ++node) {
      for (const std::uint32_t* edge = odd_.begin(node); edge != odd_.end(node); ++edge) {
        if (used_[*edge] == 0 && partner(node, *edge) == kNone) add_open(node, *edge);
      }
    }
    for (std::uint32_t edge = 0; edge < graph_.edges().size(); ++edge) {
      const AxisEdge& at = graph_.edges()[edge];
      if (at.central && beading_.has_centre(at.count) && used_[edge] == 0) add_closed(edge);
    }
    return std::move(lines_);
  }

 private:
  [[nodiscard]] Vector at(std::uint32_t node) const { return graph_.nodes()[node].at; }
  [[nodiscard]] double radius(std::uint32_t node) const { return graph_.nodes()[node].radius; }
  [[nodiscard]] std::uint32_t far(std::uint32_t edge, std::uint32_t node) const {
    const AxisEdge& on = graph_.edges()[edge];
    return on.from == node ? on.to : on.from;
  }
  [[nodiscard]] const BeadState& state(std::uint32_t edge, std::uint32_t node) const {
    const AxisEdge& on = graph_.edges()[edge];
    return on.states[on.from == node ? 0 : 1];
  }
  [[nodiscard]] BeadPoint point(std::uint32_t edge, std::uint32_t node) const {
    return {at(node), beading_.centre_room(graph_.edges()[edge].count, radius(node))};
  }

  // Of all edges that meet at the node, the two that go straight on are partners.
  [[nodiscard]] std::uint32_t partner(std::uint32_t node, std::uint32_t edge) const {
    std::uint32_t first = kNone, second = kNone;
    double straightest = 2;
    for (const std::uint32_t* a = odd_.begin(node); a != odd_.end(node); ++a) {
      for (const std::uint32_t* b = a + 1; b < odd_.end(node); ++b) {
        const Vector u = at(far(*a, node)) - at(node), v = at(far(*b, node)) - at(node);
        const double product = hypotenuse(u.x, u.y) * hypotenuse(v.x, v.y);
        const double cosine = product > 0 ? dot(u, v) / product : 1;
        if (cosine >= straightest) continue;
        straightest = cosine;
        first = *a;
        second = *b;
      }
    }
    if (edge == first) return second;
    return edge == second ? first : kNone;
  }

  // From a node along an edge and on; returns the last node and the last edge.
  std::pair<std::uint32_t, std::uint32_t> follow(std::uint32_t node, std::uint32_t edge,
                                                 std::vector<BeadPoint>& points) {
    for (;;) {
      used_[edge] = 1;
      node = far(edge, node);
      points.push_back(point(edge, node));
      const std::uint32_t next = partner(node, edge);
      if (next == kNone || used_[next] != 0) return {node, edge};
      edge = next;
    }
  }

  void add_open(std::uint32_t node, std::uint32_t edge) {
    BeadLine line{{point(edge, node)}, false};
    const auto [last_node, last_edge] = follow(node, edge, line.points);
    finish_end(last_node, last_edge, line.points);
    std::reverse(line.points.begin(), line.points.end());
    finish_end(node, edge, line.points);
    add(std::move(line));
  }

  void add_closed(std::uint32_t edge) {
    BeadLine line{{}, true};
    follow(graph_.edges()[edge].from, edge, line.points);
    add(std::move(line));
  }

  void add(BeadLine line) {
    double length = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      length += distance(line.points[i - 1].at, line.points[i].at);
    }
    if (length < kLengthMin * beading_.spacing()) return;
    if (line.points.size() < (line.closed ? 3 : 2)) return;
    lines_.push_back(std::move(line));
  }

  // The line's last point is at this node.
  void finish_end(std::uint32_t node, std::uint32_t edge, std::vector<BeadPoint>& points) const {
    if (odd_.count(node) > 2) {
      const double room = point(edge, node).room;
      return trim(points, at(node), room / 2);
    }
    if (central_.count(node) != 2) return;
    const std::uint32_t next = central_.other(node, edge);
    const int count = graph_.edges()[edge].count, other = graph_.edges()[next].count;
    if (other > count) return run_into(node, next, count / 2 + 1, points);
    if (other > 0 && state(next, node).share > 0) run_through(node, next, points);
  }

  // On to where the pairs on the other side have moved half way.
  void run_through(std::uint32_t node, std::uint32_t edge, std::vector<BeadPoint>& points) const {
    const double room = points.back().room;
    for (;;) {
      const std::uint32_t end = far(edge, node);
      const double first = state(edge, node).share, last = state(edge, end).share;
      if (last <= 0.5) {
        const double share = first > last ? std::clamp((first - 0.5) / (first - last), 0., 1.) : 0;
        points.push_back({at(node) + (at(end) - at(node)) * share, room});
        return;
      }
      points.push_back({at(end), room});
      if (central_.count(end) != 2) return;
      edge = central_.other(end, edge);
      node = end;
    }
  }

  // On to where the pair of `level` begins, which goes across.
  void run_into(std::uint32_t node, std::uint32_t edge, int level,
                std::vector<BeadPoint>& points) const {
    const Bead here = beading_.bead(level, state(edge, node));
    if (here.depth <= radius(node)) {
      return trim(points, middle_of(edge, node, here.depth), here.room / 2);
    }
    const std::size_t before = points.size();
    const double room = points.back().room;
    double reach = kReachMax * beading_.spacing();
    for (;;) {
      const std::uint32_t end = far(edge, node);
      const double low = radius(node) - beading_.bead(level, state(edge, node)).depth;
      const Bead there = beading_.bead(level, state(edge, end));
      const double high = radius(end) - there.depth;
      if (high > 0) {
        const Vector across = at(node) + (at(end) - at(node)) * (low / (low - high));
        points.push_back({across, room});
        return trim(points, across, there.room / 2);
      }
      points.push_back({at(end), room});
      reach -= distance(at(node), at(end));
      if (reach < 0 || high < low || central_.count(end) != 2) break;
      const std::uint32_t next = central_.other(end, edge);
      if (graph_.edges()[next].count != graph_.edges()[edge].count) break;
      edge = next;
      node = end;
    }
    points.resize(before);  // it never begins
  }

  // Half way between the two points at this depth below the contour on either side of the axis.
  [[nodiscard]] Vector middle_of(std::uint32_t edge, std::uint32_t node, double depth) const {
    const ContourSites& sites = graph_.sites();
    const AxisEdge& on = graph_.edges()[edge];
    const Vector left = sites.foot(on.left, at(node)) + sites.direction(on.left, at(node)) * depth;
    const Vector right =
        sites.foot(on.right, at(node)) + sites.direction(on.right, at(node)) * depth;
    return (left + right) * 0.5;
  }

  // Takes from the line's end what is nearer than this to a point.
  static void trim(std::vector<BeadPoint>& points, Vector from, double distance_min) {
    while (!points.empty() && distance(points.back().at, from) < distance_min) {
      const BeadPoint gone = points.back();
      points.pop_back();
      if (points.empty()) return;
      const BeadPoint& kept = points.back();
      const double near = distance(gone.at, from), away = distance(kept.at, from);
      if (away <= distance_min) continue;
      const double share = (distance_min - near) / (away - near);
      const BeadPoint end{gone.at + (kept.at - gone.at) * share,
                          gone.room + (kept.room - gone.room) * share};
      points.push_back(end);
      return;
    }
  }

  const Beading& beading_;
  const AxisGraph& graph_;
  EdgesAt central_;
  EdgesAt odd_;
  std::vector<std::uint8_t> used_;  // by edge
  std::vector<BeadLine> lines_;
};

}  // namespace

std::vector<BeadLine> centre_beads(const Beading& beading, const AxisGraph& graph) {
  return CentreBeads(beading, graph).lines();
}

}  // namespace core
