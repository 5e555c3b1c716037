#include "core/roads/line_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/check.h"                 // RIND_CHECK
#include "core/regions/polyline.h"      // distance_mm
#include "core/regions/segment_grid.h"  // SegmentGrid
#include "core/roads/row_turn.h"        // RowTurn
#include "core/trigonometry.h"          // hypotenuse

namespace core {

namespace {

// Stretches shorter than this share of the road's width are left for gap fill.
constexpr double kStretchMinWidths = 0.5;

// A join is at most this many row distances long: enough for an edge at 20° to the rows.
constexpr double kJoinMaxDistances = 3;

struct Stretch {
  double from = 0;
  double to = 0;
  bool used = false;
};

// The stretches of each row inside a region, from the row `first` on.
struct Rows {
  std::int64_t first = 0;
  std::vector<std::vector<Stretch>> stretches;
};

// Row n runs at (n + ½) · distance. This is the first row at or above `across`.
std::int64_t row_from(double across, double distance) {
  return static_cast<std::int64_t>(std::ceil(across / distance - 0.5));
}

double row_across(std::int64_t row, double distance) {
  return (static_cast<double>(row) + 0.5) * distance;
}

using Edge = std::array<std::array<double, 2>, 2>;  // along, across

std::vector<Edge> turned_edges(const Region& region, const RowTurn& turn) {
  std::vector<Edge> edges;
  edges.reserve(region.point_count());
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Edge edge = {turn.to_rows(ring[i]), turn.to_rows(ring[(i + 1) % ring.size()])};
      if (edge[0][1] > edge[1][1]) std::swap(edge[0], edge[1]);
      edges.push_back(edge);
    }
  }
  return edges;
}

// Each edge is asked for the rows it crosses, its lower end counted as on the near side, so that
// every row meets the rings an even number of times.
Rows cut_rows(const std::vector<Edge>& edges, double distance) {
  Rows rows;
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  std::int64_t highest = std::numeric_limits<std::int64_t>::min();
  for (const Edge& edge : edges) {
    lowest = std::min(lowest, row_from(edge[0][1], distance));
    highest = std::max(highest, row_from(edge[1][1], distance));
  }
  if (lowest >= highest) return rows;
  rows.first = lowest;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(highest - lowest));
  for (const auto& [a, b] : edges) {
    for (std::int64_t row = row_from(a[1], distance); row < row_from(b[1], distance); ++row) {
      const double t = (row_across(row, distance) - a[1]) / (b[1] - a[1]);
      crossings[static_cast<std::size_t>(row - lowest)].push_back(a[0] + t * (b[0] - a[0]));
    }
  }
  for (std::vector<double>& row : crossings) {
    std::sort(row.begin(), row.end());
    std::vector<Stretch>& stretches = rows.stretches.emplace_back();
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) stretches.push_back({row[i], row[i + 1]});
  }
  return rows;
}

// The stretch of the row at `across` that is nearer than `reach` to the edge: it meets the discs
// round both ends, and the straight sides between. Empty when from > to.
Stretch near_edge(const Edge& edge, double across, double reach) {
  Stretch near{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  const auto meet = [&](double low, double high) {
    near.from = std::min(near.from, low);
    near.to = std::max(near.to, high);
  };
  for (const std::array<double, 2>& end : edge) {
    const double away = across - end[1];
    if (std::abs(away) >= reach) continue;
    const double half = std::sqrt(reach * reach - away * away);
    meet(end[0] - half, end[0] + half);
  }
  const double dx = edge[1][0] - edge[0][0], dy = edge[1][1] - edge[0][1];
  const double length = hypotenuse(dx, dy);
  if (dy <= 0 || length == 0) return near;
  for (const double side : {-reach, reach}) {
    const double nx = -dy / length * side, ny = dx / length * side;
    const double t = (across - edge[0][1] - ny) / dy;
    if (t < 0 || t > 1) continue;
    const double along = edge[0][0] + nx + t * dx;
    meet(along, along);
  }
  return near;
}

// Takes from the rows all that is nearer than `inset` to an edge: what stays is the inner offset.
void cut_inset(Rows& rows, const std::vector<Edge>& edges, double distance, double inset) {
  std::vector<std::vector<Stretch>> taken(rows.stretches.size());
  const auto count = static_cast<std::int64_t>(taken.size());
  for (const Edge& edge : edges) {
    const std::int64_t first = row_from(edge[0][1] - inset, distance) - rows.first;
    const std::int64_t end = row_from(edge[1][1] + inset, distance) - rows.first;
    for (std::int64_t i = std::max<std::int64_t>(first, 0); i < std::min(end, count); ++i) {
      const Stretch near = near_edge(edge, row_across(rows.first + i, distance), inset);
      if (near.from < near.to) taken[static_cast<std::size_t>(i)].push_back(near);
    }
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    std::sort(taken[i].begin(), taken[i].end(),
              [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    std::vector<Stretch> left;
    for (const Stretch& whole : rows.stretches[i]) {
      double from = whole.from;
      for (const Stretch& gone : taken[i]) {
        if (gone.to <= from) continue;
        if (gone.from >= whole.to) break;
        if (gone.from > from) left.push_back({from, gone.from});
        from = gone.to;
      }
      if (from < whole.to) left.push_back({from, whole.to});
    }
    rows.stretches[i] = std::move(left);
  }
}

void drop_short(Rows& rows, double shortest) {
  for (std::vector<Stretch>& row : rows.stretches) {
    std::erase_if(row, [&](const Stretch& s) { return s.to - s.from < shortest; });
  }
}

// Strings stretches together, row by row upwards, for as long as a join is found.
class Chainer {
 public:
  Chainer(Rows& rows, const RowTurn& turn, double distance, const Region& region)
      : rows_(rows), turn_(turn), distance_(distance), boundary_(Length::from_mm(1), region) {}

  [[nodiscard]] std::vector<std::vector<Point>> chains() {
    std::vector<std::vector<Point>> all;
    for (std::size_t row = 0; row < rows_.stretches.size(); ++row) {
      for (Stretch& stretch : rows_.stretches[row]) {
        if (!stretch.used) all.push_back(chain(row, stretch));
      }
    }
    return all;
  }

 private:
  [[nodiscard]] Point at(double along, std::size_t row) const {
    const double number = static_cast<double>(rows_.first + static_cast<std::int64_t>(row));
    return turn_.to_plane(along, (number + 0.5) * distance_);
  }

  [[nodiscard]] bool inside(Point a, Point b) const { return !boundary_.crosses({a, b}); }

  [[nodiscard]] std::vector<Point> chain(std::size_t row, Stretch& first) {
    first.used = true;
    std::vector<Point> points = {at(first.from, row), at(first.to, row)};
    bool forward = true;
    double end = first.to;
    while (row + 1 < rows_.stretches.size()) {
      Stretch* next = nearest(row + 1, end, forward);
      if (next == nullptr) break;
      const double near = forward ? next->to : next->from;
      if (!inside(points.back(), at(near, row + 1))) break;
      next->used = true;
      ++row;
      forward = !forward;
      end = forward ? next->to : next->from;
      points.push_back(at(near, row));
      points.push_back(at(end, row));
    }
    return points;
  }

  [[nodiscard]] Stretch* nearest(std::size_t row, double end, bool forward) {
    Stretch* best = nullptr;
    double best_away = (kJoinMaxDistances - 1) * distance_;
    for (Stretch& stretch : rows_.stretches[row]) {
      const double away = std::abs((forward ? stretch.to : stretch.from) - end);
      if (stretch.used || away > best_away) continue;
      best = &stretch;
      best_away = away;
    }
    return best;
  }

  Rows& rows_;
  const RowTurn& turn_;
  double distance_;
  SegmentGrid boundary_;
};

}  // namespace

std::vector<Road> LineFill::fill(const FillArea& area) const {
  RIND_CHECK(area.distance > Length());
  std::vector<Road> roads;
  if (area.region.empty()) return roads;
  const RowTurn turn(angle_degrees_ + (area.layer % 2 == 0 ? 0 : 90));
  const auto distance = static_cast<double>(area.distance.units());
  const auto width = static_cast<double>(area.width.units());
  const std::vector<Edge> edges = turned_edges(area.region, turn);
  Rows rows = cut_rows(edges, distance);
  if (area.inset > Length()) {
    cut_inset(rows, edges, distance, static_cast<double>(area.inset.units()));
  }
  drop_short(rows, kStretchMinWidths * width);
  Chainer chainer(rows, turn, distance, area.region);
  for (std::vector<Point>& points : chainer.chains()) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) continue;
    roads.push_back({area.kind, area.width, false, std::move(points)});
  }
  return roads;
}

}  // namespace core
