#include "core/line_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/check.h"         // RIND_CHECK
#include "core/polyline.h"      // distance_mm
#include "core/segment_grid.h"  // SegmentGrid

namespace core {

namespace {

// Stretches shorter than this share of the road's width are left for the rests.
constexpr double kStretchMinWidths = 0.5;

// A join is at most this many row distances long: enough for an edge at 20° to the rows.
constexpr double kJoinMaxDistances = 3;

// The plane turned so that rows are horizontal.
class Turn {
 public:
  explicit Turn(double degrees)
      : cosine_(std::cos(degrees * std::numbers::pi / 180)),
        sine_(std::sin(degrees * std::numbers::pi / 180)) {}

  [[nodiscard]] std::array<double, 2> to_rows(Point p) const {
    return {cosine_ * p.x + sine_ * p.y, -sine_ * p.x + cosine_ * p.y};
  }
  [[nodiscard]] Point to_plane(double along, double across) const {
    return {static_cast<std::int32_t>(std::lround(cosine_ * along - sine_ * across)),
            static_cast<std::int32_t>(std::lround(sine_ * along + cosine_ * across))};
  }

 private:
  double cosine_;
  double sine_;
};

struct Stretch {
  double from = 0;
  double to = 0;
  bool used = false;
};

// The stretches of each row inside a region, from the row `first` on.
struct Rows {
  std::int64_t first = 0;
  std::vector<std::vector<Stretch>> stretches;

  [[nodiscard]] const std::vector<Stretch>* row(std::int64_t number) const {
    const std::int64_t at = number - first;
    if (at < 0 || at >= static_cast<std::int64_t>(stretches.size())) return nullptr;
    return &stretches[static_cast<std::size_t>(at)];
  }
};

// Row n runs at (n + ½) · distance. Each edge is asked for the rows it crosses, its lower end
// counted as on the near side, so that every row meets the rings an even number of times.
Rows cut_rows(const Region& region, const Turn& turn, double distance) {
  Rows rows;
  const auto row_above = [&](double across) {
    return static_cast<std::int64_t>(std::ceil(across / distance - 0.5));
  };
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  std::int64_t highest = std::numeric_limits<std::int64_t>::min();
  for (const Ring& ring : region.rings()) {
    for (const Point p : ring) {
      const std::int64_t row = row_above(turn.to_rows(p)[1]);
      lowest = std::min(lowest, row);
      highest = std::max(highest, row);
    }
  }
  if (lowest >= highest) return rows;
  rows.first = lowest;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(highest - lowest));
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      std::array<double, 2> a = turn.to_rows(ring[i]);
      std::array<double, 2> b = turn.to_rows(ring[(i + 1) % ring.size()]);
      if (a[1] > b[1]) std::swap(a, b);
      for (std::int64_t row = row_above(a[1]); row < row_above(b[1]); ++row) {
        const double across = (static_cast<double>(row) + 0.5) * distance;
        const double t = (across - a[1]) / (b[1] - a[1]);
        crossings[static_cast<std::size_t>(row - lowest)].push_back(a[0] + t * (b[0] - a[0]));
      }
    }
  }
  for (std::vector<double>& row : crossings) {
    std::sort(row.begin(), row.end());
    std::vector<Stretch>& stretches = rows.stretches.emplace_back();
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) stretches.push_back({row[i], row[i + 1]});
  }
  return rows;
}

// Draws the stretches on by `anchor`, no further than the stretch of `within` they lie in, and
// makes one of those that meet.
void draw_on(Rows& rows, const Rows& within, double anchor) {
  for (std::size_t i = 0; i < rows.stretches.size(); ++i) {
    const auto* bounds = within.row(rows.first + static_cast<std::int64_t>(i));
    std::vector<Stretch> longer;
    for (const Stretch& stretch : rows.stretches[i]) {
      if (bounds == nullptr) break;
      const double middle = (stretch.from + stretch.to) / 2;
      const auto bound = std::find_if(bounds->begin(), bounds->end(), [&](const Stretch& b) {
        return b.from <= middle && middle <= b.to;
      });
      if (bound == bounds->end()) continue;
      const double from = std::max(stretch.from - anchor, bound->from);
      const double to = std::min(stretch.to + anchor, bound->to);
      if (!longer.empty() && from <= longer.back().to) {
        longer.back().to = std::max(longer.back().to, to);
      } else {
        longer.push_back({from, to});
      }
    }
    rows.stretches[i] = std::move(longer);
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
  Chainer(Rows& rows, const Turn& turn, double distance, bool joins, const Region& within)
      : rows_(rows),
        turn_(turn),
        distance_(distance),
        joins_(joins),
        boundary_(Length::from_mm(1)) {
    if (joins_) boundary_.add(within);
  }

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

  // The ends lie on the boundary that a join must not cross: it is asked a hair nearer the middle.
  [[nodiscard]] bool inside(Point a, Point b) const {
    return !boundary_.crosses({between(a, b, 0.02), between(a, b, 0.98)});
  }

  [[nodiscard]] std::vector<Point> chain(std::size_t row, Stretch& first) {
    first.used = true;
    std::vector<Point> points = {at(first.from, row), at(first.to, row)};
    bool forward = true;
    double end = first.to;
    while (joins_ && row + 1 < rows_.stretches.size()) {
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
  const Turn& turn_;
  double distance_;
  bool joins_;
  SegmentGrid boundary_;
};

}  // namespace

std::vector<Road> LineFill::fill(const FillArea& area) const {
  RIND_CHECK(area.distance > Length());
  std::vector<Road> roads;
  if (area.region.empty()) return roads;
  const Turn turn(angle_degrees_ + (area.layer % 2 == 0 ? 0 : 90));
  const auto distance = static_cast<double>(area.distance.units());
  const auto width = static_cast<double>(area.width.units());
  Rows rows = cut_rows(area.region, turn, distance);
  drop_short(rows, kStretchMinWidths * width);
  if (area.anchor > Length()) {
    draw_on(rows, cut_rows(area.within, turn, distance), static_cast<double>(area.anchor.units()));
  }
  Chainer chainer(rows, turn, distance, joins_ == Joins::kNearEnds, area.within);
  for (std::vector<Point>& points : chainer.chains()) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) continue;
    roads.push_back({area.kind, area.width, false, std::move(points)});
  }
  return roads;
}

}  // namespace core
