#include "core/roads/area_perimeters.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"         // intersect, subtract, unite
#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/slice_offsets.h"    // OffsetCutter
#include "core/regions/polyline.h"         // distance_units
#include "core/roads/area_pieces.h"        // AreaPieces
#include "core/roads/nearest_point.h"      // NearestPoint

namespace core {
namespace {

// An island as it would be with one number all over.
struct Plan {
  int number = 0;
  Region innermost;
  Perimeters around;
};

Region innermost_of(const IslandOffsets& island) {
  return island.perimeters.empty() ? island.interior : island.perimeters.back();
}

IslandOffsets cut_island(const Region& region, Length height, Settings settings) {
  // Of what is cut, only what roads need is of use here.
  settings.wall_shape = WallShape::kCylinder;
  settings.seam = SeamPosition::kNearest;
  Slice slice;
  slice.index = 1;  // the settings are the layer's own
  slice.height = height;
  slice.region = region;
  settings.first_layer_width = Length();
  const std::shared_ptr<const SliceOffsets> cut = OffsetCutter(settings).cut(slice);
  IslandOffsets island{region, {}, cut->wide_core, cut->interior};
  for (const OffsetContours& line : cut->perimeters) {
    island.perimeters.push_back(flatten(line, settings.arc_tolerance));
  }
  return island;
}

Plan planned(IslandOffsets island, Length height, const Settings& settings) {
  Plan plan{settings.perimeters, innermost_of(island), {}};
  plan.around = perimeters(std::move(island), height, settings);
  return plan;
}

Length width_on(const Road& road, double place) {
  const std::size_t count = road.points.size();
  const auto first = std::min(static_cast<std::size_t>(place), count - 1);
  const double share = place - static_cast<double>(first);
  const double from = width_at(road, first).mm();
  const double to = width_at(road, (first + 1) % count).mm();
  return Length::from_mm(std::lerp(from, to, share));
}

Road part_of(const Road& road, AreaPiece piece) {
  Road part{road.kind, road.width, false, std::move(piece.points)};
  if (road.widths.empty()) return part;
  double sum_mm = 0;
  for (const double place : piece.places) {
    part.widths.push_back(width_on(road, place));
    sum_mm += part.widths.back().mm();
  }
  part.width = Length::from_mm(sum_mm / static_cast<double>(part.widths.size()));
  return part;
}

// Takes what of a road lies where its number holds: `whole`, or in parts.
void keep(Road road, int number, const AreaPieces& borders, const std::vector<int>& numbers,
          std::vector<Road>& whole, std::vector<Road>& parts) {
  std::vector<Point> line = road.points;
  if (road.closed) line.push_back(line.front());
  std::vector<AreaPiece> pieces = borders.cut(line);
  const auto holds = [&](const AreaPiece& piece) {
    const std::size_t at = piece.area < 0 ? 0 : static_cast<std::size_t>(piece.area) + 1;
    return numbers[at] == number;
  };
  if (std::all_of(pieces.begin(), pieces.end(), holds)) return whole.push_back(std::move(road));
  for (AreaPiece& piece : pieces) {
    if (holds(piece)) parts.push_back(part_of(road, std::move(piece)));
  }
}

void append(Road more, Road& road) {
  const bool widths = !road.widths.empty() || !more.widths.empty();
  if (widths && road.widths.empty()) road.widths.assign(road.points.size(), road.width);
  if (widths && more.widths.empty()) more.widths.assign(more.points.size(), more.width);
  const std::ptrdiff_t skipped = road.points.back() == more.points.front() ? 1 : 0;
  road.points.insert(road.points.end(), more.points.begin() + skipped, more.points.end());
  if (!widths) return;
  road.widths.insert(road.widths.end(), more.widths.begin() + skipped, more.widths.end());
}

// The part that goes on where each ends, or its own number.
std::vector<std::size_t> successors(const std::vector<Road>& parts) {
  std::vector<NearestPoint::Entry> starts;
  for (std::size_t i = 0; i < parts.size(); ++i) starts.push_back({parts[i].points.front(), i, 0});
  NearestPoint left(std::move(starts));
  std::vector<std::size_t> next(parts.size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Point end = parts[i].points.back();
    const auto nearest = left.nearest(end);
    if (!nearest) break;
    const Road& other = parts[nearest->owner];
    const double reach = kBorderJoinMax * static_cast<double>(parts[i].width.units());
    if (other.kind != parts[i].kind || distance_units(end, nearest->point) > reach) continue;
    next[i] = nearest->owner;
    left.remove_owner(nearest->owner);
  }
  return next;
}

// A road from `first` on; closed where it comes back to it.
Road chain(std::size_t first, const std::vector<std::size_t>& next, std::vector<Road>& parts,
           std::vector<bool>& used) {
  Road road = std::move(parts[first]);
  used[first] = true;
  std::size_t at = next[first];
  for (; at != parts.size() && !used[at]; at = next[at]) {
    append(std::move(parts[at]), road);
    used[at] = true;
  }
  if (at != first || road.points.size() < 3) return road;
  if (road.points.back() == road.points.front()) {
    road.points.pop_back();
    if (!road.widths.empty()) road.widths.pop_back();
  }
  road.closed = road.points.size() >= 3;
  return road;
}

// Joins the parts that meet.
void join(std::vector<Road> parts, std::vector<Road>& roads) {
  if (parts.empty()) return;
  const std::vector<std::size_t> next = successors(parts);
  std::vector<bool> follows(parts.size(), false), used(parts.size(), false);
  for (const std::size_t to : next) {
    if (to != parts.size()) follows[to] = true;
  }
  // Chains from their first part on, then rings.
  for (const bool rings : {false, true}) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!used[i] && follows[i] == rings) roads.push_back(chain(i, next, parts, used));
    }
  }
}

// Where no more than `number` are asked for. Less the more of them there are: what regions of a
// larger number share with it has no seam along the border.
Region up_to(int number, const Region& island, const ChangedAreas& areas, int elsewhere) {
  const bool outside = elsewhere <= number;
  Region some;
  for (const ChangedArea& area : areas) {
    if ((*area.change.perimeters <= number) != outside) some = unite(some, area.region);
  }
  return outside ? subtract(island, some) : intersect(island, some);
}

}  // namespace

ChangedAreas perimeter_areas(const Slice& slice, const Settings& settings) {
  ChangedAreas some;
  if (!slice.areas || settings.perimeters == 0) return some;
  for (const ChangedArea& area : *slice.areas) {
    if (!area.change.perimeters) continue;
    AreaChange change;
    change.perimeters = area.change.perimeters;
    some.push_back({change, area.region});
  }
  some = parted(some);
  std::erase_if(some, [&](const ChangedArea& area) {
    return *area.change.perimeters == settings.perimeters;
  });
  return some;
}

AreaPerimeters area_perimeters(IslandOffsets island, const ChangedAreas& areas, Length height,
                               const Settings& settings) {
  const Region region = island.region;
  const Box box = region.box();
  std::vector<Plan> plans;
  std::vector<int> numbers{settings.perimeters};  // by area, from kNoArea on
  std::vector<Region> borders;
  Region rest = region;
  for (const ChangedArea& area : areas) {
    if (!area.region.box().overlaps(box)) continue;
    numbers.push_back(*area.change.perimeters);
    borders.push_back(area.region);
    const Region own = intersect(region, area.region);
    if (own.empty()) continue;
    rest = subtract(rest, own);
    Settings there = settings;
    there.perimeters = *area.change.perimeters;
    plans.push_back(planned(cut_island(region, height, there), height, there));
  }
  if (plans.empty() || !rest.empty()) {
    plans.push_back(planned(std::move(island), height, settings));
  }
  if (plans.size() == 1) return {std::move(plans[0].around), std::move(plans[0].innermost)};
  std::sort(plans.begin(), plans.end(),
            [](const Plan& a, const Plan& b) { return a.number < b.number; });
  AreaPerimeters all;
  const AreaPieces pieces(borders);
  std::vector<Road> parts;
  for (Plan& plan : plans) {
    for (Road& road : plan.around.roads) {
      keep(std::move(road), plan.number, pieces, numbers, all.around.roads, parts);
    }
    const bool last = &plan == &plans.back();
    const Region there = last ? region : up_to(plan.number, region, areas, settings.perimeters);
    const auto add = [&](Region own, Region& to) {
      to = unite(to, last ? std::move(own) : intersect(own, there));
    };
    add(std::move(plan.around.interior), all.around.interior);
    add(std::move(plan.innermost), all.innermost);
  }
  join(std::move(parts), all.around.roads);
  return all;
}

}  // namespace core
