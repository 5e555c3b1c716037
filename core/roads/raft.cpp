#include "core/roads/raft.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/booleans/boolean.h"          // clean
#include "core/booleans/simplified.h"       // simplified
#include "core/offsets/slice_offsets.h"     // OffsetCutter
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/raft_heights.h"              // raft_layer_bottom
#include "core/roads/road_order.h"          // printing_order
#include "core/roads/road_planner.h"        // RoadPlanner
#include "core/roads/short_ways.h"          // lay_short_ways

namespace core {
namespace {

// Whatever its outline takes of a sparse layer, the inside is not emptier.
constexpr double kInsideDensityMin = 0.1;

// The outline is dense: the inside's share, so that the whole has the layer's.
double inside_density(double density, double whole_mm2, double inside_mm2) {
  if (inside_mm2 <= 0) return density;
  return std::clamp(1 - (1 - density) * whole_mm2 / inside_mm2, kInsideDensityMin, 1.0);
}

// A hole goes with what lies in it.
Region without_small_holes(const Region& region) {
  constexpr double kDoubledUnits = 2 * kUnitsPerMm * kUnitsPerMm;
  std::vector<Ring> rings;
  for (const Ring& ring : region.rings()) {
    const double mm2 = doubled_area_units(ring) / kDoubledUnits;
    if (mm2 > 0 || mm2 <= -kRaftHoleMin_mm2) rings.push_back(ring);
  }
  return rings.size() == region.rings().size() ? region : clean(rings, FillRule::kPositive);
}

bool is_around(RoadKind kind) { return kind == RoadKind::kSkirt || kind == RoadKind::kBrim; }

}  // namespace

double raft_density(const Settings& settings, LayerIndex layer) {
  if (layer == 0) return settings.raft_first_layer_density;
  return layer >= settings.raft_layers / 2 ? 1 : kRaftSparseDensity;
}

Raft::Raft(const Region& first, const Settings& settings)
    : settings_(settings),
      region_(without_small_holes(
          simplified(offset(first, -settings.raft_expansion, settings.arc_tolerance),
                     settings.simplify_tolerance))) {}

// The layers are planned like those of a part with one perimeter.
Settings Raft::settings_of(LayerIndex layer) const {
  Settings settings = settings_;
  settings.perimeters = 1;
  settings.wall_shape = WallShape::kCylinder;  // one offset for a wall that is not asked for
  settings.style = BuildStyle::kThinWall;
  settings.loose_pattern = LoosePattern::kLines;
  settings.loose_density = raft_density(settings_, layer);
  settings.solid_pattern = settings.top_pattern = SolidPattern::kRectilinear;
  settings.ironing = settings.spiral_vase = false;
  // Rows of odd layers are turned by 90°. The part's layer 0 lies on layer raft_layers − 1.
  if (settings.raft_layers % 2 != 0) settings.fill_angle_degrees += 90;
  return settings;
}

RaftLayer Raft::layer(LayerIndex layer) const {
  Settings settings = settings_of(layer);
  RaftLayer laid;
  SplitLayer& split = laid.layer;
  split.slice.index = layer;
  split.slice.bottom = raft_layer_bottom(settings, layer);
  split.slice.height = raft_layer_height(settings, layer);
  split.slice.region = region_;
  split.offsets = OffsetCutter(settings).cut(split.slice);
  // Neither tops nor bridges.
  split.above = std::make_shared<const Region>(region_);
  if (layer > 0) split.below = split.above;
  const bool dense = settings.loose_density >= 1;
  (dense ? split.solid : split.loose) = region_;
  settings.loose_density = inside_density(settings.loose_density, region_.area_mm2(),
                                          split.offsets->interior.area_mm2());
  laid.roads = printing_order(RoadPlanner(settings).plan(split));
  lay_short_ways(region_, settings, laid.roads);
  for (Road& road : laid.roads) {
    if (!is_around(road.kind)) road.kind = RoadKind::kRaft;
    road.holds.clear();
  }
  return laid;
}

}  // namespace core
