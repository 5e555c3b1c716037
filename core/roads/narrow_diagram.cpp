#include "core/roads/narrow_diagram.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/regions/contact_check.h"  // surely_clean
#include "core/regions/segment_grid.h"   // SegmentGrid
#include "core/roads/cell_curves.h"      // EdgeCurve, CornerCurve
#include "core/roads/lower_envelope.h"   // LowerEnvelope
#include "core/trigonometry.h"           // arc_tangent, cosine, sine, hypotenuse
#include "core/vector.h"                 // Vector, dot, left_of

namespace core {
namespace {

// Ends nearer than this are one vertex. Units.
constexpr double kSameVertex = 4;

// Edges are looked at in stretches of so many clearances.
constexpr double kStretchClearances = 4;

// A vertex lower than this may end a line: a corner of the contour.
constexpr double kCornerHeight = 4;

struct Edge {
  Vector from;
  Vector along;  // of length 1; the region lies on its left
  double length = 0;
  std::uint32_t before = 0;  // edges on the same ring
  std::uint32_t after = 0;
  std::uint32_t corner = UINT32_MAX;  // site of the reflex corner that it starts at, if it does
};

class NarrowDiagram {
 public:
  NarrowDiagram(const std::vector<Ring>& rings, double clearance_max)
      : clearance_max_(clearance_max),
        grid_(Length::from_units(1 + std::llround(clearance_max)), edges_of(rings)) {
    add_sites(rings);
  }

  [[nodiscard]] std::optional<VoronoiDiagram> make() {
    for (std::uint32_t i = 0; i < edges_.size(); ++i) add_edge_cell(i);
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      if (edges_[i].corner != UINT32_MAX) add_corner_cell(i);
    }
    merge_vertices();
    if (!ends_are_sound()) return std::nullopt;
    return std::move(diagram_);
  }

 private:
  // Edges have the first numbers, in the order of the grid's segments; reflex corners follow.
  void add_sites(const std::vector<Ring>& rings) {
    for (const Ring& ring : rings) {
      const auto first = static_cast<std::uint32_t>(edges_.size());
      const auto count = static_cast<std::uint32_t>(ring.size());
      for (std::uint32_t i = 0; i < count; ++i) {
        const Point a = ring[i], b = ring[i + 1 < count ? i + 1 : 0];
        const Vector along = to_vector(b) - to_vector(a);
        const double length = std::sqrt(dot(along, along));
        edges_.push_back({to_vector(a),
                          {along.x / length, along.y / length},
                          length,
                          first + (i > 0 ? i : count) - 1,
                          first + (i + 1 < count ? i + 1 : 0)});
        diagram_.sites.push_back({a, b});
      }
    }
    std::uint32_t first = 0;
    for (const Ring& ring : rings) {
      const std::size_t count = ring.size();
      for (std::size_t i = 0; i < count; ++i) {
        if (cross(ring[i > 0 ? i - 1 : count - 1], ring[i], ring[i + 1 < count ? i + 1 : 0]) >= 0)
          continue;
        edges_[first + i].corner = static_cast<std::uint32_t>(diagram_.sites.size());
        diagram_.sites.push_back({ring[i], ring[i]});
      }
      first += static_cast<std::uint32_t>(count);
    }
  }

  void find_near(Vector a, Vector b) {
    const double reach = 2 * clearance_max_ + 1;
    Box box;
    for (const Vector p : {a, b}) {
      box.add(Point{low(p.x - reach), low(p.y - reach)});
      box.add(Point{low(p.x + reach) + 1, low(p.y + reach) + 1});
    }
    near_.clear();
    grid_.collect(box, near_);
  }

  static std::int32_t low(double value) {
    return static_cast<std::int32_t>(std::clamp(std::floor(value), -2e9, 2e9));
  }

  // Long edges are looked at stretch by stretch, so that each sees only what is near it.
  void add_edge_cell(std::uint32_t site) {
    const Edge& edge = edges_[site];
    const double stretch = kStretchClearances * clearance_max_;
    const auto stretches = static_cast<int>(std::ceil(edge.length / stretch));
    edge_border_.clear();
    double from = 0;
    for (int i = 1; i <= stretches; ++i) {
      const double to = i < stretches ? i * stretch : edge.length;
      find_edge_border(site, from, to);
      from = to;
    }
    from = 0;
    for (const auto& [to, curve] : edge_border_) {
      // The cell's border runs with the region on the other side: from a piece's end to its start.
      add_border(site, curve.site, edge_centre(edge, curve, to), edge_centre(edge, curve, from));
      from = to;
    }
  }

  static Vector point_on(const Edge& edge, double u) {
    return {edge.from.x + u * edge.along.x, edge.from.y + u * edge.along.y};
  }

  static VoronoiVertex edge_centre(const Edge& edge, const EdgeCurve& curve, double u) {
    const Vector touched = point_on(edge, u), normal = left_of(edge.along);
    const double r = std::max(0.0, curve.value(u));
    return {touched.x + r * normal.x, touched.y + r * normal.y, r};
  }

  void find_edge_border(std::uint32_t site, double from, double to) {
    find_near(point_on(edges_[site], from), point_on(edges_[site], to));
    edge_curves_.assign(1, {0, 0, clearance_max_});
    edge_curves_.back().site = UINT32_MAX;
    for (const std::uint32_t other : near_) {
      if (other != site) add_edge_curves(site, other, from, to);
    }
    for (const EnvelopePiece& piece : edge_envelope_.find(edge_curves_, from, to)) {
      const EdgeCurve& curve = edge_curves_[piece.curve];
      if (!edge_border_.empty() && edge_border_.back().second.site == curve.site) {
        edge_border_.back().first = piece.to;
      } else {
        edge_border_.emplace_back(piece.to, curve);
      }
    }
  }

  // What the inner side of another edge, and the reflex corner that it starts at, allow.
  void add_edge_curves(std::uint32_t site, std::uint32_t other, double from, double end) {
    const Edge& edge = edges_[site];
    const Edge& to = edges_[other];
    const Vector normal = left_of(edge.along), to_normal = left_of(to.along);
    const Vector away = to.from - edge.from;
    const double u = dot(away, edge.along), h = dot(away, normal);
    const double turn = dot(edge.along, to.along);
    const bool own_corner = other == edge.after || other == site;
    if (to.corner != UINT32_MAX && !own_corner && h > 0 && h < 2 * clearance_max_) {
      EdgeCurve curve{1 / (2 * h), -u / h, (u * u + h * h) / (2 * h)};
      curve.site = to.corner;
      add_low(curve, u, from, end);
    }
    const double h_end = h + to.length * dot(to.along, normal);
    if (1 - turn < 1e-12 || std::max(h, h_end) <= 0) return;
    if ((other == edge.after && to.corner != UINT32_MAX) ||
        (other == edge.before && edge.corner != UINT32_MAX)) {
      return;
    }
    EdgeCurve curve;
    curve.b = dot(edge.along, to_normal) / (1 - turn);
    curve.c = -dot(away, to_normal) / (1 - turn);
    curve.site = other;
    // It is touched at v(u) = v0 + v1 u, which has to lie on it, where the disc is one.
    const double v0 = -dot(away, to.along) + curve.c * dot(normal, to.along);
    const double v1 = turn + curve.b * dot(normal, to.along);
    limit(v1, v0, curve);
    limit(-v1, to.length - v0, curve);
    limit(curve.b, curve.c, curve);
    // Neighbours are touched up to the corner they share, whatever rounding says.
    if (other == edge.before) curve.low = std::numeric_limits<double>::lowest();
    if (other == edge.after) curve.high = std::numeric_limits<double>::max();
    add_low(curve, curve.b > 0 ? from : end, from, end);
  }

  // Adds the curve unless it stays above the clearance between. It is lowest at `lowest`, or where
  // it starts or ends.
  void add_low(const EdgeCurve& curve, double lowest, double from, double to) {
    const double low = std::max(curve.low, from), high = std::min(curve.high, to);
    if (!(low < high)) return;
    if (curve.value(std::clamp(lowest, low, high)) < clearance_max_) edge_curves_.push_back(curve);
  }

  // Counts only where slope · u + start >= 0.
  static void limit(double slope, double start, EdgeCurve& curve) {
    if (slope > 0) {
      curve.low = std::max(curve.low, -start / slope);
    } else if (slope < 0) {
      curve.high = std::min(curve.high, -start / slope);
    } else if (start < 0) {
      curve.high = std::numeric_limits<double>::lowest();
    }
  }

  // The discs about a reflex corner, from the normal of the edge before it to that of its own edge.
  void add_corner_cell(std::uint32_t own) {
    const Edge& edge = edges_[own];
    const Vector first = left_of(edges_[edge.before].along), last = left_of(edge.along);
    // Directions are told by their angle from the one in the middle, so that none is near ±π.
    Vector middle{first.x + last.x, first.y + last.y};
    const double length = std::sqrt(dot(middle, middle));
    if (length < 1e-9) return;
    middle = {middle.x / length, middle.y / length};
    const Vector across = left_of(middle);
    const double half = arc_tangent(std::abs(dot(first, across)), dot(first, middle));
    find_near(edge.from, edge.from);
    corner_curves_.assign(1, {1 / clearance_max_, 0, 0});
    corner_curves_.back().site = UINT32_MAX;
    for (const std::uint32_t other : near_) {
      if (other != edge.before) add_corner_curves(own, other, middle, across);
    }
    double from = -half;
    for (const EnvelopePiece& piece : corner_envelope_.find(corner_curves_, -half, half)) {
      const CornerCurve& curve = corner_curves_[piece.curve];
      const auto centre = [&](double angle) {
        const double r = -1 / curve.value(angle), x = cosine(angle), y = sine(angle);
        return VoronoiVertex{edge.from.x + r * (x * middle.x + y * across.x),
                             edge.from.y + r * (x * middle.y + y * across.y), r};
      };
      add_border(edge.corner, curve.site, centre(piece.to), centre(from));
      from = piece.to;
    }
  }

  void add_corner_curves(std::uint32_t own, std::uint32_t other, Vector middle, Vector across) {
    const Edge& to = edges_[other];
    const Vector away = to.from - edges_[own].from;
    if (to.corner != UINT32_MAX && other != own) {
      const double share = 2 / dot(away, away);
      CornerCurve curve{0, share * dot(away, middle), share * dot(away, across)};
      curve.site = to.corner;
      if (reaches(curve)) corner_curves_.push_back(curve);
    }
    const Vector normal = left_of(to.along);
    const double h = -dot(away, normal);
    if (other == own || h <= 0 || h >= 2 * clearance_max_) return;
    CornerCurve curve{1 / h, -dot(normal, middle) / h, -dot(normal, across) / h};
    curve.site = other;
    if (!reaches(curve)) return;
    // Touched at v = v0 + r n·along: v / r is of the same form as 1 / r, and so is (length − v) /
    // r.
    const double v0 = -dot(away, to.along);
    const double x = dot(to.along, middle), y = dot(to.along, across);
    add_where(v0 * curve.k, v0 * curve.x + x, v0 * curve.y + y, (to.length - v0) * curve.k,
              (to.length - v0) * curve.x - x, (to.length - v0) * curve.y - y, curve);
  }

  // Whether it gets below the clearance at any angle.
  [[nodiscard]] bool reaches(const CornerCurve& curve) const {
    return curve.k + hypotenuse(curve.x, curve.y) > 1 / clearance_max_;
  }

  // Adds the curve for the angles at which both k + x cos φ + y sin φ are at least 0.
  void add_where(double k0, double x0, double y0, double k1, double x1, double y1,
                 CornerCurve curve) {
    double stops[6] = {-M_PI / 2, M_PI / 2};
    int count = 2;
    for (const auto& [first, second] :
         {CornerCurve::angles_where(x0, y0, -k0), CornerCurve::angles_where(x1, y1, -k1)}) {
      for (const double angle : {first, second}) {
        if (angle > -M_PI / 2 && angle < M_PI / 2) stops[count++] = angle;
      }
    }
    std::sort(stops, stops + count);
    for (int i = 0; i + 1 < count; ++i) {
      const double middle = (stops[i] + stops[i + 1]) / 2;
      const double x = cosine(middle), y = sine(middle);
      if (k0 + x0 * x + y0 * y < 0 || k1 + x1 * x + y1 * y < 0) continue;
      curve.low = stops[i];
      curve.high = stops[i + 1];
      corner_curves_.push_back(curve);
    }
  }

  // The border between two cells, with `site` on its left.
  void add_border(std::uint32_t site, std::uint32_t other, VoronoiVertex from, VoronoiVertex to) {
    if (other == UINT32_MAX || other < site || same(from, to)) return;
    const auto vertex = static_cast<std::uint32_t>(diagram_.vertices.size());
    const auto half = static_cast<std::uint32_t>(diagram_.edges.size());
    diagram_.vertices.push_back(from);
    diagram_.vertices.push_back(to);
    diagram_.edges.push_back({vertex, half + 1, half + 1, half + 1, site});
    diagram_.edges.push_back({vertex + 1, half, half, half, other});
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

  [[nodiscard]] bool ends_are_sound() const {
    std::vector<std::uint32_t> edges_at(diagram_.vertices.size(), 0);
    for (const VoronoiEdge& edge : diagram_.edges) ++edges_at[edge.from];
    for (std::size_t i = 0; i < edges_at.size(); ++i) {
      const double height = diagram_.vertices[i].height;
      const bool may_end = height <= kCornerHeight || height >= clearance_max_ - kSameVertex;
      if (edges_at[i] == 1 && !may_end) return false;
    }
    return true;
  }

  double clearance_max_;
  SegmentGrid grid_;
  std::vector<Edge> edges_;
  VoronoiDiagram diagram_;
  std::vector<std::uint32_t> near_;
  std::vector<EdgeCurve> edge_curves_;
  std::vector<std::pair<double, EdgeCurve>> edge_border_;  // up to where, and what is lowest there
  std::vector<CornerCurve> corner_curves_;
  LowerEnvelope<EdgeCurve> edge_envelope_;
  LowerEnvelope<CornerCurve> corner_envelope_;
};

}  // namespace

std::optional<VoronoiDiagram> make_narrow_diagram(const std::vector<Ring>& rings,
                                                  double clearance_max) {
  if (!surely_clean(rings)) return std::nullopt;
  return NarrowDiagram(rings, clearance_max).make();
}

}  // namespace core
