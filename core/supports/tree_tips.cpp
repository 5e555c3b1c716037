#include "core/supports/tree_tips.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/polyline.h"        // between, distance_mm, distance_units
#include "core/roads/row_turn.h"          // RowTurn, turned_box
#include "core/supports/support_roads.h"  // support_row_distance

namespace core {
namespace {

// Places on an edge that are looked at are at most this far apart.
constexpr double kEdgeStep_mm = 0.4;

class TipCells {
 public:
  TipCells(Length height, const Settings& settings)
      : turn_(settings.support_angle_degrees),
        row_(static_cast<double>(support_row_distance(height, settings).units())),
        along_(static_cast<double>(settings.support_tip_spacing.units())) {
    rows_ = std::max(1.0, std::floor(along_ / row_));
  }

  using Cell = std::pair<std::int64_t, std::int64_t>;  // across, along

  [[nodiscard]] Cell at(Point point) const {
    const auto [along, across] = turn_.to_rows(point);
    return {whole(across / (rows_ * row_)), whole(along / along_)};
  }
  // Under a row.
  [[nodiscard]] Point middle(const Cell& cell) const {
    const double row = static_cast<double>(cell.first) * rows_ + std::floor(rows_ / 2) + 0.5;
    return turn_.to_plane((static_cast<double>(cell.second) + 0.5) * along_, row * row_);
  }
  // Those of a box, turned as the rows.
  [[nodiscard]] std::pair<Cell, Cell> range(const Box& box) const {
    const TurnedBox turned = turned_box(box, turn_);
    return {{whole(turned.bottom / (rows_ * row_)), whole(turned.low / along_)},
            {whole(turned.top / (rows_ * row_)), whole(turned.high / along_)}};
  }

 private:
  static std::int64_t whole(double value) { return static_cast<std::int64_t>(std::floor(value)); }

  RowTurn turn_;
  double row_, along_;
  double rows_ = 1;  // a cell has
};

}  // namespace

std::vector<Point> tip_places(const Region& region, Length height, const Settings& settings) {
  std::vector<Point> places;
  if (region.empty()) return places;
  const TipCells cells(height, settings);
  const PointLocation inside(region);
  const auto [first, last] = cells.range(region.box());
  for (std::int64_t across = first.first; across <= last.first; ++across) {
    for (std::int64_t along = first.second; along <= last.second; ++along) {
      const Point middle = cells.middle({across, along});
      if (inside.contains(middle)) places.push_back(middle);
    }
  }
  std::map<TipCells::Cell, std::pair<double, Point>> edges;  // the nearest to each middle
  for (const Segment& edge : edges_of(region.rings())) {
    const int steps = std::max(1, static_cast<int>(distance_mm(edge.from, edge.to) / kEdgeStep_mm));
    for (int step = 0; step < steps; ++step) {
      const Point at = between(edge.from, edge.to, static_cast<double>(step) / steps);
      const TipCells::Cell cell = cells.at(at);
      const std::pair found{distance_units(at, cells.middle(cell)), at};
      const auto [place, added] = edges.emplace(cell, found);
      if (!added) place->second = std::min(place->second, found);
    }
  }
  for (const auto& each : edges) places.push_back(each.second.second);
  return places;
}

}  // namespace core
