#include "core/roads/axis_graph.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>

#include "core/offsets/voronoi_diagram.h"  // VoronoiDiagram, make_voronoi_diagram
#include "core/roads/axis_curve.h"         // AxisCurve, Disc
#include "core/roads/narrow_diagram.h"     // make_narrow_diagram
#include "core/roads/ridge.h"              // Ridge
#include "core/trigonometry.h"             // hypotenuse

namespace core {
namespace {

// How far beyond the least radius of a wide place the axis is known.
constexpr double kOpenShare = 1.05;

// What counts as cut off there. Units.
constexpr double kOpenSlack = 8;

// Vertices nearer than this are one node: what lies between them is rounding. Units.
constexpr double kSameNode = 16;

// Splits stay so far away from the ends of an edge.
constexpr double kShareMin = 1e-3;

// For each vertex the one that it is taken for: the highest of those that hang together.
std::vector<std::uint32_t> merged_vertices(const std::vector<VoronoiVertex>& vertices) {
  std::vector<std::uint32_t> into(vertices.size());
  std::iota(into.begin(), into.end(), 0U);
  const auto last = [&](std::uint32_t vertex) {
    while (into[vertex] != vertex) vertex = into[vertex] = into[into[vertex]];
    return vertex;
  };
  // By column, and upwards in each: what is near stands together, or in the next column.
  struct Entry {
    double column, y;
    std::uint32_t vertex;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> order;
  order.reserve(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    order.push_back({std::floor(vertices[i].x / kSameNode), vertices[i].y, i});
  }
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const VoronoiVertex& at = vertices[order[i].vertex];
    const auto merge_from = [&](std::size_t j, double column) {
      for (; j < order.size() && order[j].column == column; ++j) {
        const VoronoiVertex& to = vertices[order[j].vertex];
        if (to.y - at.y > kSameNode) break;
        if (std::abs(to.x - at.x) > kSameNode) continue;
        const std::uint32_t a = last(order[i].vertex), b = last(order[j].vertex);
        (vertices[a].height < vertices[b].height ? into[a] : into[b]) =
            vertices[a].height < vertices[b].height ? b : a;
      }
    };
    merge_from(i + 1, order[i].column);
    const Entry beside{order[i].column + 1, at.y - kSameNode, 0};
    merge_from(static_cast<std::size_t>(std::lower_bound(order.begin(), order.end(), beside) -
                                        order.begin()),
               beside.column);
  }
  for (std::uint32_t i = 0; i < into.size(); ++i) into[i] = last(i);
  return into;
}

// The diagram between merged vertices. Spurs that meet in one node leave it together, as from one
// fork: those of a disc would all go otherwise, and leave it without an axis.
VoronoiDiagram joined(const VoronoiDiagram& diagram, const std::vector<std::uint32_t>& merged) {
  VoronoiDiagram result{{}, diagram.vertices, diagram.edges};
  for (VoronoiEdge& edge : result.edges) {
    if (edge.from != VoronoiEdge::kInfinity) edge.from = merged[edge.from];
  }
  for (std::uint32_t i = 0; i < result.edges.size(); ++i) {
    if (result.edges[i].from == result.to(i)) result.edges[i].primary = false;
  }
  return result;
}

struct AxisHalves {
  std::vector<std::uint32_t> all;     // one of each edge's
  std::vector<std::uint8_t> central;  // by half
};

AxisHalves ridge_of(const VoronoiDiagram& diagram, double open_height, const Beading& beading) {
  Ridge ridge(diagram, open_height);
  AxisHalves halves{ridge.edges(), std::vector<std::uint8_t>(diagram.edges.size(), 0)};
  ridge.drop_spurs(
      {kCornerReach, beading.radius_of(beading.room_min()), kFlatMax * beading.spacing()});
  for (const std::uint32_t edge : ridge.edges()) halves.central[edge] = 1;
  return halves;
}

// Where a spur is lower than every bead no line meets it, and one edge is enough.
void drop_low_stops(const AxisCurve& curve, double depth_min, std::vector<double>& stops) {
  const auto low = [&](std::size_t i) { return curve.at(stops[i]).radius < depth_min; };
  std::size_t kept = 1;
  for (std::size_t i = 1; i + 1 < stops.size(); ++i) {
    if (low(i - 1) && low(i) && low(i + 1)) continue;
    stops[kept++] = stops[i];
  }
  stops[kept++] = stops.back();
  stops.resize(kept);
}

}  // namespace

std::optional<AxisGraph> AxisGraph::make(const std::vector<Ring>& rings, const Beading& beading) {
  double clearance = kOpenShare * beading.radius_of(beading.room_wide());
  std::optional<VoronoiDiagram> diagram = make_narrow_diagram(rings, clearance);
  if (!diagram) {
    diagram = make_voronoi_diagram(rings, 0);
    clearance = std::numeric_limits<double>::infinity();
  }
  if (!diagram) return std::nullopt;
  AxisGraph graph{ContourSites(rings)};
  if (!graph.add_edges(*diagram, clearance, beading)) return std::nullopt;
  return graph;
}

double AxisGraph::length(const AxisEdge& edge) const {
  const Vector along = nodes_[edge.to].at - nodes_[edge.from].at;
  return hypotenuse(along.x, along.y);
}

std::uint32_t AxisGraph::split(std::uint32_t edge, double share) {
  AxisEdge rest = edges_[edge];
  const AxisNode& a = nodes_[rest.from];
  const AxisNode& b = nodes_[rest.to];
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({a.at + (b.at - a.at) * share, a.radius + (b.radius - a.radius) * share, false});
  edges_[edge].to = node;
  rest.from = node;
  edges_.push_back(rest);
  return node;
}

bool AxisGraph::add_edges(const VoronoiDiagram& diagram, double clearance, const Beading& beading) {
  const std::vector<std::uint32_t> merged = merged_vertices(diagram.vertices);
  const auto [all, central] = ridge_of(joined(diagram, merged), clearance - kOpenSlack, beading);
  const std::size_t stops_expected = all.size() / 2;
  edges_.reserve(all.size() + stops_expected);
  nodes_.reserve(diagram.vertices.size() + stops_expected);
  for (const VoronoiVertex& vertex : diagram.vertices) {
    nodes_.push_back({{vertex.x, vertex.y},
                      std::max(0.0, vertex.height),
                      vertex.height >= clearance - kOpenSlack});
  }
  std::vector<double> stops;
  for (const std::uint32_t half : all) {
    const VoronoiSite& left = diagram.site_of(half);
    const VoronoiSite& right = diagram.site_of(diagram.edges[half].twin);
    AxisEdge edge{merged[diagram.edges[half].from], merged[diagram.to(half)],
                  sites_.find(left.a, left.b), sites_.find(right.a, right.b), central[half] != 0};
    if (edge.from == edge.to) continue;
    if (edge.left == ContourSites::kNone || edge.right == ContourSites::kNone) return false;
    const AxisCurve curve(diagram, half);
    curve.find_stops(0, 0, stops);
    if (!edge.central) drop_low_stops(curve, beading.depth_min(), stops);
    const std::uint32_t last = edge.to;
    for (std::size_t i = 1; i < stops.size(); ++i) {
      edge.to = last;
      if (i + 1 < stops.size()) {
        const Disc disc = curve.at(stops[i]);
        edge.to = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({{disc.x, disc.y}, disc.radius, false});
      }
      edges_.push_back(edge);
      if (edge.central) add_central(static_cast<std::uint32_t>(edges_.size()) - 1, beading);
      edge.from = edge.to;
    }
  }
  return true;
}

// Splits the edge where the count changes, and tells the pieces' counts.
void AxisGraph::add_central(std::uint32_t edge, const Beading& beading) {
  const double end = beading.room(nodes_[edges_[edge].to].radius);
  for (;;) {
    const double start = beading.room(nodes_[edges_[edge].from].radius);
    const int from = beading.count_at(start), to = beading.count_at(end);
    double share = 1;
    if (from != to) {
      const double limit = beading.room_from(from < to ? from + 1 : from);
      share = std::clamp((limit - start) / (end - start), kShareMin, 1 - kShareMin);
    }
    edges_[edge].count = from;
    if (from == to) return;
    split(edge, share);
    edge = static_cast<std::uint32_t>(edges_.size()) - 1;
    // Rounding must not ask for the same limit twice.
    AxisNode& node = nodes_[edges_[edge].from];
    const double past = from < to ? 1e-6 : -1e-6;
    const double limit = beading.room_from(from < to ? from + 1 : from);
    if ((beading.room(node.radius) - limit) * past <= 0) {
      node.radius = beading.radius_of(limit + past * beading.spacing());
    }
  }
}

}  // namespace core
