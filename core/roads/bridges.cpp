#include "core/roads/bridges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/booleans/boolean.h"          // clean, intersect, subtract, unite
#include "core/offsets/slice_offsets.h"     // perimeter_depth, perimeter_spacing
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/regions/point_location.h"    // PointLocation
#include "core/roads/bridge_direction.h"    // best_direction
#include "core/roads/bridge_rows.h"         // bridge_rows
#include "core/roads/hollow_ends.h"         // has_hollow_inside
#include "core/roads/unheld.h"              // unheld
#include "core/trigonometry.h"              // cosine, sine

namespace core {
namespace {

// Over the loose inside, strips narrower than this many roads are filled like the rest.
constexpr double kOverLooseRoadsMin = 4;
// Over a hollow inside there is nothing else to hold them.
constexpr double kOverHollowRoadsMin = 1.5;

// Rows over the loose inside overlap by this at least.
constexpr Length kTouch = Length::from_units(50);

Length scaled(Length length, double factor) { return Length::from_mm(length.mm() * factor); }

Region grown(const Region& region, Length by, const Settings& settings) {
  return offset(region, -by, settings.arc_tolerance * 2);
}

// Holes of the slice whose contour hangs in the air, with the perimeters round them.
Region holes_in_air(const BridgeSite& site, const Region& around, const Settings& settings) {
  std::vector<Ring> holes;
  const Box box = around.box();
  const PointLocation below(site.below);
  for (const Ring& ring : site.slice.rings()) {
    if (doubled_area_units(ring) > 0 || !box.overlaps(box_of(ring))) continue;
    const bool held =
        std::any_of(ring.begin(), ring.end(), [&](Point p) { return below.contains(p); });
    if (held) continue;
    holes.emplace_back(ring.rbegin(), ring.rend());
  }
  if (holes.empty()) return {};
  const Length band =
      perimeter_depth(settings, site.height, settings.perimeters) + settings.road_width;
  return grown(clean(holes, FillRule::kNonZero), band, settings);
}

class BridgePlanner {
 public:
  BridgePlanner(const BridgeSite& site, Region wall, const Settings& settings)
      : site_(site),
        settings_(settings),
        width_(settings.road_width),
        anchor_(scaled(width_, kBridgeAnchorWidths)) {
    result_.rest = std::move(wall);
  }

  [[nodiscard]] Bridges plan() {
    over_air();
    over_loose();
    return std::move(result_);
  }

 private:
  void over_air() {
    std::vector<Ring> covered;
    for (const AirBridge& bridge : air_bridges(site_, result_.rest, settings_)) {
      if (bridge.holds()) lay(bridge.rows, bridge.area, RoadKind::kBridge, air_width(), covered);
    }
    take(std::move(covered));
  }

  void over_loose() {
    if (site_.below_loose.empty() || result_.rest.empty()) return;
    const Region over = intersect(result_.rest, site_.below_loose);
    const bool hollow = has_hollow_inside(settings_);
    const Length half = scaled(width_, (hollow ? kOverHollowRoadsMin : kOverLooseRoadsMin) / 2);
    const Region core = over.empty() ? over : offset(over, half, settings_.arc_tolerance);
    if (core.empty()) return;
    const Length distance = perimeter_spacing(settings_, site_.height);
    const Region region = intersect(grown(core, half + anchor_, settings_), result_.rest);
    const Region around = grown(core, half + anchor_ * 2 + width_, settings_);
    const Region room = intersect(site_.room, around), held = intersect(site_.below, around);
    const bool by_walls = hollow && !has_pattern(settings_);
    Region walls = subtract(held, site_.below_loose);
    if (site_.branches != nullptr) walls = unite(walls, intersect(*site_.branches, around));
    std::vector<Ring> covered;
    for (Island& island : islands(region)) {
      const Region piece = region_of(std::move(island));
      const Box box = piece.box();
      const Region here = rings_near(room, box);
      const Vector direction =
          direction_over_loose({piece, here, rings_near(walls, box), {}, width_}, distance);
      const BridgeArea area{piece, here, rings_near(by_walls ? walls : held, box), {}, width_};
      const BridgeRows rows = bridge_rows(area, direction, distance);
      if (rows.rows.empty()) continue;
      const std::size_t first = result_.roads.size();
      const double cover_mm2 = lay(rows, area, RoadKind::kInternalBridge, flat_width(), covered);
      fit(first, cover_mm2, distance);
    }
    take(std::move(covered));
  }

  // Across the loose roads below, unless the walls below are nearer to one another than they are.
  [[nodiscard]] Vector direction_over_loose(const BridgeArea& walls, Length distance) const {
    const double turned = settings_.fill_angle_degrees + (site_.layer % 2 == 0 ? 0 : 90);
    const double angle = turned * std::numbers::pi / 180;
    const Vector across{cosine(angle), sine(angle)};
    const double density = has_pattern(settings_) ? settings_.loose_density : 0;
    // In no direction is the mean chord shorter than 2 · area / perimeter (Cauchy, Crofton).
    const double shortest_mm =
        2 * walls.region.area_mm2() / walls.region.perimeter_mm() - 2 * anchor_.mm();
    if (density > 0 && shortest_mm >= distance.mm() / density) return across;
    const Vector shortest = best_direction(walls, distance, kBridgeTrials);
    if (density <= 0) return shortest;
    const BridgeRows rows = bridge_rows(walls, shortest, distance);
    const double mean_mm = rows.laid_spans_mm > 0 ? rows.laid_squares_mm2 / rows.laid_spans_mm : 0;
    const bool walls_hold = rows.laid_spans_mm > 0 && rows.cut_spans_mm == 0;
    return walls_hold && mean_mm < distance.mm() / density ? shortest : across;
  }

  [[nodiscard]] Length air_width() const { return bridge_width(settings_, site_.height); }

  // A flat road of the flow that the user wants.
  [[nodiscard]] Length flat_width() const {
    const double area = settings_.internal_bridge_flow * bead_area_mm2(width_, site_.height);
    return std::max(bead_width(area, site_.height), site_.height);
  }

  // Returns the area that the roads cover.
  double lay(const BridgeRows& rows, const BridgeArea& area, RoadKind kind, Length width,
             std::vector<Ring>& covered) {
    for (std::vector<Point>& line : joined(rows, area)) {
      line.erase(std::unique(line.begin(), line.end()), line.end());
      if (line.size() >= 2) result_.roads.push_back({kind, width, false, std::move(line)});
    }
    const Region cover = covered_by(rows, area);
    covered.insert(covered.end(), cover.rings().begin(), cover.rings().end());
    return cover.area_mm2();
  }

  // Flat rows and their joins, from the road `first` on, lay together what rows without joins
  // would, as far as they still touch.
  void fit(std::size_t first, double cover_mm2, Length distance) {
    double laid_mm = 0;
    for (std::size_t i = first; i < result_.roads.size(); ++i) {
      laid_mm += length_mm(result_.roads[i]);
    }
    const Length flat = flat_width(), touching = std::min(flat, distance + kTouch);
    if (laid_mm == 0) return;
    const double rows_mm = cover_mm2 / distance.mm();
    const double area_mm2 = bead_area_mm2(flat, site_.height) * rows_mm / laid_mm;
    const Length width = std::clamp(bead_width(area_mm2, site_.height), touching, flat);
    for (std::size_t i = first; i < result_.roads.size(); ++i) result_.roads[i].width = width;
  }

  void take(std::vector<Ring> covered) {
    if (covered.empty()) return;
    result_.rest = subtract(result_.rest, Region::from_clean_rings(std::move(covered)));
  }

  const BridgeSite& site_;
  const Settings& settings_;
  Length width_;
  Length anchor_;
  Bridges result_;
};

}  // namespace

Length bridge_width(const Settings& settings, Length height) {
  const double area = settings.bridge_flow * bead_area_mm2(settings.road_width, height);
  return Length::from_mm(std::sqrt(4 * area / std::numbers::pi));
}

std::vector<AirBridge> air_bridges(const BridgeSite& site, const Region& wall,
                                   const Settings& settings) {
  std::vector<AirBridge> found;
  const Length width = settings.road_width, anchor = scaled(width, kBridgeAnchorWidths);
  const Length reach = scaled(width, kBridgeReachWidths);
  const Region air = intersect(unheld(site.slice, site.below, reach), wall);
  if (air.empty()) return found;
  const Length half = scaled(width, 0.5);
  const Region core = offset(air, half, settings.arc_tolerance);
  if (core.empty()) return found;
  const Length diameter = bridge_width(settings, site.height);
  const Region region = intersect(grown(core, half + reach + anchor, settings), wall);
  const Region around = grown(core, half + reach + anchor * 2 + width, settings);
  const Region room = intersect(site.room, around), held = intersect(site.below, around);
  const Region holes = holes_in_air(site, around, settings);
  for (Island& island : islands(region)) {
    const Region piece = region_of(std::move(island));
    const Box box = piece.box();
    BridgeArea area{piece, rings_near(room, box), rings_near(held, box), rings_near(holes, box),
                    width};
    BridgeRows rows = bridge_rows(area, best_direction(area, diameter, kBridgeTrials), diameter);
    found.push_back({std::move(area), std::move(rows)});
  }
  return found;
}

Bridges bridges(const BridgeSite& site, Region wall, const Settings& settings) {
  return BridgePlanner(site, std::move(wall), settings).plan();
}

}  // namespace core
