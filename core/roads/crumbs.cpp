#include "core/roads/crumbs.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "core/regions/point_location.h"  // PointLocation
#include "core/regions/polyline.h"        // between, distance_mm
#include "core/regions/segment_grid.h"    // SegmentGrid

namespace core {
namespace {

constexpr Length kCell = Length::from_units(10'000);

double covered_mm2(const Road& road) {
  const std::size_t count = road.points.size();
  double sum = 0;
  for (std::size_t i = 0; i < (road.closed ? count : count - 1); ++i) {
    const std::size_t j = (i + 1) % count;
    const double width = (width_at(road, i).mm() + width_at(road, j).mm()) / 2;
    sum += distance_mm(road.points[i], road.points[j]) * width;
  }
  return sum;
}

// Where a crumb would be seen.
class Sight {
 public:
  Sight(const SplitLayer& layer, Length reach)
      : contours_(kCell, layer.slice.region),
        reach_(reach),
        above_(*layer.above),
        below_(*layer.below) {}

  [[nodiscard]] bool reaches(const Road& road) const {
    for (std::size_t i = 1; i < road.points.size(); ++i) {
      const Point from = road.points[i - 1], to = road.points[i];
      if (reaches(from) || reaches(between(from, to, 0.5)) || reaches(to)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool reaches(Point point) const {
    return contours_.any_within(point, reach_) || !above_.contains(point) ||
           !below_.contains(point);
  }

  SegmentGrid contours_;
  Length reach_;
  PointLocation above_;
  PointLocation below_;
};

// The road after the run that begins here: each begins where the one before ends.
std::size_t end_of_run(const std::vector<Road>& roads, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < roads.size() && !roads[end - 1].closed &&
         roads[end - 1].points.back() == roads[end].points.front()) {
    ++end;
  }
  return end;
}

}  // namespace

void drop_crumbs(const SplitLayer& layer, const Settings& settings, std::vector<Road>& roads) {
  if (!layer.above || !layer.below) return;
  const double width_mm = settings.road_width.mm();
  const double least_mm2 = kCrumbSquaresMax * width_mm * width_mm;
  std::optional<Sight> sight;
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < roads.size();) {
    const std::size_t end = end_of_run(roads, begin);
    double mm2 = 0;
    bool crumb = true;
    for (std::size_t i = begin; crumb && i < end; ++i) {
      mm2 += covered_mm2(roads[i]);
      crumb = roads[i].kind == RoadKind::kGapFill && mm2 < least_mm2;
    }
    for (std::size_t i = begin; crumb && i < end; ++i) {
      if (!sight) sight.emplace(layer, settings.road_width);
      crumb = !sight->reaches(roads[i]);
    }
    for (; begin < end; ++begin) {
      if (crumb) continue;
      if (kept != begin) roads[kept] = std::move(roads[begin]);
      ++kept;
    }
  }
  roads.resize(kept);
}

}  // namespace core
