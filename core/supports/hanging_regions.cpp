#include "core/supports/hanging_regions.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"             // clean, intersect, subtract, unite
#include "core/geometry.h"                     // Ring
#include "core/offsets/slice_offsets.h"        // perimeter_depth, perimeter_spacing
#include "core/offsets/voronoi_mountain.h"     // offset
#include "core/regions/point_location.h"       // PointLocation
#include "core/roads/bridge_direction.h"       // best_direction
#include "core/roads/bridge_rows.h"            // BridgeArea, bridge_rows, covered_by
#include "core/roads/bridges.h"                // air_bridges, kBridgeTrials
#include "core/roads/overhang_reach.h"         // overhang_reach
#include "core/roads/unheld.h"                 // is_hair, islands_in_air, unheld
#include "core/supports/airborne_stretches.h"  // airborne_stretches

namespace core {
namespace {

// How exact the back of a hanging strip is, where it is not the slice's.
constexpr Length kBackTolerance = Length::from_units(200);

// What bridges leave of the fill along their edges is narrower than this many roads.
constexpr double kCrumbWidths = 0.5;

void append(const Region& region, std::vector<Ring>& rings) {
  rings.insert(rings.end(), region.rings().begin(), region.rings().end());
}

// Finds what of the air around one slice no bridge holds.
class BridgeSearch {
 public:
  BridgeSearch(const Region& slice, const Region& below, Region air, Length height,
               const Settings& settings)
      : below_(below), air_(std::move(air)), height_(height), settings_(settings) {
    const Length band = perimeter_depth(settings, height, settings.perimeters + 1);
    const Length around = band * 2 + settings.road_width * 4;
    local_ = intersect(slice, offset(air_, -around, kBackTolerance));
    held_ = intersect(below, offset(air_, -around, kBackTolerance));
  }

  [[nodiscard]] Region search() {
    std::optional<Region> not_spanned = without_spans();
    if (!not_spanned) return std::move(air_);
    const Region left = unite(*not_spanned, unbridged_fill());
    return unite(left, intersect(perimeters_in_air(), subtract(local_, held_)));
  }

 private:
  // What no rows span, were all of it bridged, perimeters and fill alike. Nothing where none do.
  [[nodiscard]] std::optional<Region> without_spans() const {
    const Length width = settings_.road_width;
    const Length beyond = Length::from_mm(width.mm() * (kBridgeAnchorWidths + kBridgeReachWidths));
    const Region around = intersect(offset(air_, -beyond, kBackTolerance), local_);
    std::vector<Ring> spanned;
    for (Island& island : islands(around)) {
      const Region region = region_of(std::move(island));
      const BridgeArea area{region, region, rings_near(held_, region.box()), {}, width};
      const BridgeRows rows = bridge_rows(area, best_direction(area, width, kBridgeTrials), width);
      const bool bridged =
          rows.laid_spans_mm > rows.cut_spans_mm && rows.longest_mm <= settings_.bridge_max.mm();
      if (bridged) append(rows.cut.empty() ? region : covered_by(rows, area), spanned);
    }
    if (spanned.empty()) return {};
    return subtract(air_, Region::from_clean_rings(std::move(spanned)));
  }

  // What bridges leave of the fill, as they will be laid.
  [[nodiscard]] Region unbridged_fill() const {
    const Length inner = perimeter_depth(settings_, height_, settings_.perimeters) +
                         Length::from_units(perimeter_spacing(settings_, height_).units() / 2);
    const Region fill = offset(local_, inner, kBackTolerance);
    if (fill.empty()) return {};
    const Region room =
        settings_.perimeters == 0
            ? fill
            : offset(local_, perimeter_depth(settings_, height_, settings_.perimeters),
                     kBackTolerance);
    const Region none;
    Region left = intersect(air_, fill);
    for (const AirBridge& bridge :
         air_bridges({local_, room, held_, none, 0, height_}, fill, settings_)) {
      if (!bridge.holds() || bridge.rows.longest_mm > settings_.bridge_max.mm()) continue;
      left = subtract(left, covered_by(bridge.rows, bridge.area));
    }
    std::vector<Ring> pieces;
    for (Island& island : islands(left)) {
      const Region piece = region_of(std::move(island));
      if (2 * piece.area_mm2() > kCrumbWidths * settings_.road_width.mm() * piece.perimeter_mm()) {
        append(piece, pieces);
      }
    }
    return Region::from_clean_rings(std::move(pieces));
  }

  // Around stretches of perimeters that are no straight bridges.
  [[nodiscard]] Region perimeters_in_air() const {
    const PointLocation held(below_);
    std::vector<Ring> strips;
    for (int number = 1; number <= std::max(settings_.perimeters, 1); ++number) {
      const Length depth = perimeter_depth(settings_, height_, number);
      const Region lines = offset(local_, depth, kBackTolerance);
      for (const Ring& ring : lines.rings()) {
        add_strips(airborne_stretches(ring, held, settings_), settings_.road_width, strips);
      }
    }
    return clean(strips, FillRule::kPositive);
  }

  const Region& below_;
  Region air_, local_, held_;
  Length height_;
  const Settings& settings_;
};

}  // namespace

HangingRegions hanging_regions(const Region& slice, const Region& below, Length planes,
                               const Settings& settings) {
  HangingRegions found;
  const Length reach = overhang_reach(planes, settings);
  Region air = unheld(slice, below, reach);
  if (air.empty()) return found;
  std::vector<Ring> begun;
  for (const Region& island : islands_in_air(slice, below)) append(island, begun);
  found.islands = Region::from_clean_rings(std::move(begun));
  if (!found.islands.empty()) air = subtract(air, found.islands);
  std::vector<Ring> pieces;
  for (Island& island : islands(air)) {
    const Region piece = region_of(std::move(island));
    if (!is_hair(piece)) append(piece, pieces);
  }
  if (pieces.empty()) return found;
  air = Region::from_clean_rings(std::move(pieces));
  air = BridgeSearch(slice, below, std::move(air), planes, settings).search();
  if (air.empty()) return found;
  // Back to the slice below, and as far aside.
  const Length back = reach * 2;
  const Region near = offset(air, -back, kBackTolerance);
  found.overhangs = intersect(subtract(slice, below), near);
  if (!found.islands.empty()) found.overhangs = subtract(found.overhangs, found.islands);
  return found;
}

}  // namespace core
