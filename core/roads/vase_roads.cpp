#include "core/roads/vase_roads.h"

#include "core/booleans/boolean.h"          // intersect
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/roads/overhangs.h"           // mark_holds
#include "core/walls/spiral_vase.h"         // over_vase, vase_ring

namespace core {
namespace {

Region loops_in(const Region& slice, const Settings& settings) {
  const Length half = Length::from_units(settings.road_width.units() / 2);
  return offset(slice, half, settings.arc_tolerance);
}

bool is_turn(const Region& loops) { return loops.rings().size() == 1; }

// Whether a turn lies on the one below it somewhere.
bool rests_on(const Region& slice, const Region& below, const Settings& settings) {
  return !intersect(vase_ring(slice, settings), vase_ring(below, settings)).empty();
}

// Whether a turn goes on from one layer to the one above.
bool goes_on(const Region& below, const Region& above, const Settings& settings) {
  return is_turn(loops_in(below, settings)) && is_turn(loops_in(above, settings)) &&
         rests_on(above, below, settings);
}

}  // namespace

std::vector<Road> vase_roads(const SplitLayer& layer, const Settings& settings) {
  const Region& slice = layer.slice.region;
  const Region loops = loops_in(slice, settings);
  std::vector<Road> roads;
  for (const Ring& ring : loops.rings()) {
    roads.push_back({RoadKind::kOuterPerimeter, settings.road_width, true, ring});
  }
  if (over_vase(layer, settings)) {
    mark_holds(slice, vase_ring(*layer.below, settings), settings, roads);
  } else if (layer.below) {
    mark_holds(slice, *layer.below, settings, roads);
  }
  if (!is_turn(loops)) return roads;
  SpiralTurn turn;
  if (over_vase(layer, settings) && goes_on(*layer.below, slice, settings)) {
    turn.below = layer.below_height;
  }
  turn.last = !layer.above || !goes_on(slice, *layer.above, settings);
  roads.front().spiral = turn;
  return roads;
}

}  // namespace core
