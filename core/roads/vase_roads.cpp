#include "core/roads/vase_roads.h"

#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/roads/overhangs.h"           // mark_holds
#include "core/walls/spiral_vase.h"         // starts_vase

namespace core {
namespace {

Region loops_in(const Region& slice, const Settings& settings) {
  const Length half = Length::from_units(settings.road_width.units() / 2);
  return offset(slice, half, settings.arc_tolerance);
}

bool is_turn(const Region& loops) { return loops.rings().size() == 1; }

}  // namespace

std::vector<Road> vase_roads(const SplitLayer& layer, const Settings& settings) {
  const Region loops = loops_in(layer.slice.region, settings);
  std::vector<Road> roads;
  for (const Ring& ring : loops.rings()) {
    roads.push_back({RoadKind::kOuterPerimeter, settings.road_width, true, ring});
  }
  if (layer.below) mark_holds(layer.slice.region, *layer.below, settings, roads);
  if (!is_turn(loops)) return roads;
  SpiralTurn turn;
  turn.first = starts_vase(layer, settings) || !is_turn(loops_in(*layer.below, settings));
  turn.last = !layer.above || !is_turn(loops_in(*layer.above, settings));
  turn.below = turn.first ? 1 : layer.below_height.mm() / layer.slice.height.mm();
  roads.front().spiral = turn;
  return roads;
}

}  // namespace core
