#include "core/supports/support_roads.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/booleans/boolean.h"         // intersect, subtract
#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/slice_offsets.h"    // kRowEndShare, OffsetCutter, perimeter_spacing
#include "core/roads/island_split.h"       // IslandSplit
#include "core/roads/line_fill.h"          // LineFill
#include "core/roads/perimeters.h"         // perimeters
#include "core/roads/road_order.h"         // printing_order
#include "core/supports/dense_parts.h"     // DenseParts

namespace core {
namespace {

class LayerFill {
 public:
  LayerFill(const SupportLayer& layer, Length height, const Settings& settings)
      : layer_(layer), height_(height), settings_(settings_for(layer.index, settings)) {}

  [[nodiscard]] std::vector<Road> plan() {
    Slice slice;
    slice.index = 1;  // not a first layer, whose offsets are those of the part's
    slice.height = height_;
    slice.region = *layer_.region;
    const auto offsets = OffsetCutter(settings_).cut(slice);
    const IslandSplit split(slice.region);
    LayerRoads planned;
    planned.from = slice.region.box().min;
    planned.islands.resize(split.islands().size());
    const std::vector<Region> cores = split.split(offsets->wide_core);
    const std::vector<Region> interiors = split.split(offsets->interior);
    const std::vector<Region> lines =
        split.split(flatten(offsets->perimeters.front(), settings_.arc_tolerance));
    const DenseParts dense(*layer_.interface);
    std::vector<Region> insides;
    for (std::size_t i = 0; i < planned.islands.size(); ++i) {
      Perimeters around =
          perimeters({split.islands()[i], {lines[i]}, cores[i], interiors[i]}, height_, settings_);
      for (Road& road : around.roads) {
        for (auto& [part, is_dense] : dense.of(std::move(road))) {
          planned.islands[i].push_back(of_kind(std::move(part), is_dense));
        }
      }
      insides.push_back(std::move(around.interior));
    }
    fill(split, insides, planned.islands);
    std::erase_if(planned.islands, [](const IslandRoads& roads) { return roads.empty(); });
    return printing_order(std::move(planned));
  }

 private:
  // The sheath is one perimeter; on the bed it is as wide as the part's first layer.
  static Settings settings_for(LayerIndex index, const Settings& settings) {
    Settings own = settings;
    if (settings.support_width > Length()) own.road_width = settings.support_width;
    if (index == 0) own = first_layer_settings(own);
    own.perimeters = 1;
    own.wall_shape = WallShape::kCylinder;  // one offset for a wall that is not asked for
    own.style = BuildStyle::kThinWall;
    own.seam = SeamPosition::kNearest;
    return own;
  }

  // Of the flow that the user wants, by its width.
  [[nodiscard]] Length laid_width(Length width, bool dense) const {
    const double flow = dense ? settings_.support_interface_flow : settings_.support_flow;
    return flow == 1 ? width : bead_width(flow * bead_area_mm2(width, height_), height_);
  }

  [[nodiscard]] Road of_kind(Road road, bool dense) const {
    road.kind = dense ? RoadKind::kSupportInterface : RoadKind::kSupport;
    road.width = laid_width(road.width, dense);
    for (Length& width : road.widths) width = laid_width(width, dense);
    road.holds.clear();
    return road;
  }

  // All islands at once: a tree's layer may have thousands.
  void fill(const IslandSplit& split, const std::vector<Region>& insides,
            std::vector<IslandRoads>& roads) const {
    const Length spacing = perimeter_spacing(settings_, height_);
    if (layer_.index == 0 && settings_.raft_layers == 0) {
      const Length distance = Length::from_mm(spacing.mm() / settings_.raft_first_layer_density);
      for (std::size_t i = 0; i < insides.size(); ++i) {
        add_rows(insides[i], distance, false, roads[i]);
      }
      return;
    }
    std::vector<Ring> rings;
    for (const Region& inside : insides) {
      rings.insert(rings.end(), inside.rings().begin(), inside.rings().end());
    }
    const Region all = Region::from_clean_rings(std::move(rings));
    const Region dense = intersect(all, *layer_.interface);
    Region loose = subtract(all, dense);
    if (layer_.branches) loose = subtract(loose, *layer_.branches);
    const std::vector<Region> loose_parts = split.split(std::move(loose));
    const std::vector<Region> dense_parts = split.split(dense);
    for (std::size_t i = 0; i < insides.size(); ++i) {
      add_rows(loose_parts[i], spacing + settings_.support_spacing, false, roads[i]);
      add_rows(dense_parts[i], spacing + settings_.support_interface_spacing, true, roads[i]);
    }
  }

  void add_rows(const Region& region, Length distance, bool dense, IslandRoads& roads) const {
    if (region.empty()) return;
    const Length inset = Length::from_mm(perimeter_spacing(settings_, height_).mm() * kRowEndShare);
    const RoadKind kind = dense ? RoadKind::kSupportInterface : RoadKind::kSupport;
    const LineFill rows(settings_.support_angle_degrees);
    // The sheath joins the rows that are far apart.
    const FillArea area{region,
                        dense ? 1 : 0,
                        kind,
                        settings_.road_width,
                        distance,
                        inset,
                        settings_.arc_tolerance * 2,
                        false,
                        dense};
    for (Road& road : rows.fill(area).roads) roads.push_back(of_kind(std::move(road), dense));
  }

  const SupportLayer& layer_;
  Length height_;
  Settings settings_;
};

}  // namespace

Length support_row_distance(Length height, const Settings& settings) {
  Settings own = settings;
  if (settings.support_width > Length()) own.road_width = settings.support_width;
  return perimeter_spacing(own, height) + settings.support_spacing;
}

std::vector<Road> support_roads(const SupportLayer& layer, Length height,
                                const Settings& settings) {
  if (layer.empty()) return {};
  return LayerFill(layer, height, settings).plan();
}

std::vector<Road> with_supports(const std::vector<Road>& supports, const std::vector<Road>& roads) {
  const auto around = [](const Road& road) {
    return road.kind == RoadKind::kSkirt || road.kind == RoadKind::kBrim;
  };
  const auto first = std::find_if_not(roads.begin(), roads.end(), around);
  std::vector<Road> all(roads.begin(), first);
  all.reserve(roads.size() + supports.size());
  all.insert(all.end(), supports.begin(), supports.end());
  all.insert(all.end(), first, roads.end());
  return all;
}

SupportPlanner::Reservation SupportPlanner::reserve(const SupportLayer& layer, Length height) {
  if (layer.empty()) return {};
  // The first layer has a fill of its own.
  const bool alike = last_ && last_->layer.index > 0 && last_->height == height &&
                     last_->layer.region == layer.region &&
                     last_->layer.interface == layer.interface &&
                     last_->layer.branches == layer.branches;
  if (alike) return {last_, false};
  last_ = std::make_shared<SupportPlan>(SupportPlan{layer, height, {}});
  return {last_, true};
}

void SupportPlanner::fill(SupportPlan& plan) const {
  plan.roads = support_roads(plan.layer, plan.height, settings_);
}

}  // namespace core
