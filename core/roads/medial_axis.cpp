#include "core/roads/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"                    // RIND_CHECK
#include "core/offsets/voronoi_diagram.h"  // make_voronoi_diagram
#include "core/regions/contact_check.h"    // split_at_touches
#include "core/roads/narrow_diagram.h"     // make_narrow_diagram
#include "core/roads/ridge.h"              // Ridge
#include "core/trigonometry.h"             // hypotenuse

namespace core {
namespace {

// Lines stay this near to the true axis, and widths between their points to the true ones. Units.
constexpr double kTolerance = 10;
// How far beyond the widest road the diagram is made.
constexpr double kOpenShare = 1.1;
// Pieces that one curved edge is split into at most.
constexpr int kPiecesMax = 64;

struct Disc {
  double x = 0;
  double y = 0;
  double radius = 0;
};

// One edge of the ridge, as a curve over a parameter that runs along it:
//   two edges      a straight line, the radius linear
//   edge, corner   a parabola, radius (u² + h²) / 2h for a corner h away from the edge's line
//   two corners    a straight line, radius √(u² + h²) for corners 2h apart
class Curve {
 public:
  Curve(const VoronoiDiagram& diagram, std::uint32_t edge) {
    const VoronoiSite& a = diagram.site_of(edge);
    const VoronoiSite& b = diagram.site_of(diagram.edges[edge].twin);
    const VoronoiVertex& from = diagram.vertices[diagram.edges[edge].from];
    const VoronoiVertex& to = diagram.vertices[diagram.to(edge)];
    if (!a.is_corner() && !b.is_corner()) {
      set_linear(from, to);
      return;
    }
    const VoronoiSite& corner = a.is_corner() ? a : b;
    const VoronoiSite& other = a.is_corner() ? b : a;
    const double cx = corner.a.x, cy = corner.a.y;
    if (other.is_corner()) {
      const double dx = other.a.x - cx, dy = other.a.y - cy, length = hypotenuse(dx, dy);
      kind_ = Kind::kHyperbolic;
      height_ = length / 2;
      origin_ = {cx + dx / 2, cy + dy / 2, 0};
      along_ = {-dy / length, dx / length, 0};
    } else {
      const double dx = static_cast<double>(other.b.x) - other.a.x;
      const double dy = static_cast<double>(other.b.y) - other.a.y;
      const double length = hypotenuse(dx, dy);
      const double px = cx - other.a.x, py = cy - other.a.y;
      const double along = (px * dx + py * dy) / length, across = (dx * py - dy * px) / length;
      height_ = std::abs(across);
      if (height_ < 1) {  // too flat for a parabola, and too narrow for a road
        set_linear(from, to);
        return;
      }
      kind_ = Kind::kParabolic;
      origin_ = {other.a.x + along * dx / length, other.a.y + along * dy / length, 0};
      along_ = {dx / length, dy / length, 0};
      const double side = across < 0 ? -1 : 1;
      normal_ = {-along_.y * side, along_.x * side, 0};
    }
    first_ = parameter_of(from);
    last_ = parameter_of(to);
  }

  [[nodiscard]] Disc at(double u) const {
    if (kind_ == Kind::kLinear) {
      return {origin_.x + u * along_.x, origin_.y + u * along_.y,
              origin_.radius + u * along_.radius};
    }
    const double radius = kind_ == Kind::kParabolic ? (u * u + height_ * height_) / (2 * height_)
                                                    : hypotenuse(u, height_);
    const double lift = kind_ == Kind::kParabolic ? radius : 0;
    return {origin_.x + u * along_.x + lift * normal_.x,
            origin_.y + u * along_.y + lift * normal_.y, radius};
  }

  // Where to put points: both ends, the lowest spot, where the radius passes a limit, and between
  // these as often as the curve needs.
  void find_stops(double radius_min, double radius_max, std::vector<double>& result) const {
    result.assign({first_, last_});
    const double low = std::min(first_, last_), high = std::max(first_, last_);
    const auto add = [&](double u) {
      if (low < u && u < high) result.push_back(u);
    };
    for (const double radius : {radius_min, radius_max}) {
      if (kind_ == Kind::kLinear) {
        if (along_.radius != 0) add((radius - origin_.radius) / along_.radius);
        continue;
      }
      const double squared = kind_ == Kind::kParabolic ? 2 * height_ * radius - height_ * height_
                                                       : radius * radius - height_ * height_;
      if (squared <= 0) continue;
      add(std::sqrt(squared));
      add(-std::sqrt(squared));
    }
    if (kind_ != Kind::kLinear) {
      add(0);
      // A chord over s of a curve that bends by at most 1 / h is off by s² / 8h.
      const double pieces = (high - low) / std::sqrt(8 * height_ * kTolerance);
      const int count = static_cast<int>(std::clamp(std::ceil(pieces), 1.0, double{kPiecesMax}));
      for (int i = 1; i < count; ++i) add(low + (high - low) * i / count);
    }
    std::sort(result.begin(), result.end());
    if (first_ > last_) std::reverse(result.begin(), result.end());
  }

 private:
  enum class Kind { kLinear, kParabolic, kHyperbolic };

  void set_linear(const VoronoiVertex& from, const VoronoiVertex& to) {
    kind_ = Kind::kLinear;
    origin_ = {from.x, from.y, from.height};
    along_ = {to.x - from.x, to.y - from.y, to.height - from.height};
    first_ = 0;
    last_ = 1;
  }
  [[nodiscard]] double parameter_of(const VoronoiVertex& vertex) const {
    return (vertex.x - origin_.x) * along_.x + (vertex.y - origin_.y) * along_.y;
  }

  Kind kind_ = Kind::kLinear;
  Disc origin_, along_, normal_;
  double height_ = 0;
  double first_ = 0;
  double last_ = 1;
};

constexpr std::uint32_t kFreeEnd = UINT32_MAX;

// A stretch of an edge that is neither too narrow nor too wide.
struct Run {
  std::size_t begin = 0;  // of its discs, one after another
  std::size_t end = 0;
  std::uint32_t from = kFreeEnd;  // vertices, where the run goes right up to them
  std::uint32_t to = kFreeEnd;
  bool used = false;
};

struct Runs {
  std::vector<Run> runs;
  std::vector<Disc> discs;
};

Runs runs_of(const VoronoiDiagram& diagram, const Ridge& ridge, double radius_min,
             double radius_max) {
  Runs all;
  const auto vertex_or_end = [&](std::uint32_t vertex) {
    return ridge.on_contour(vertex) ? kFreeEnd : vertex;
  };
  std::vector<double> stops;
  for (const std::uint32_t edge : ridge.edges()) {
    const Curve curve(diagram, edge);
    curve.find_stops(radius_min, radius_max, stops);
    bool open = false;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const double middle = curve.at((stops[i] + stops[i + 1]) / 2).radius;
      if (middle < radius_min || middle > radius_max) {
        open = false;
        continue;
      }
      if (!open) {
        all.runs.push_back({all.discs.size(), 0, kFreeEnd, kFreeEnd, false});
        all.discs.push_back(curve.at(stops[i]));
        if (i == 0) all.runs.back().from = vertex_or_end(diagram.edges[edge].from);
      }
      open = true;
      all.discs.push_back(curve.at(stops[i + 1]));
      all.runs.back().end = all.discs.size();
      if (i + 2 == stops.size()) all.runs.back().to = vertex_or_end(diagram.to(edge));
    }
  }
  return all;
}

// Joins runs where just two meet.
class Chains {
 public:
  Chains(Runs all, std::size_t vertices)
      : runs_(std::move(all.runs)), discs_(std::move(all.discs)), at_(vertices) {
    for (std::uint32_t i = 0; i < runs_.size(); ++i) {
      meet(runs_[i].from, i);
      meet(runs_[i].to, i);
    }
  }

  std::vector<ThickPolyline> join() {
    std::vector<ThickPolyline> lines;
    // Open lines from their ends first; what is left then are closed ones.
    for (std::uint32_t i = 0; i < runs_.size(); ++i) {
      if (!passes(runs_[i].from)) {
        add_line(i, false, lines);
      } else if (!passes(runs_[i].to)) {
        add_line(i, true, lines);
      }
    }
    for (std::uint32_t i = 0; i < runs_.size(); ++i) add_line(i, false, lines);
    return lines;
  }

 private:
  // The runs that end at a vertex; the first two by name.
  struct Meeting {
    std::uint32_t count = 0;
    std::uint32_t first = 0;
    std::uint32_t second = 0;
  };

  void meet(std::uint32_t vertex, std::uint32_t run) {
    if (vertex == kFreeEnd) return;
    Meeting& meeting = at_[vertex];
    (meeting.count == 0 ? meeting.first : meeting.second) = run;
    ++meeting.count;
  }

  [[nodiscard]] bool passes(std::uint32_t vertex) const {
    return vertex != kFreeEnd && at_[vertex].count == 2;
  }

  void add_line(std::uint32_t run, bool backwards, std::vector<ThickPolyline>& lines) {
    if (runs_[run].used) return;
    std::vector<Disc> discs;
    bool closed = false;
    for (;;) {
      Run& current = runs_[run];
      current.used = true;
      const auto first = discs_.begin() + static_cast<std::ptrdiff_t>(current.begin);
      const auto last = discs_.begin() + static_cast<std::ptrdiff_t>(current.end);
      if (backwards) std::reverse(first, last);
      discs.insert(discs.end(), first, last);
      const std::uint32_t vertex = backwards ? current.from : current.to;
      if (!passes(vertex)) break;
      const std::uint32_t next = at_[vertex].first == run ? at_[vertex].second : at_[vertex].first;
      closed = runs_[next].used;
      if (closed) break;
      run = next;
      backwards = runs_[run].from != vertex;
    }
    append(discs, closed, lines);
  }

  static void append(const std::vector<Disc>& discs, bool closed,
                     std::vector<ThickPolyline>& lines) {
    ThickPolyline line;
    line.closed = closed;
    for (const Disc& disc : discs) {
      const Point p{static_cast<std::int32_t>(std::lround(disc.x)),
                    static_cast<std::int32_t>(std::lround(disc.y))};
      if (!line.points.empty() && line.points.back() == p) continue;
      line.points.push_back(p);
      line.widths.push_back(Length::from_units(std::llround(2 * disc.radius)));
    }
    if (closed && line.points.size() > 1 && line.points.front() == line.points.back()) {
      line.points.pop_back();
      line.widths.pop_back();
    }
    if (line.points.size() == 2) line.closed = false;
    if (line.points.size() >= 2) lines.push_back(std::move(line));
  }

  std::vector<Run> runs_;
  std::vector<Disc> discs_;
  std::vector<Meeting> at_;  // by vertex
};

}  // namespace

std::vector<ThickPolyline> medial_axis(const Region& region, Length width_min, Length width_max) {
  RIND_CHECK(Length() < width_min && width_min <= width_max);
  if (region.empty()) return {};
  // Half a unit either way, so that a gap of exactly the limit's width counts.
  const double radius_min = (static_cast<double>(width_min.units()) - 0.5) / 2;
  const double radius_max = (static_cast<double>(width_max.units()) + 0.5) / 2;
  double open_height = kOpenShare * radius_max;
  std::optional<VoronoiDiagram> diagram = make_narrow_diagram(region.rings(), open_height);
  if (!diagram) {
    diagram = make_voronoi_diagram(split_at_touches(region.rings()), 0);
    open_height = std::numeric_limits<double>::infinity();
  }
  if (!diagram) return {};
  Ridge ridge(*diagram, open_height - 1);
  ridge.drop_spurs();
  return Chains(runs_of(*diagram, ridge, radius_min, radius_max), diagram->vertices.size()).join();
}

}  // namespace core
