#include "core/roads/line_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/regions/polyline.h"  // between, distance_units

namespace core {
namespace {

// Cells of the grid: about the distance of loose rows.
constexpr Length kCell = Length::from_units(20'000);

bool left(Point a, Point b, Point c) { return cross(a, b, c) > 0; }

Point nearest_on(const Segment& edge, Point point) {
  const double dx = static_cast<double>(edge.to.x) - edge.from.x;
  const double dy = static_cast<double>(edge.to.y) - edge.from.y;
  const double px = static_cast<double>(point.x) - edge.from.x;
  const double py = static_cast<double>(point.y) - edge.from.y;
  const double share = (px * dx + py * dy) / (dx * dx + dy * dy);
  return between(edge.from, edge.to, std::clamp(share, 0.0, 1.0));
}

}  // namespace

LineClipper::LineClipper(const Region& region)
    : region_(region), edges_(edges_of(region.rings())), grid_(kCell, edges_) {
  ring_of_.reserve(edges_.size());
  starts_.reserve(edges_.size());
  std::size_t edge = 0;
  for (std::size_t ring = 0; ring < region.rings().size(); ++ring) {
    double along = 0;
    for (std::size_t i = 0; i < region.rings()[ring].size(); ++i, ++edge) {
      ring_of_.push_back(static_cast<std::uint32_t>(ring));
      starts_.push_back(along);
      along += distance_units(edges_[edge].from, edges_[edge].to);
    }
    ring_lengths_.push_back(along);
  }
}

void LineClipper::crossings(const Segment& segment, std::vector<Crossing>& found) const {
  std::vector<std::uint32_t> near;
  grid_.collect_along(segment, near);
  const Point p = segment.from, q = segment.to;
  for (const std::uint32_t i : near) {
    const auto& [a, b] = edges_[i];
    if (left(p, q, a) == left(p, q, b) || left(a, b, p) == left(a, b, q)) continue;
    const auto before = static_cast<double>(cross(a, b, p));
    const auto after = static_cast<double>(cross(a, b, q));
    found.push_back({before / (before - after), i});
  }
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return a.share != b.share ? a.share < b.share : a.edge < b.edge;
  });
}

void LineClipper::clip(const std::vector<Point>& line, std::vector<ClippedLine>& pieces) const {
  ClippedLine piece;
  bool inside = false;
  std::vector<Crossing> found;
  for (std::size_t i = 1; i < line.size(); ++i) {
    found.clear();
    crossings({line[i - 1], line[i]}, found);
    for (const Crossing& crossing : found) {
      const Point at = between(line[i - 1], line[i], crossing.share);
      const BoundaryPlace place = place_on(crossing.edge, at);
      inside = !inside;
      if (inside) {
        piece.points = {at};
        piece.from = place;
        continue;
      }
      if (piece.points.back() != at) piece.points.push_back(at);
      piece.to = place;
      if (piece.points.size() >= 2) pieces.push_back(std::exchange(piece, {}));
    }
    if (inside && piece.points.back() != line[i]) piece.points.push_back(line[i]);
  }
}

double LineClipper::first_crossing(Point a, Point b) const {
  std::vector<Crossing> found;
  crossings({a, b}, found);
  return found.empty() ? 2 : found.front().share;
}

BoundaryPlace LineClipper::place_on(std::uint32_t edge, Point at) const {
  return {ring_of_[edge], starts_[edge] + distance_units(edges_[edge].from, at)};
}

void LineClipper::append_crossings(Point a, Point b, std::vector<BoundaryPoint>& places) const {
  std::vector<Crossing> found;
  crossings({a, b}, found);
  for (const Crossing& crossing : found) {
    const Point at = between(a, b, crossing.share);
    places.push_back({at, place_on(crossing.edge, at)});
  }
}

std::optional<BoundaryPoint> LineClipper::nearest(Point point, Length reach) const {
  const auto by = static_cast<std::int32_t>(reach.units());
  std::vector<std::uint32_t> near;
  grid_.collect({{point.x - by, point.y - by}, {point.x + by, point.y + by}}, near);
  std::optional<BoundaryPoint> best;
  auto least = static_cast<double>(reach.units());
  for (const std::uint32_t i : near) {
    const Point at = nearest_on(edges_[i], point);
    const double distance = distance_units(point, at);
    if (distance > least || (best && distance == least)) continue;
    least = distance;
    best = {at, place_on(i, at)};
  }
  return best;
}

void LineClipper::append_way(const BoundaryPlace& from, const BoundaryPlace& to, bool forwards,
                             std::vector<Point>& points) const {
  const Ring& ring = region_.rings()[from.ring];
  const std::size_t count = ring.size();
  const auto first = static_cast<std::size_t>(
      std::lower_bound(ring_of_.begin(), ring_of_.end(), from.ring) - ring_of_.begin());
  const auto edge_at = [&](double along) {
    const auto begin = starts_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto after = std::upper_bound(begin, begin + static_cast<std::ptrdiff_t>(count), along);
    return static_cast<std::size_t>(after - begin) - 1;
  };
  std::size_t edge = edge_at(from.along);
  const std::size_t last = edge_at(to.along);
  const bool once_round = forwards ? to.along < from.along : to.along > from.along;
  if (edge == last && !once_round) return;
  do {
    edge = (edge + (forwards ? 1 : count - 1)) % count;
    points.push_back(ring[forwards ? edge : (edge + 1) % count]);
  } while (edge != last);
}

}  // namespace core
