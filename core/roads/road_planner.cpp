#include "core/roads/road_planner.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "core/booleans/boolean.h"          // intersect, subtract, unite
#include "core/booleans/simplified.h"       // simplified
#include "core/offsets/offset_contours.h"   // flatten
#include "core/offsets/slice_offsets.h"     // perimeter_spacing
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/roads/area_perimeters.h"     // area_perimeters, perimeter_areas
#include "core/roads/branch_roads.h"        // branch_roads
#include "core/roads/bridges.h"             // bridges
#include "core/roads/brim.h"                // brim_roads
#include "core/roads/hollow_ends.h"         // HollowEnds
#include "core/roads/inside_fill.h"         // inside_fill
#include "core/roads/island_split.h"        // IslandSplit
#include "core/roads/overhangs.h"           // mark_holds
#include "core/roads/perimeters.h"          // perimeters
#include "core/roads/skirt.h"               // skirt_roads
#include "core/roads/solid_areas.h"         // solid_areas
#include "core/roads/vase_roads.h"          // vase_roads
#include "core/roads/wall_fill.h"           // ironing_roads, surface_roads, wall_roads
#include "core/walls/regularise.h"          // regularise_loose
#include "core/walls/spiral_vase.h"         // in_vase

namespace core {

namespace {

// No rim is laid so many roads about the places where it would hang.
constexpr int kHangingRimRoads = 6;

void append(std::vector<Road> more, std::vector<Road>& roads) {
  std::move(more.begin(), more.end(), std::back_inserter(roads));
}

// Where centre lines of bridges may run: up to the innermost perimeter's.
Region bridge_room(const SliceOffsets& offsets, const Settings& settings) {
  if (offsets.perimeters.empty()) return offsets.interior;
  return flatten(offsets.perimeters.back(), settings.arc_tolerance, ArcForm::kBothSides);
}

// What of the interior is wall, and kWallGrace more where there is any.
Region wall_to_fill(const Region& interior, const Region& loose, const Settings& settings) {
  Region wall = subtract(interior, loose);
  if (wall.empty() || loose.empty()) return wall;
  const Length outwards = Length() - kWallGrace;
  return simplified(intersect(offset(wall, outwards, settings.arc_tolerance), interior),
                    kWallSimplify);
}

// The wall as it would be if the inside did not hold its roof, and a road wide at least: what is
// made solid for roofs leaves its roads as they are. Not beside places where the rim itself lies
// over a hollow: roads along it would hang there, where rows reach out and come back.
Region wall_rim(const Region& interior, const SplitLayer& layer, const Settings& settings) {
  if (!layer.window_loose || interior.empty()) return {};
  const Region loose = simplified(*layer.window_loose, settings.simplify_tolerance);
  const Length road = perimeter_spacing(settings, layer.slice.height);
  Region rim = unite(wall_to_fill(interior, loose, settings),
                     subtract(interior, offset(interior, road, settings.arc_tolerance)));
  if (!layer.below_loose) return rim;
  const Region hanging = intersect(rim, subtract(*layer.below_loose, layer.loose));
  if (hanging.empty()) return rim;
  const Length outwards = Length() - road * kHangingRimRoads;
  return subtract(rim, offset(hanging, outwards, settings.arc_tolerance));
}

std::vector<Road> solid_roads(const SolidAreas& areas, const Region& rim, const Slice& slice,
                              const Settings& settings) {
  const Length height = slice.height;
  std::vector<Road> roads = wall_roads(areas.between, rim, slice.index, height, settings);
  append(surface_roads(areas.bottom, RoadKind::kBottomSolid, slice.index, height, settings), roads);
  append(surface_roads(areas.top, RoadKind::kTopSolid, slice.index, height, settings), roads);
  if (settings.ironing) append(ironing_roads(areas.top, slice.index, height, settings), roads);
  return roads;
}

// Returns what bridges leave of the wall. REQUIRES: layer.below.
Region lay_bridges(const SplitLayer& layer, const Region& room, Region wall,
                   const Settings& settings, std::vector<Road>& roads) {
  const Slice& slice = layer.slice;
  const Region none;
  const Region& below_loose = layer.below_loose ? *layer.below_loose : none;
  const Region held = layer.below_branches ? branch_beads(*layer.below_branches, settings) : none;
  Bridges over =
      bridges({slice.region, room, *layer.below, below_loose, slice.index, slice.height, &held},
              std::move(wall), settings);
  append(std::move(over.roads), roads);
  return std::move(over.rest);
}

// What is planned of one island.
struct IslandPlan {
  IslandOffsets offsets;
  Region room;  // where the centre lines of loose roads may run: half a road from the contour
  Region loose;
  SolidAreas areas;
  Region rim;  // of what is between
  IslandRoads roads;
};

// The parts of a region, each to its island's plan.
template <typename Place>
void share_out(const IslandSplit& split, Region all, std::vector<IslandPlan>& plans,
               const Place& place) {
  std::vector<Region> parts = split.split(std::move(all));
  for (std::size_t i = 0; i < plans.size(); ++i) place(plans[i], std::move(parts[i]));
}

std::vector<IslandPlan> start_plans(const IslandSplit& split, const SplitLayer& layer,
                                    const Settings& settings) {
  const SliceOffsets& offsets = *layer.offsets;
  std::vector<IslandPlan> plans(split.islands().size());
  for (std::size_t i = 0; i < plans.size(); ++i) plans[i].offsets.region = split.islands()[i];
  for (const OffsetContours& line : offsets.perimeters) {
    share_out(
        split, flatten(line, settings.arc_tolerance, ArcForm::kBothSides), plans,
        [](IslandPlan& plan, Region part) { plan.offsets.perimeters.push_back(std::move(part)); });
  }
  share_out(split, offsets.wide_core, plans,
            [](IslandPlan& plan, Region part) { plan.offsets.wide_core = std::move(part); });
  share_out(split, offsets.interior, plans,
            [](IslandPlan& plan, Region part) { plan.offsets.interior = std::move(part); });
  return plans;
}

// What the perimeters of all islands leave.
struct Left {
  Region interior;
  std::optional<Region> bridge_room;  // where it does not follow from the slice's offsets alone
};

// Each island's perimeters.
Left plan_perimeters(std::vector<IslandPlan>& plans, const Slice& slice, const Settings& settings,
                     std::vector<Road>& roads) {
  const ChangedAreas areas = perimeter_areas(slice, settings);
  std::vector<Ring> interior, room;
  const auto add = [](const Region& region, std::vector<Ring>& rings) {
    rings.insert(rings.end(), region.rings().begin(), region.rings().end());
  };
  for (IslandPlan& plan : plans) {
    if (!plan.offsets.perimeters.empty()) plan.room = plan.offsets.perimeters.front();
    AreaPerimeters laid;
    if (areas.empty()) {
      laid.around = perimeters(std::move(plan.offsets), slice.height, settings);
    } else {
      laid = area_perimeters(std::move(plan.offsets), areas, slice.height, settings);
    }
    append(std::move(laid.around.roads), roads);
    add(laid.around.interior, interior);
    add(laid.innermost, room);
  }
  Left left{Region::from_clean_rings(std::move(interior)), {}};
  if (!areas.empty()) left.bridge_room = Region::from_clean_rings(std::move(room));
  return left;
}

// What is loose of an island. Of a block of layers, what is common to them is laid in the highest.
std::vector<Road> inside_roads(const IslandPlan& plan, const SplitLayer& layer,
                               const Settings& settings) {
  const Region& room = plan.room.empty() ? plan.loose : plan.room;
  if (settings.loose_pattern == LoosePattern::kLightning) return {};
  const LooseBlock& block = layer.block;
  if (!block.region) return inside_fill(plan.loose, room, layer.slice, settings);
  const Region own =
      regularise_loose(subtract(plan.loose, *block.region), regularise_options(settings));
  std::vector<Road> roads = inside_fill(own, room, layer.slice, settings);
  if (block.layers == 0) return roads;
  Slice thick;
  thick.index = block.number;
  thick.height = layer.slice.height * block.layers;
  thick.bottom = layer.slice.top() - thick.height;
  thick.areas = layer.slice.areas;
  for (Road& road : inside_fill(intersect(plan.loose, *block.region), room, thick, settings)) {
    road.layers = block.layers;
    roads.push_back(std::move(road));
  }
  return roads;
}

// What is filled of each island.
void share_fill(const IslandSplit& split, SolidAreas areas, Region loose, Region rim,
                std::vector<IslandPlan>& plans) {
  share_out(split, std::move(areas.between), plans,
            [](IslandPlan& plan, Region part) { plan.areas.between = std::move(part); });
  share_out(split, std::move(areas.bottom), plans,
            [](IslandPlan& plan, Region part) { plan.areas.bottom = std::move(part); });
  share_out(split, std::move(areas.top), plans,
            [](IslandPlan& plan, Region part) { plan.areas.top = std::move(part); });
  share_out(split, std::move(loose), plans,
            [](IslandPlan& plan, Region part) { plan.loose = std::move(part); });
  share_out(split, std::move(rim), plans,
            [](IslandPlan& plan, Region part) { plan.rim = std::move(part); });
}

// Skirt and brim, around the supports, too; nothing where nothing lies on the bed.
void add_around(const SplitLayer& layer, const Settings& settings, LayerRoads& planned) {
  const Slice& slice = layer.slice;
  const bool supported = layer.support && !layer.support->empty();
  if (planned.islands.empty() && !supported) return;
  const Region foot = supported ? unite(slice.region, *layer.support) : slice.region;
  planned.first = skirt_roads(foot, slice.height, settings);
  append(brim_roads(foot, slice.height, settings), planned.first);
}

}  // namespace

RoadPlanner::RoadPlanner(const Settings& settings)
    : settings_(settings), first_settings_(first_layer_settings(settings)) {}

LayerRoads RoadPlanner::plan_vase(const SplitLayer& layer) const {
  LayerRoads planned;
  std::vector<Road> roads = vase_roads(layer, settings_);
  if (roads.empty()) return planned;
  planned.from = layer.slice.region.box().min;
  planned.islands.push_back(std::move(roads));
  return planned;
}

LayerRoads RoadPlanner::plan(const SplitLayer& layer) const {
  const Slice& slice = layer.slice;
  if (in_vase(slice, settings_)) return plan_vase(layer);
  const Settings& settings = slice.index == 0 ? first_settings_ : settings_;
  const IslandSplit split(slice.region);
  std::vector<IslandPlan> plans = start_plans(split, layer, settings);
  std::vector<Road> roads;
  const Left left = plan_perimeters(plans, slice, settings, roads);
  const Region& interior = left.interior;
  if (layer.below) mark_holds(slice.region, *layer.below, settings, roads);
  const Region loose = simplified(layer.loose, settings.simplify_tolerance);
  Region wall = wall_to_fill(interior, loose, settings);
  if (layer.below) {
    const Region room =
        left.bridge_room ? *left.bridge_room : bridge_room(*layer.offsets, settings);
    wall = lay_bridges(layer, room, std::move(wall), settings, roads);
  }
  for (Road& road : roads) {
    plans[split.island_of(road.points.front())].roads.push_back(std::move(road));
  }
  share_fill(split, solid_areas(std::move(wall), layer, settings), intersect(loose, interior),
             wall_rim(interior, layer, settings), plans);
  if (layer.branches) {
    for (Road& road : branch_roads(*layer.branches, settings)) {
      plans[split.island_of(road.points.front())].roads.push_back(std::move(road));
    }
  }
  LayerRoads planned;
  const HollowEnds hollow_ends(layer, settings);
  for (IslandPlan& plan : plans) {
    append(solid_roads(plan.areas, plan.rim, slice, settings), plan.roads);
    if (!plan.loose.empty()) append(inside_roads(plan, layer, settings), plan.roads);
    hollow_ends.cut(plan.roads);
    if (!plan.roads.empty()) planned.islands.push_back(std::move(plan.roads));
  }
  if (slice.index == 0) add_around(layer, settings, planned);
  if (planned.islands.empty()) return planned;
  planned.from = slice.region.box().min;
  planned.outer_first = settings.outer_perimeter_first;
  return planned;
}

}  // namespace core
