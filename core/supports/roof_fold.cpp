#include "core/supports/roof_fold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "core/booleans/boolean.h"          // clean, intersect, subtract, unite
#include "core/booleans/simplified.h"       // simplified
#include "core/check.h"                     // RIND_CHECK
#include "core/geometry.h"                  // Box, Ring
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/roads/bridge_direction.h"    // best_direction
#include "core/roads/bridge_rows.h"         // BridgeArea, bridge_rows, rings_near
#include "core/roads/bridges.h"             // kBridgeAnchorWidths, kBridgeTrials
#include "core/roads/unheld.h"              // is_hair
#include "core/supports/support_regions.h"  // scaled
#include "core/trigonometry.h"              // cosine, sine
#include "core/walls/regularise.h"          // regularise_loose

namespace core {
namespace {

// Angles beyond this are taken to be this one.
constexpr double kAngleMaxDegrees = 85;

// How exact offsets are that only say how near something is.
constexpr Length kNearTolerance = Length::from_units(50);

// What rounding may move a contour by, in each of the steps of a growth.
constexpr Length kRounding = Length::from_units(2);

// Lines of branches are not nearer to one another than this, whatever bridge_max is.
constexpr Length kBranchSpacingMin = Length::from_units(10'000);

// Strips are this share of the longest bridge.
constexpr double kStripShare = 0.9;

void append(const Region& region, std::vector<Ring>& rings) {
  rings.insert(rings.end(), region.rings().begin(), region.rings().end());
}

// Never larger than the exact one.
Region grown_by(const Region& region, Length step) {
  if (region.empty()) return {};
  const Length tolerance = std::max(Length::from_units(1), scaled(step, kGrowthLoss / 3));
  const Length by = step - tolerance - kRounding;
  if (by <= Length()) return region;
  return simplified(offset(region, -by, tolerance), tolerance);
}

// Whether the wall alone holds roofs.
bool by_cones(const Settings& settings) { return settings.loose_roof != LooseRoof::kOff; }

bool narrower(const Region& region, Length width) {
  const Length half = Length::from_units(width.units() / 2 + kRounding.units());
  return offset(region, half, kNearTolerance).empty();
}

// What rounding left along common edges is left out.
Region without_hairs(const Region& region) {
  std::vector<Ring> rings;
  for (Island& island : islands(region)) {
    const Region piece = region_of(std::move(island));
    if (!is_hair(piece)) append(piece, rings);
  }
  return Region::from_clean_rings(std::move(rings));
}

bool only_hairs(const Region& region) { return without_hairs(region).empty(); }

// Opening by a disc of this radius takes this much off a corner of 40°; what is larger is none.
bool is_corner_bit(const Region& piece, Length radius) {
  return piece.area_mm2() <= 1.6 * radius.mm() * radius.mm();
}

double hole_area_mm2(const Ring& ring) {
  return -doubled_area_units(ring) / 2 / (kUnitsPerMm * kUnitsPerMm);
}

Ring rectangle(std::int64_t left, std::int64_t right, const Box& box) {
  const auto x0 = static_cast<std::int32_t>(left), x1 = static_cast<std::int32_t>(right);
  return {{x0, box.min.y}, {x1, box.min.y}, {x1, box.max.y}, {x0, box.max.y}};
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a / b - ((a % b != 0 && a < 0) ? 1 : 0);
}

}  // namespace

Length cone_step(const InsideLayer& above, const InsideLayer& below, const Settings& settings) {
  const double degrees = std::min(settings.overhang_angle_degrees, kAngleMaxDegrees);
  const double angle = degrees * std::numbers::pi / 180;
  const std::int64_t doubled =
      2 * (above.bottom - below.bottom).units() + above.height.units() - below.height.units();
  const double planes = static_cast<double>(doubled) / 2;
  const double step = planes * sine(angle) / cosine(angle);
  const double most = kStepWidthsMax * static_cast<double>(settings.road_width.units());
  return Length::from_units(static_cast<std::int64_t>(std::min(step, most)));
}

Length branch_spacing(const Settings& settings) {
  return std::max(kBranchSpacingMin, scaled(settings.bridge_max, kBranchSpacing));
}

Length roof_step(const InsideLayer& above, const InsideLayer& below, const Settings& settings) {
  const Length step = cone_step(above, below, settings);
  return by_cones(settings) ? step : std::max(step, scaled(settings.road_width, kRowReachWidths));
}

RoofFold::RoofFold(const Settings& settings)
    : settings_(settings),
      none_(std::make_shared<const Region>()),
      rib_(scaled(settings.road_width, kRibWidths)),
      irregular_(none_),
      regular_(none_) {}

RoofFold::SharedRegion RoofFold::regular(const SharedRegion& loose) {
  if (loose != irregular_) {
    Region kept = regularise_loose(*loose, regularise_options(settings_));
    regular_ = kept == *loose ? loose : std::make_shared<const Region>(std::move(kept));
    irregular_ = loose;
  }
  return regular_;
}

void RoofFold::push(InsideLayer layer) {
  RIND_CHECK(!ended_ && layer.loose);
  layer.loose = regular(layer.loose);
  levels_.push_back({std::move(layer), nullptr, none_});
}

std::optional<InsideLayer> RoofFold::next() {
  // The layer to be decided is the first one that is not; the one below it has to be known.
  const auto at =
      std::find_if(levels_.begin(), levels_.end(), [](const Level& level) { return !level.loose; });
  if (at == levels_.end()) return std::nullopt;
  const auto below = std::next(at);
  if (below == levels_.end() && !ended_) return std::nullopt;
  Level sky;
  sky.given.loose = sky.loose = sky.waits = none_;
  const bool highest = at == levels_.begin();
  if (highest) {
    sky.given.bottom = at->given.bottom + at->given.height;
    sky.given.height = at->given.height;
  }
  const SharedRegion seed =
      decide(*at, highest ? sky : *std::prev(at), below == levels_.end() ? nullptr : &below->given);
  InsideLayer decided = at->given;
  decided.loose = at->loose;
  decided.seed = seed;
  decided.given = at->given.loose;
  if (!highest) levels_.pop_front();
  return decided;
}

RoofFold::SharedRegion RoofFold::decide(Level& at, const Level& above, const InsideLayer* below) {
  const SharedRegion& given = at.given.loose;
  at.loose = given;
  const bool waited = !above.waits->empty();
  if (given->empty() || (given == above.given.loose && given == above.loose)) return none_;
  const Length step = roof_step(above.given, at.given, settings_);
  const Region solid = subtract(*given, *above.loose);
  if (solid.empty() ||
      (!waited && narrower(solid, std::min(step, Length::from_units(rib_.units() / 2)))))
    return none_;
  const Region grown = grown_by(*above.loose, step);
  Seeds found = seeds(at, above, below, grown);
  at.waits = found.waiting.empty()
                 ? none_
                 : std::make_shared<const Region>(clean(found.waiting, FillRule::kNonZero));
  const Region seed = clean(found.begun, FillRule::kNonZero);
  Region loose = grown.empty() ? grown : intersect(*given, grown);
  if (!loose.empty()) loose = subtract(loose, kept(*above.loose, grown, solid, step));
  loose = regularise_loose(unite(loose, seed), regularise_options(settings_));
  const bool same = given == above.given.loose && only_hairs(exclusive_or(loose, *above.loose));
  at.loose = same ? above.loose : std::make_shared<const Region>(std::move(loose));
  return seed.empty() ? none_ : std::make_shared<const Region>(seed);
}

bool RoofFold::held_by_branches(const Box& box) const {
  if (by_cones(settings_)) return false;
  const std::int64_t spacing = branch_spacing(settings_).units();
  return floor_div(box.max.x, spacing) != floor_div(box.min.x, spacing) ||
         floor_div(box.max.y, spacing) != floor_div(box.min.y, spacing);
}

// What is solid between the hollows above and too thin to shrink by a step on both sides, with
// what of the solid inside is near it.
Region RoofFold::kept(const Region& loose, const Region& grown, const Region& solid,
                      Length step) const {
  const Length radius = Length::from_units(rib_.units() / 2) + step + kNearTolerance;
  const Region few = simplified(loose, kNearTolerance);
  const Region closed = offset(offset(few, -radius, kNearTolerance), radius, kNearTolerance);
  std::vector<Ring> thin, corners;
  for (Island& island : islands(subtract(closed, few))) {
    const Region piece = region_of(std::move(island));
    if (is_hair(piece) || held_by_branches(piece.box())) continue;
    append(piece, is_corner_bit(piece, radius) ? corners : thin);
  }
  if (!corners.empty()) {
    // Tips that would hang farther than twice the step are no corners.
    const Region bits = Region::from_clean_rings(std::move(corners));
    const Region inner = offset(simplified(grown, kNearTolerance), step * 2, kNearTolerance);
    const Region hanging = subtract(intersect(bits, inner), loose);
    for (Island& island : islands(bits)) {
      const Region piece = region_of(std::move(island));
      const Region near = rings_near(hanging, piece.box());
      if (!near.empty() && !intersect(piece, near).empty()) append(piece, thin);
    }
  }
  for (const Ring& ring : loose.rings()) {
    const double area = hole_area_mm2(ring);
    if (held_by_branches(box_of(ring))) continue;
    if (area > 0 && area <= kPillarArea_mm2) thin.emplace_back(ring.rbegin(), ring.rend());
  }
  if (thin.empty()) return {};
  const Region residue = clean(thin, FillRule::kNonZero);
  return intersect(solid, offset(residue, -radius, kNearTolerance));
}

RoofFold::Seeds RoofFold::seeds(const Level& at, const Level& above, const InsideLayer* below,
                                const Region& grown) const {
  Seeds found;
  RegulariseOptions options = regularise_options(settings_);
  options.width_min = std::max(options.width_min, settings_.road_width);
  const SharedRegion& over = above.given.loose;
  const Region passed = above.waits->empty() ? *over : without_hairs(subtract(*over, *above.waits));
  Region wide = regularise_loose(subtract(*at.given.loose, passed), options);
  if (wide.empty()) return found;
  if (!grown.empty()) {
    wide = regularise_loose(subtract(wide, offset(grown, -rib_, kNearTolerance)), options);
  }
  for (Island& island : islands(wide)) {
    place(region_of(std::move(island)), grown, at.given, below, found);
  }
  return found;
}

void RoofFold::place(const Region& roof, const Region& around, const InsideLayer& at,
                     const InsideLayer* below, Seeds& found) const {
  if (!can_be_bridged(roof, around)) {
    append(cut_into_strips(roof), found.begun);
    return;
  }
  if (below) {
    // Where the roof would begin if it waited.
    const Region others = without_hairs(subtract(*at.loose, roof));
    std::vector<Ring> met;
    for (Island& island : islands(subtract(*below->loose, others))) {
      const Region piece = region_of(std::move(island));
      if (!intersect(piece, roof).empty()) append(piece, met);
    }
    const Region later = Region::from_clean_rings(std::move(met));
    const bool whole = !later.empty() && only_hairs(subtract(roof, later));
    const Length step = roof_step(at, *below, settings_);
    if (whole && !narrower(subtract(later, roof), step) && can_be_bridged(later, around)) {
      append(roof, found.waiting);
      return;
    }
  }
  append(roof, found.begun);
}

bool RoofFold::can_be_bridged(const Region& roof, const Region& around) const {
  const Length beyond = scaled(settings_.road_width, kBridgeAnchorWidths);
  Region held = subtract(offset(roof, -(beyond * 2), kNearTolerance), roof);
  if (!around.empty()) held = subtract(held, around);
  const Region all = offset(roof, -beyond, kNearTolerance);
  const BridgeArea area{all, all, held, {}, settings_.road_width};
  const Length apart = settings_.road_width;
  const BridgeRows rows = bridge_rows(area, best_direction(area, apart, kBridgeTrials), apart);
  return rows.cut_spans_mm == 0 && rows.longest_mm <= settings_.bridge_max.mm();
}

// At fixed places of the bed, so that walls stand on walls.
Region RoofFold::cut_into_strips(const Region& roof) const {
  if (!by_cones(settings_)) return roof;  // branches hold it
  const std::int64_t rib = rib_.units();
  const std::int64_t strip = scaled(settings_.bridge_max, kStripShare).units();
  if (strip < settings_.loose_width_min.units() || strip <= 0) return {};
  const std::int64_t pitch = strip + rib;
  const Box box = roof.box();
  std::vector<Ring> ribs;
  for (std::int64_t left = floor_div(box.min.x, pitch) * pitch; left < box.max.x; left += pitch) {
    ribs.push_back(rectangle(left, left + rib, box));
  }
  return subtract(roof, Region::from_clean_rings(std::move(ribs)));
}

}  // namespace core
