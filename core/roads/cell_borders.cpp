#include "core/roads/cell_borders.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/regions/segment_grid.h"  // SegmentGrid
#include "core/roads/border_pieces.h"   // Border, Stretch, join
#include "core/roads/cell_curves.h"     // EdgeCurve, CornerCurve
#include "core/roads/lower_envelope.h"  // LowerEnvelope
#include "core/roads/wave.h"            // Sign, Wave
#include "core/trigonometry.h"          // arc_tangent, cosine, sine
#include "core/vector.h"                // Vector, dot, left_of

namespace core {
namespace {

// Edges are looked at in stretches of so many clearances.
constexpr double kStretchClearances = 4;

// The grid's cells are as long as edges are, and no smaller than this part of the clearance.
constexpr double kCellsMax = 16;

// More edges than this near a site: discs are sought by size, each step so many times larger.
constexpr std::size_t kNearMax = 48;
constexpr double kCapStep = 3;

// Steps of work for each edge, beyond which the whole diagram costs less.
constexpr std::size_t kWorkPerEdge = 2'000;

struct Edge {
  Vector from;
  Vector along;  // of length 1; the region lies on its left
  double length = 0;
  std::uint32_t before = 0;  // edges on the same ring
  std::uint32_t after = 0;
  std::uint32_t corner = UINT32_MAX;  // site of the reflex corner that it starts at, if it does
};

class BorderSearch {
 public:
  BorderSearch(const std::vector<Ring>& rings, double clearance_max, BorderSide side)
      : side_(side),
        clearance_max_(clearance_max),
        cap_(clearance_max),
        grid_(Length::from_units(1 + std::llround(cell_for(rings, clearance_max))),
              edges_of(rings)) {
    add_sites(rings);
  }

  [[nodiscard]] std::optional<CellBorders> find() {
    const std::size_t work_max = kWorkPerEdge * edges_.size();
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      add_edge_cell(i);
      if (work() > work_max) return std::nullopt;
    }
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      if (edges_[i].corner != UINT32_MAX) add_corner_cell(i);
      if (work() > work_max) return std::nullopt;
    }
    return std::move(found_);
  }

 private:
  // Edges that were looked at, and curves that were evaluated.
  [[nodiscard]] std::size_t work() const {
    return edges_seen_ + edge_envelope_.evaluations() + corner_envelope_.evaluations();
  }

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
        found_.sites.push_back({a, b});
      }
    }
    std::uint32_t first = 0;
    for (const Ring& ring : rings) {
      const std::size_t count = ring.size();
      for (std::size_t i = 0; i < count; ++i) {
        if (cross(ring[i > 0 ? i - 1 : count - 1], ring[i], ring[i + 1 < count ? i + 1 : 0]) >= 0)
          continue;
        edges_[first + i].corner = static_cast<std::uint32_t>(found_.sites.size());
        found_.sites.push_back({ring[i], ring[i]});
      }
      first += static_cast<std::uint32_t>(count);
    }
  }

  // Cells hold a few edges each, and a search looks at a few cells.
  static double cell_for(const std::vector<Ring>& rings, double clearance_max) {
    double length = 0;
    std::size_t count = 0;
    for (const Segment& edge : edges_of(rings)) {
      const Vector along = to_vector(edge.to) - to_vector(edge.from);
      length += std::sqrt(dot(along, along));
      ++count;
    }
    const double mean = length / static_cast<double>(std::max<std::size_t>(1, count));
    return std::clamp(mean, clearance_max / kCellsMax, clearance_max);
  }

  // Edges that come near a disc about either centre.
  void find_near(Vector a, Vector b, double radius) {
    Box box;
    for (const Vector p : {a, b}) {
      box.add(Point{low(p.x - radius), low(p.y - radius)});
      box.add(Point{low(p.x + radius) + 1, low(p.y + radius) + 1});
    }
    near_.clear();
    grid_.collect(box, near_);
    edges_seen_ += near_.size();
  }

  // What is lowest along a stretch of a site. Where very many edges are near, most discs are small:
  // those up to a part of the radius are sought first, and larger ones only where those don't touch
  // anything.
  //   near(from, to)  finds the edges near the discs of radius cap_
  //   add(from, to)   adds their curves, the first of which is there
  template <typename Curve, typename Near, typename Add>
  void find_border(const Stretch& all, LowerEnvelope<Curve>& envelope, std::vector<Curve>& curves,
                   std::vector<Border<Curve>>& border, const Near& near, const Add& add) {
    stretches_.assign(1, all);
    while (!stretches_.empty()) {
      const Stretch stretch = stretches_.back();
      stretches_.pop_back();
      cap_ = stretch.cap;
      near(stretch.from, stretch.to);
      if (near_.size() > kNearMax &&
          cap_ / kCapStep > std::max(stretch.floor, clearance_max_ / kCellsMax)) {
        stretches_.push_back({stretch.from, stretch.to, cap_ / kCapStep, stretch.floor});
        continue;
      }
      add(stretch.from, stretch.to);
      double from = stretch.from;
      for (const EnvelopePiece& piece : envelope.find(curves, stretch.from, stretch.to)) {
        if (piece.curve == 0 && cap_ < clearance_max_) {
          const double cap = std::min(clearance_max_, cap_ * kCapStep);
          stretches_.push_back({from, piece.to, cap, cap_});
        } else {
          border.push_back({from, piece.to, curves[piece.curve]});
        }
        from = piece.to;
      }
    }
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
    join(edge_border_);
    for (const auto& [start, end, curve] : edge_border_) {
      // The cell's border runs with the region on the other side: from a piece's end to its start.
      add_border(site, curve.site, edge_centre(edge, curve, end), edge_centre(edge, curve, start));
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
    const Edge& edge = edges_[site];
    const auto near = [&](double start, double end) {
      const Vector up = left_of(edge.along) * cap_;
      find_near(point_on(edge, start) + up, point_on(edge, end) + up, cap_ + 1);
    };
    const auto add = [&](double start, double end) {
      edge_curves_.assign(1, {0, 0, cap_});
      edge_curves_.back().site = UINT32_MAX;
      for (const std::uint32_t other : near_) {
        if (other != site) add_edge_curves(site, other, start, end);
      }
    };
    find_border({from, to, clearance_max_, 0}, edge_envelope_, edge_curves_, edge_border_, near,
                add);
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
    if (to.corner != UINT32_MAX && !own_corner && h > 0 && h < 2 * cap_) {
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
    if (curve.value(std::clamp(lowest, low, high)) < cap_) edge_curves_.push_back(curve);
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
    const auto direction = [&](double angle) {
      const double x = cosine(angle), y = sine(angle);
      return Vector{x * middle.x + y * across.x, x * middle.y + y * across.y};
    };
    const auto in_plane = [&](Vector turned) { return middle * turned.x + across * turned.y; };
    const auto near = [&](double start, double end) {
      corner_from_ = {cosine(start), sine(start)};
      corner_to_ =
          end == -start ? Vector{corner_from_.x, -corner_from_.y} : Vector{cosine(end), sine(end)};
      // Between the two directions, centres lie beyond their chord by this at most.
      const double beyond = cap_ * (1 - cosine((end - start) / 2));
      find_near(edge.from + in_plane(corner_from_) * cap_, edge.from + in_plane(corner_to_) * cap_,
                cap_ + beyond + 1);
    };
    const auto add = [&](double, double) {
      corner_curves_.assign(1, {1 / cap_, 0, 0});
      corner_curves_.back().site = UINT32_MAX;
      for (const std::uint32_t other : near_) {
        if (other != edge.before) add_corner_curves(own, other, middle, across);
      }
    };
    corner_border_.clear();
    find_border({-half, half, clearance_max_, 0}, corner_envelope_, corner_curves_, corner_border_,
                near, add);
    join(corner_border_);
    for (const auto& [start, end, curve] : corner_border_) {
      const auto centre = [&, &curve = curve](double angle) {
        const double r = -1 / curve.value(angle);
        const Vector at = edge.from + direction(angle) * r;
        return VoronoiVertex{at.x, at.y, r};
      };
      // Angles run the other way round the corner than the contour does: as its cell's border.
      add_border(edge.corner, curve.site, centre(start), centre(end));
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
    if (other == own || h <= 0 || h >= 2 * cap_) return;
    CornerCurve curve{1 / h, -dot(normal, middle) / h, -dot(normal, across) / h};
    curve.site = other;
    if (!reaches(curve)) return;
    // Touched at v = v0 + r n·along: v / r is of the same form as 1 / r, and so is (length − v) /
    // r.
    const double v0 = -dot(away, to.along), v1 = to.length - v0;
    const double x = dot(to.along, middle), y = dot(to.along, across);
    const Wave on_start{v0 * curve.k, {v0 * curve.x + x, v0 * curve.y + y}};
    const Wave on_end{v1 * curve.k, {v1 * curve.x - x, v1 * curve.y - y}};
    const Sign start = on_start.sign_between(corner_from_, corner_to_);
    const Sign end = on_end.sign_between(corner_from_, corner_to_);
    if (start == Sign::kBelow || end == Sign::kBelow) return;
    if (start == Sign::kAbove && end == Sign::kAbove) {
      corner_curves_.push_back(curve);
    } else {
      add_where(on_start, on_end, curve);
    }
  }

  [[nodiscard]] bool reaches(const CornerCurve& curve) const {
    return curve.exceeds(1 / cap_ - curve.k, corner_from_, corner_to_);
  }

  // Adds the curve for the angles at which both are at least 0.
  void add_where(const Wave& a, const Wave& b, CornerCurve curve) {
    double stops[6] = {-M_PI / 2, M_PI / 2};
    int count = 2;
    for (const auto& [first, second] : {CornerCurve::angles_where(a.v.x, a.v.y, -a.k),
                                        CornerCurve::angles_where(b.v.x, b.v.y, -b.k)}) {
      for (const double angle : {first, second}) {
        if (angle > -M_PI / 2 && angle < M_PI / 2) stops[count++] = angle;
      }
    }
    std::sort(stops, stops + count);
    for (int i = 0; i + 1 < count; ++i) {
      const double middle = (stops[i] + stops[i + 1]) / 2;
      const CornerCurve::Place there(middle);
      if (std::min(a.at({there.x, there.y}), b.at({there.x, there.y})) < 0) continue;
      curve.low = stops[i];
      curve.high = stops[i + 1];
      corner_curves_.push_back(curve);
    }
  }

  void add_border(std::uint32_t site, std::uint32_t other, VoronoiVertex from, VoronoiVertex to) {
    const bool lower = site < other;
    if (other == UINT32_MAX || lower != (side_ == BorderSide::kLower)) return;
    found_.borders.push_back(lower ? CellBorder{site, other, from, to}
                                   : CellBorder{other, site, to, from});
  }

  BorderSide side_;
  double clearance_max_;
  double cap_;  // discs are sought up to this radius just now
  SegmentGrid grid_;
  std::vector<Edge> edges_;
  CellBorders found_;
  std::vector<std::uint32_t> near_;
  std::size_t edges_seen_ = 0;
  std::vector<EdgeCurve> edge_curves_;
  std::vector<Border<EdgeCurve>> edge_border_;
  std::vector<CornerCurve> corner_curves_;
  std::vector<Border<CornerCurve>> corner_border_;
  Vector corner_from_, corner_to_;  // the directions between which curves are added
  std::vector<Stretch> stretches_;  // still to be looked at
  LowerEnvelope<EdgeCurve> edge_envelope_;
  LowerEnvelope<CornerCurve> corner_envelope_;
};

}  // namespace

std::optional<CellBorders> find_cell_borders(const std::vector<Ring>& rings, double clearance_max,
                                             BorderSide side) {
  return BorderSearch(rings, clearance_max, side).find();
}

}  // namespace core
