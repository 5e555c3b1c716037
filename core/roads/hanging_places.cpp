#include "core/roads/hanging_places.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/booleans/boolean.h"          // intersect, subtract
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/regions/polyline.h"          // between, distance_mm
#include "core/regions/segment_grid.h"      // SegmentGrid
#include "core/roads/bridge_direction.h"    // best_direction
#include "core/roads/bridge_rows.h"         // BridgeArea, bridge_rows
#include "core/roads/overhang_reach.h"      // overhang_reach
#include "core/roads/unheld.h"              // is_hair, islands_in_air, unheld

namespace core {
namespace {

constexpr DirectionTrials kTrials{2, 4};

// A ledge is narrower than this many roads, and this share of its outline is the slice's contour:
// one of its two sides, less what rounding takes.
constexpr double kLedgeBreadthMaxWidths = 0.5;
constexpr double kLedgeOpenShareMin = 0.4;

// What booleans move a point by, at most.
constexpr Length kOnContour = Length::from_units(3);

Point middle_of(const Box& box) {
  return {static_cast<std::int32_t>((std::int64_t{box.min.x} + box.max.x) / 2),
          static_cast<std::int32_t>((std::int64_t{box.min.y} + box.max.y) / 2)};
}

class HangingSearch {
 public:
  HangingSearch(const SplitLayer& layer, const Settings& settings)
      : slice_(layer.slice.region),
        below_(*layer.below),
        supports_(layer.support_below.get()),
        settings_(settings) {
    const Length planes = Length::from_units((layer.slice.height + layer.below_height).units() / 2);
    reach_ = overhang_reach(planes, settings);
  }

  [[nodiscard]] HangingPlaces search() {
    Region air = unheld(slice_, below_, reach_);
    if (air.empty()) return {};
    const Region held = over_supports();
    find_islands(held, air);
    if (!held.empty()) air = subtract(air, held);
    std::vector<Ring> pieces;
    for (Island& island : islands(air)) {
      const Region piece = region_of(std::move(island));
      if (is_hair(piece) || (!held.empty() && is_crumb(piece))) continue;
      if (is_ledge(piece)) {
        found_.push_back({HangingKind::kOverhang, piece.rings().front().front(), piece.area_mm2()});
      } else {
        pieces.insert(pieces.end(), piece.rings().begin(), piece.rings().end());
      }
    }
    if (!pieces.empty()) find_places(Region::from_clean_rings(std::move(pieces)));
    std::stable_sort(found_.begin(), found_.end(),
                     [](const HangingPlace& a, const HangingPlace& b) {
                       return a.kind != b.kind ? a.kind < b.kind : a.size > b.size;
                     });
    HangingPlaces result;
    for (const HangingPlace& place : found_) {
      std::int64_t& count = result.counts[static_cast<std::size_t>(place.kind)];
      if (count++ < static_cast<std::int64_t>(kHangingPlacesMax)) result.largest.push_back(place);
    }
    return result;
  }

 private:
  // Whether it is narrower than a row of a bridge, and open on one side: along the slice's contour.
  [[nodiscard]] bool is_ledge(const Region& piece) {
    const double perimeter = piece.perimeter_mm();
    const double breadth = 2 * piece.area_mm2() / perimeter;
    if (breadth > kLedgeBreadthMaxWidths * settings_.road_width.mm()) return false;
    if (!contour_) contour_.emplace(Length::from_mm(1), slice_);
    double open = 0;
    for (const Segment& edge : edges_of(piece.rings())) {
      const Point middle = between(edge.from, edge.to, 0.5);
      if (contour_->any_within(middle, kOnContour)) open += distance_mm(edge.from, edge.to);
    }
    return open >= kLedgeOpenShareMin * perimeter;
  }

  // What supports leave beside them.
  [[nodiscard]] bool is_crumb(const Region& piece) const {
    return piece.area_mm2() < settings_.support_area_min_mm2;
  }

  // What supports hold: they keep off the part, and what lies half over one is held.
  [[nodiscard]] Region over_supports() const {
    if (supports_ == nullptr || supports_->empty()) return {};
    const Length beyond = settings_.support_xy_distance + settings_.road_width;
    return offset(*supports_, -beyond, settings_.arc_tolerance * 2);
  }

  // Islands over nothing, and over no support; what is over nothing anyway is no overhang as well.
  void find_islands(const Region& held, Region& air) {
    std::vector<Ring> begun;
    for (const Region& whole : islands_in_air(slice_, below_)) {
      begun.insert(begun.end(), whole.rings().begin(), whole.rings().end());
      if (2 * intersect(whole, held).area_mm2() > whole.area_mm2()) continue;
      found_.push_back({HangingKind::kIsland, middle_of(whole.box()), whole.area_mm2()});
    }
    if (!begun.empty()) air = subtract(air, Region::from_clean_rings(std::move(begun)));
  }

  void find_places(const Region& air) {
    const Length width = settings_.road_width;
    const Length beyond = reach_ + Length::from_mm(width.mm() * 1.5);
    const Length tolerance = settings_.arc_tolerance * 2;
    const Region regions = intersect(offset(air, -beyond, tolerance), slice_);
    const Region held = intersect(below_, offset(air, -(beyond + width), tolerance));
    for (Island& island : islands(regions)) {
      const Region region = region_of(std::move(island));
      const BridgeArea area{region, region, rings_near(held, region.box()), {}, width};
      const BridgeRows rows = bridge_rows(area, best_direction(area, width, kTrials), width);
      if (rows.laid_spans_mm <= rows.cut_spans_mm) {
        add_overhang(intersect(air, region), rows);
      } else if (rows.longest_mm > settings_.bridge_max.mm()) {
        found_.push_back({HangingKind::kSpan, rows.longest_at, rows.longest_mm});
      }
    }
  }

  // A narrow one may lie between two rows.
  void add_overhang(const Region& air, const BridgeRows& rows) {
    if (air.empty()) return;
    const Point at = rows.cut.empty() ? air.rings().front().front() : rows.longest_cut_at;
    found_.push_back({HangingKind::kOverhang, at, air.area_mm2()});
  }

  const Region& slice_;
  const Region& below_;
  const Region* supports_;
  const Settings& settings_;
  Length reach_;
  std::optional<SegmentGrid> contour_;  // of the slice, once asked for
  std::vector<HangingPlace> found_;
};

}  // namespace

HangingPlaces hanging_places(const SplitLayer& layer, const Settings& settings) {
  if (!layer.below) return {};
  return HangingSearch(layer, settings).search();
}

}  // namespace core
