#include "core/roads/branch_roads.h"

#include <algorithm>
#include <cstdint>

#include "core/booleans/boolean.h"  // clean
#include "core/geometry.h"          // Point, Ring
#include "core/regions/polyline.h"  // between, distance_units
#include "core/rounded.h"           // rounded
#include "core/vector.h"            // left_of, to_vector, Vector

namespace core {
namespace {

Point moved(Point point, Vector by) { return {rounded(point.x + by.x), rounded(point.y + by.y)}; }

}  // namespace

std::vector<Road> branch_roads(const Branches& branches, const Settings& settings) {
  const Length half = Length::from_units(settings.road_width.units() / 2);
  const Length room = std::max(Length(), settings.wall_thickness - half);
  const auto anchor = static_cast<double>(std::min(settings.loose_anchor, room).units());
  std::vector<Road> roads;
  for (const Branch& branch : branches) {
    const double length = distance_units(branch.from, branch.to);
    if (length == 0) continue;
    const double share = anchor / length;
    const Point from = branch.from_wall ? between(branch.from, branch.to, -share) : branch.from;
    const Point to = branch.to_wall ? between(branch.to, branch.from, -share) : branch.to;
    roads.push_back({RoadKind::kLoose, settings.road_width, false, {from, to}});
  }
  return roads;
}

Region branch_beads(const Branches& branches, const Settings& settings) {
  std::vector<Ring> beads;
  for (const Branch& branch : branches) {
    const double length = distance_units(branch.from, branch.to);
    if (length == 0) continue;
    const Vector along = to_vector(branch.to) - to_vector(branch.from);
    const Vector aside =
        left_of(along) * (static_cast<double>(settings.road_width.units()) / 2 / length);
    beads.push_back({moved(branch.from, aside * -1), moved(branch.to, aside * -1),
                     moved(branch.to, aside), moved(branch.from, aside)});
  }
  return clean(beads, FillRule::kNonZero);
}

}  // namespace core
