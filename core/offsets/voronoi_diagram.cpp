#include "core/offsets/voronoi_diagram.h"

#include <algorithm>
#include <boost/polygon/voronoi_builder.hpp>
#include <boost/polygon/voronoi_diagram.hpp>
#include <cmath>

#include "core/limits.h"                 // kDiagramTurnsMax
#include "core/offsets/voronoi_check.h"  // measure_and_check
#include "core/rounded.h"                // rounded
#include "core/trigonometry.h"           // cosine, sine, hypotenuse

namespace core {
namespace {

using BoostDiagram = boost::polygon::voronoi_diagram<double>;

// Between the rings and the frame that Boost sees: turned about the middle, and finer, so that
// rounding in the turned frame moves nothing by more than a small part of a unit.
class Frame {
 public:
  Frame(const std::vector<Ring>& rings, int turn) {
    if (turn == 0) return;
    Box box;
    for (const Ring& ring : rings) {
      for (const Point p : ring) box.add(p);
    }
    centre_x_ = (static_cast<double>(box.min.x) + box.max.x) / 2;
    centre_y_ = (static_cast<double>(box.min.y) + box.max.y) / 2;
    // Irregular, so that no turn lays another's edges parallel to an axis.
    const double angle = 0.7390851 * turn;
    cosine_ = cosine(angle);
    sine_ = sine(angle);
    const double reach = hypotenuse(box.max.x - centre_x_, box.max.y - centre_y_) + 1;
    scale_ = std::min(1024.0, static_cast<double>(INT32_MAX / 2) / reach);
  }

  [[nodiscard]] Point there(Point p) const {
    const double x = (p.x - centre_x_) * scale_, y = (p.y - centre_y_) * scale_;
    return {rounded(cosine_ * x - sine_ * y), rounded(sine_ * x + cosine_ * y)};
  }
  [[nodiscard]] VoronoiVertex back(double x, double y) const {
    return {(cosine_ * x + sine_ * y) / scale_ + centre_x_,
            (cosine_ * y - sine_ * x) / scale_ + centre_y_, 0};
  }

 private:
  double centre_x_ = 0, centre_y_ = 0, cosine_ = 1, sine_ = 0, scale_ = 1;
};

std::vector<Segment> segments_of(const std::vector<Ring>& rings) {
  std::vector<Segment> segments;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
    }
  }
  return segments;
}

VoronoiSite site_of(const BoostDiagram::cell_type& cell, const std::vector<Segment>& segments) {
  const Segment& segment = segments[cell.source_index()];
  if (!cell.contains_point()) return {segment.from, segment.to};
  const bool start = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
  const Point corner = start ? segment.from : segment.to;
  return {corner, corner};
}

// nullopt when links are missing.
std::optional<VoronoiDiagram> copy(const BoostDiagram& from, const std::vector<Segment>& segments,
                                   const Frame& frame) {
  VoronoiDiagram diagram;
  diagram.sites.reserve(from.cells().size());
  for (const auto& cell : from.cells()) diagram.sites.push_back(site_of(cell, segments));
  diagram.vertices.reserve(from.vertices().size());
  for (const auto& vertex : from.vertices()) {
    diagram.vertices.push_back(frame.back(vertex.x(), vertex.y()));
  }
  const auto index_of = [&](const auto* element, const auto& all) {
    return static_cast<std::uint32_t>(element - all.data());
  };
  diagram.edges.reserve(from.edges().size());
  for (const auto& edge : from.edges()) {
    if (!edge.twin() || !edge.next() || !edge.prev() || !edge.cell()) return std::nullopt;
    VoronoiEdge copied;
    if (edge.vertex0()) copied.from = index_of(edge.vertex0(), from.vertices());
    copied.twin = index_of(edge.twin(), from.edges());
    copied.next = index_of(edge.next(), from.edges());
    copied.previous = index_of(edge.prev(), from.edges());
    copied.site = index_of(edge.cell(), from.cells());
    copied.primary = edge.is_primary();
    diagram.edges.push_back(copied);
  }
  return diagram;
}

std::optional<VoronoiDiagram> build(const std::vector<Ring>& rings, int turn) {
  const std::vector<Segment> segments = segments_of(rings);
  const Frame frame(rings, turn);
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Segment& segment : segments) {
    const Point a = frame.there(segment.from), b = frame.there(segment.to);
    builder.insert_segment(a.x, a.y, b.x, b.y);
  }
  BoostDiagram boost_diagram;
  builder.construct(&boost_diagram);
  std::optional<VoronoiDiagram> diagram = copy(boost_diagram, segments, frame);
  if (!diagram || !measure_and_check(rings, *diagram)) return std::nullopt;
  diagram->turns = turn;
  return diagram;
}

}  // namespace

std::optional<VoronoiDiagram> make_voronoi_diagram(const std::vector<Ring>& rings, int first_turn) {
  for (int turn = first_turn; turn <= kDiagramTurnsMax; ++turn) {
    if (std::optional<VoronoiDiagram> diagram = build(rings, turn)) return diagram;
  }
  return std::nullopt;
}

double distance_to(const VoronoiSite& site, double x, double y) {
  const double px = x - site.a.x, py = y - site.a.y;
  if (site.is_corner()) return std::sqrt(px * px + py * py);
  const double dx = static_cast<double>(site.b.x) - site.a.x;
  const double dy = static_cast<double>(site.b.y) - site.a.y;
  const double squared = dx * dx + dy * dy, dot = px * dx + py * dy;
  if (dot <= 0) return std::sqrt(px * px + py * py);
  if (dot >= squared) return hypotenuse(x - site.b.x, y - site.b.y);
  return std::abs(dx * py - dy * px) / std::sqrt(squared);
}

}  // namespace core
