#include "core/roads/narrow_diagram.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <utility>

#include "core/regions/contact_check.h"  // surely_clean
#include "core/roads/cell_borders.h"     // find_cell_borders

namespace core {
namespace {

// Ends nearer than this are one vertex. Units.
constexpr double kSameVertex = 4;

// A vertex lower than this may end a line: a corner of the contour.
constexpr double kCornerHeight = 4;

// More loose ends are not closed.
constexpr std::size_t kLooseEndsMax = 64;

// Those so near to another vertex lie there: coordinates are true to 10 units.
constexpr double kLooseReach = 16;

class NarrowDiagram {
 public:
  NarrowDiagram(CellBorders found, double clearance_max) : clearance_max_(clearance_max) {
    diagram_.sites = std::move(found.sites);
    for (const CellBorder& border : found.borders) add(border);
    merge_vertices();
  }

  // Vertices where one line ends that may not end there.
  [[nodiscard]] std::vector<VoronoiVertex> loose_ends() const {
    std::vector<std::uint32_t> edges_at(diagram_.vertices.size(), 0);
    for (const VoronoiEdge& edge : diagram_.edges) ++edges_at[edge.from];
    std::vector<VoronoiVertex> loose;
    for (std::size_t i = 0; i < edges_at.size(); ++i) {
      const double height = diagram_.vertices[i].height;
      const bool may_end = height <= kCornerHeight || height >= clearance_max_ - kSameVertex;
      if (edges_at[i] == 1 && !may_end) loose.push_back(diagram_.vertices[i]);
    }
    return loose;
  }

  // Moves loose ends to the vertex that is nearest, if one is very near.
  void close(const std::vector<VoronoiVertex>& loose) {
    std::vector<VoronoiVertex>& vertices = diagram_.vertices;
    for (const VoronoiVertex& end : loose) {
      double least = kLooseReach;
      VoronoiVertex nearest = end;
      for (const VoronoiVertex& vertex : vertices) {
        const double away = std::max(std::abs(vertex.x - end.x), std::abs(vertex.y - end.y));
        if (away == 0 || away > least) continue;
        least = away;
        nearest = vertex;
      }
      for (VoronoiVertex& vertex : vertices) {
        if (vertex.x == end.x && vertex.y == end.y) vertex = nearest;
      }
    }
    merge_vertices();
  }

  // Adds those borders that lead from a loose end to another one, or to where the clearance is cut
  // off.
  void close(const std::vector<VoronoiVertex>& loose, const std::vector<CellBorder>& borders) {
    const auto is_loose = [&](const VoronoiVertex& end) {
      return std::any_of(loose.begin(), loose.end(),
                         [&](const VoronoiVertex& vertex) { return same(vertex, end); });
    };
    const auto ends = [&](const VoronoiVertex& end) {
      return end.height >= clearance_max_ - kSameVertex || is_loose(end);
    };
    for (const CellBorder& border : borders) {
      if (!is_loose(border.from) && !is_loose(border.to)) continue;
      if (ends(border.from) && ends(border.to) && !is_there(border)) add(border);
    }
    merge_vertices();
  }

  [[nodiscard]] VoronoiDiagram take() { return std::move(diagram_); }

 private:
  void add(const CellBorder& border) {
    const auto& [site, other, from, to] = border;
    if (same(from, to)) return;
    const auto vertex = static_cast<std::uint32_t>(diagram_.vertices.size());
    const auto half = static_cast<std::uint32_t>(diagram_.edges.size());
    diagram_.vertices.push_back(from);
    diagram_.vertices.push_back(to);
    diagram_.edges.push_back({vertex, half + 1, half + 1, half + 1, site});
    diagram_.edges.push_back({vertex + 1, half, half, half, other});
  }

  // Whether there is a border between the same sites that shares an end.
  [[nodiscard]] bool is_there(const CellBorder& border) const {
    for (std::size_t i = 0; i < diagram_.edges.size(); i += 2) {
      const VoronoiEdge &there = diagram_.edges[i], &back = diagram_.edges[i + 1];
      if (there.site != border.site || back.site != border.other) continue;
      const VoronoiVertex &from = diagram_.vertices[there.from], &to = diagram_.vertices[back.from];
      if (same(from, border.from) || same(to, border.to)) return true;
    }
    return false;
  }

  static bool same(const VoronoiVertex& a, const VoronoiVertex& b) {
    return std::abs(a.x - b.x) <= kSameVertex && std::abs(a.y - b.y) <= kSameVertex;
  }

  // Ends that meet become one vertex; edges shorter than that go.
  void merge_vertices() {
    std::vector<VoronoiVertex>& vertices = diagram_.vertices;
    // By column, and upwards in each: what may be the same stands together, or in the next column.
    struct Entry {
      double column;
      double y;
      std::uint32_t vertex;
      auto operator<=>(const Entry&) const = default;
    };
    std::vector<Entry> order;
    order.reserve(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
      order.push_back({std::floor(vertices[i].x / kSameVertex), vertices[i].y, i});
    }
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> merged(vertices.size(), UINT32_MAX);
    std::vector<VoronoiVertex> kept;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (merged[order[i].vertex] != UINT32_MAX) continue;
      const VoronoiVertex& first = vertices[order[i].vertex];
      const auto take_from = [&](std::size_t j, double column) {
        for (; j < order.size() && order[j].column == column; ++j) {
          if (order[j].y - first.y > kSameVertex) break;
          std::uint32_t& into = merged[order[j].vertex];
          if (into == UINT32_MAX && same(first, vertices[order[j].vertex]))
            into = static_cast<std::uint32_t>(kept.size());
        }
      };
      take_from(i, order[i].column);
      const Entry beside{order[i].column + 1, first.y - kSameVertex, 0};
      take_from(static_cast<std::size_t>(std::lower_bound(order.begin(), order.end(), beside) -
                                         order.begin()),
                beside.column);
      kept.push_back(first);
    }
    vertices = std::move(kept);
    std::vector<VoronoiEdge> edges;
    for (std::size_t i = 0; i < diagram_.edges.size(); i += 2) {
      VoronoiEdge there = diagram_.edges[i], back = diagram_.edges[i + 1];
      there.from = merged[there.from];
      back.from = merged[back.from];
      if (there.from == back.from) continue;
      const auto half = static_cast<std::uint32_t>(edges.size());
      there.twin = there.next = there.previous = half + 1;
      back.twin = back.next = back.previous = half;
      edges.push_back(there);
      edges.push_back(back);
    }
    diagram_.edges = std::move(edges);
  }

  double clearance_max_;
  VoronoiDiagram diagram_;
};

}  // namespace

std::optional<VoronoiDiagram> make_narrow_diagram(const std::vector<Ring>& rings,
                                                  double clearance_max) {
  if (!surely_clean(rings)) return std::nullopt;
  std::optional<CellBorders> found = find_cell_borders(rings, clearance_max);
  if (!found) return std::nullopt;
  NarrowDiagram diagram(*std::move(found), clearance_max);
  std::vector<VoronoiVertex> loose = diagram.loose_ends();
  if (loose.size() > kLooseEndsMax) return std::nullopt;
  if (!loose.empty()) {
    diagram.close(loose);
    loose = diagram.loose_ends();
  }
  if (!loose.empty()) {
    found = find_cell_borders(rings, clearance_max, BorderSide::kHigher);
    if (!found) return std::nullopt;
    diagram.close(loose, found->borders);
    if (!diagram.loose_ends().empty()) return std::nullopt;
  }
  return diagram.take();
}

}  // namespace core
