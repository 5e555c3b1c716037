#include "core/roads/road_planner.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/booleans/boolean.h"          // clean, intersect, subtract
#include "core/booleans/simplified.h"       // simplified
#include "core/offsets/offset_contours.h"   // flatten
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/roads/bridges.h"             // bridges
#include "core/roads/brim.h"                // brim_roads
#include "core/roads/gap_fill.h"            // gap_fill_roads
#include "core/roads/loose_fill.h"          // loose_roads
#include "core/roads/overhangs.h"           // mark_holds
#include "core/roads/perimeters.h"          // perimeters
#include "core/roads/road_order.h"          // by_island
#include "core/roads/skirt.h"               // skirt_roads
#include "core/roads/solid_areas.h"         // solid_areas
#include "core/roads/wall_fill.h"           // ironing_roads, surface_roads, wall_roads

namespace core {

namespace {

void append(std::vector<Road> more, std::vector<Road>& roads) {
  std::move(more.begin(), more.end(), std::back_inserter(roads));
}

// Where the centre lines of loose roads may run: no deeper than half a road from the contour.
Region road_room(const SplitLayer& layer, const Settings& settings) {
  const SliceOffsets& offsets = *layer.offsets;
  if (offsets.perimeters.empty()) return layer.loose;
  return flatten(offsets.perimeters.front(), settings.arc_tolerance);
}

// Where centre lines of bridges may run: up to the innermost perimeter's.
Region bridge_room(const SliceOffsets& offsets, const Settings& settings) {
  if (offsets.perimeters.empty()) return offsets.interior;
  return flatten(offsets.perimeters.back(), settings.arc_tolerance);
}

// What of the interior is wall, and kWallGrace more where there is any.
Region wall_to_fill(const Region& interior, const Region& loose, const Settings& settings) {
  Region wall = subtract(interior, loose);
  if (wall.empty() || loose.empty()) return wall;
  const Length outwards = Length() - kWallGrace;
  return simplified(intersect(offset(wall, outwards, settings.arc_tolerance), interior),
                    kWallSimplify);
}

std::vector<Road> solid_roads(const SolidAreas& areas, const Slice& slice,
                              const Settings& settings) {
  const Length height = slice.height;
  std::vector<Road> roads = wall_roads(areas.between, slice.index, height, settings);
  append(surface_roads(areas.bottom, RoadKind::kBottomSolid, slice.index, height, settings), roads);
  append(surface_roads(areas.top, RoadKind::kTopSolid, slice.index, height, settings), roads);
  if (settings.ironing) append(ironing_roads(areas.top, slice.index, height, settings), roads);
  return roads;
}

// Returns what bridges leave of the wall. REQUIRES: layer.below.
Region lay_bridges(const SplitLayer& layer, Region wall, const Settings& settings,
                   std::vector<Road>& roads) {
  const Slice& slice = layer.slice;
  const Region room = bridge_room(*layer.offsets, settings);
  const Region none;
  const Region& below_loose = layer.below_loose ? *layer.below_loose : none;
  Bridges over = bridges({slice.region, room, *layer.below, below_loose, slice.index, slice.height},
                         std::move(wall), settings);
  append(std::move(over.roads), roads);
  return std::move(over.rest);
}

}  // namespace

RoadPlanner::RoadPlanner(const Settings& settings)
    : settings_(settings), first_settings_(first_layer_settings(settings)) {}

LayerRoads RoadPlanner::plan(const SplitLayer& layer) const {
  const Slice& slice = layer.slice;
  const Settings& settings = slice.index == 0 ? first_settings_ : settings_;
  const SliceOffsets& offsets = *layer.offsets;
  const Length height = slice.height;
  Perimeters around = perimeters(slice, offsets, settings);
  std::vector<Road> roads = std::move(around.roads);
  if (layer.below) mark_holds(slice.region, *layer.below, settings, roads);
  append(gap_fill_roads(around.gaps, GapBoundary::kPart, height, settings), roads);
  const Region loose = simplified(layer.loose, settings.simplify_tolerance);
  Region wall = wall_to_fill(offsets.interior, loose, settings);
  if (layer.below) wall = lay_bridges(layer, std::move(wall), settings, roads);
  append(solid_roads(solid_areas(std::move(wall), layer, settings), slice, settings), roads);
  if (!loose.empty()) {
    append(loose_roads(intersect(loose, offsets.interior), road_room(layer, settings), slice,
                       settings),
           roads);
  }
  LayerRoads planned;
  if (roads.empty()) return planned;
  planned.from = slice.region.box().min;
  if (slice.index == 0) {
    planned.first = skirt_roads(slice.region, height, settings);
    append(brim_roads(slice.region, height, settings), planned.first);
  }
  planned.outer_first = settings.outer_perimeter_first;
  planned.islands = by_island(std::move(roads), slice.region);
  return planned;
}

}  // namespace core
