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

// Whether a turn lies on another one somewhere. REQUIRES: their rings.
bool meet(const Region& a, const Region& b) { return !intersect(a, b).empty(); }

}  // namespace

std::vector<Road> vase_roads(const SplitLayer& layer, const Settings& settings) {
  const Region loops = loops_in(layer.slice.region, settings);
  std::vector<Road> roads;
  for (const Ring& ring : loops.rings()) {
    roads.push_back({RoadKind::kOuterPerimeter, settings.road_width, true, ring});
  }
  const bool over_ring = over_vase(layer, settings);
  const Region ring_below = over_ring ? vase_ring(*layer.below, settings) : Region();
  if (layer.below) {
    const Region& below = over_ring ? ring_below : *layer.below;
    mark_holds(layer.slice.region, below, settings, roads);
  }
  if (!is_turn(loops)) return roads;
  SpiralTurn turn;
  if (over_ring && is_turn(loops_in(*layer.below, settings)) && meet(layer.solid, ring_below)) {
    turn.below = layer.below_height;
  }
  turn.last = !layer.above || !is_turn(loops_in(*layer.above, settings)) ||
              !meet(layer.solid, vase_ring(*layer.above, settings));
  roads.front().spiral = turn;
  return roads;
}

}  // namespace core
