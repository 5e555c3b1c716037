#include "core/roads/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"                    // RIND_CHECK
#include "core/offsets/voronoi_diagram.h"  // make_voronoi_diagram
#include "core/regions/contact_check.h"    // split_at_touches
#include "core/roads/axis_curve.h"         // AxisCurve, Disc
#include "core/roads/narrow_diagram.h"     // make_narrow_diagram
#include "core/roads/ridge.h"              // Ridge
#include "core/rounded.h"                  // rounded

namespace core {
namespace {

// How far beyond the widest road the diagram is made.
constexpr double kOpenShare = 1.1;

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
    const AxisCurve curve(diagram, edge);
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
      const Point p{rounded(disc.x), rounded(disc.y)};
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
