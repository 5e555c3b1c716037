#include "core/roads/wall_fill.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/booleans/boolean.h"           // intersect, subtract
#include "core/booleans/simplified.h"        // simplified
#include "core/offsets/polygon_offset.h"     // PolygonOffsetter
#include "core/offsets/slice_offsets.h"      // perimeter_spacing
#include "core/regions/contour_proximity.h"  // stays_near
#include "core/regions/polyline.h"           // length_mm
#include "core/roads/bead_cover.h"           // uncovered
#include "core/roads/gap_fill.h"             // gap_fill_roads
#include "core/roads/line_fill.h"            // LineFill
#include "core/roads/roads_near_core.h"      // roads_near_core
#include "core/roads/row_rests.h"            // row_rests

namespace core {

namespace {

// Rings of a band end where their two sides would be nearer than this share of the spacing.
constexpr double kNarrowShare = 0.6;

// Up to this many roads side by side make a band.
constexpr double kBandRoads = 4;

// Rows are at most this share of a bead's width apart.
constexpr double kRowDistanceMaxWidths = 0.95;

// A ring's two sides are nowhere nearer than so many spacings: they are as wide as that then.
constexpr double kRingShareMin = 0.75;

// Beads of neighbouring rows overlap by this at least.
constexpr double kTouchMm = 0.005;

// What the width may change to make what is laid equal to what the piece holds.
constexpr double kWidthChangeMax = 0.12;

// Pieces thinner than this share of the narrowest road are hairs that beads at either side cover.
constexpr double kHairShare = 0.25;

// What the opening leaves is a band from this many squares of a road on.
constexpr double kBandSquaresMin = 4;

// Rows of pieces of this breadth end at kWideRowEndShare, those of narrow ones at kRowEndShare. The
// notches that it leaves between two joins are as deep as beads at the edge reach.
constexpr double kWideRowEndShare = 0.4;
constexpr double kNarrowRows_mm = 2.5;
constexpr double kWideRows_mm = 5;

// Behind a rim there is room for rows from this breadth on.
constexpr double kBehindRim_mm = 1.5;

// Rests of rows that hold fewer squares of the narrowest road are left to the rows' width.
constexpr double kRestSquaresMin = 1.5;

Length scaled(Length length, double factor) { return Length::from_mm(length.mm() * factor); }

double breadth_mm(const Region& region) { return 2 * region.area_mm2() / region.perimeter_mm(); }

struct SolidStyle {
  RoadKind kind = RoadKind::kSolid;
  SolidPattern pattern = SolidPattern::kRectilinear;
  Length width;
};

class WallFill {
 public:
  WallFill(const SolidStyle& style, const Region& rim, LayerIndex layer, Length height,
           const Settings& settings)
      : style_(style),
        rim_(rim),
        layer_(layer),
        height_(height),
        settings_(settings),
        spacing_(perimeter_spacing(settings, height) + style.width - settings.road_width) {}

  [[nodiscard]] std::vector<Road> fill(const Region& wall) {
    fill_pieces(wall, rim_.empty());
    return std::move(roads_);
  }

 private:
  // `behind_rim`: the rim is filled, or is none.
  void fill_pieces(const Region& wall, bool behind_rim) {
    for (Island& island : islands(wall)) {
      const Region piece = region_of(std::move(island));
      if (breadth_mm(piece) < kHairShare * settings_.road_width_min.mm()) continue;
      fill_piece(piece, behind_rim);
    }
  }

  // The piece's opening is wide; what is left over and worth it are bands.
  void fill_piece(const Region& piece, bool behind_rim) {
    if (style_.pattern == SolidPattern::kConcentric) return fill_band(piece);
    const Length half = scaled(spacing_, kBandRoads / 2);
    const Region middle = inner(piece, half);
    if (middle.empty()) return fill_band(piece);
    // Does the opening leave more than corners? One of more than 60° has the middle within twice
    // its depth.
    if (stays_near(piece, middle, half * 2, half * 2)) return fill_wide(piece, behind_rim);
    // Grown by a hair more than it was shrunk, so that equal edges cancel.
    const Length back = half + settings_.arc_tolerance * 2 + settings_.simplify_tolerance * 2;
    const Region opening = inner(simplified(middle, settings_.simplify_tolerance), -back);
    std::vector<Ring> bands;
    for (Island& island : islands(subtract(piece, opening))) {
      const Region band = region_of(std::move(island));
      if (band.area_mm2() < kBandSquaresMin * spacing_.mm() * spacing_.mm()) continue;
      if (breadth_mm(band) < settings_.road_width_min.mm() / 2) continue;
      bands.insert(bands.end(), band.rings().begin(), band.rings().end());
      fill_band(band);
    }
    if (bands.empty()) return fill_wide(piece, behind_rim);
    const Region rows = subtract(piece, Region::from_clean_rings(std::move(bands)));
    for (Island& island : islands(rows)) fill_wide(region_of(std::move(island)), behind_rim);
  }

  void fill_wide(const Region& piece, bool behind_rim) {
    if (behind_rim) return fill_rows(piece);
    const Region rim = intersect(piece, rim_);
    if (rim.empty()) return fill_rows(piece);
    const Region rest = subtract(piece, rim);
    if (rest.empty() || breadth_mm(rest) < kBehindRim_mm) return fill_rows(piece);
    fill_pieces(rim, true);
    fill_pieces(rest, true);
  }

  // Outwards for negative depths.
  [[nodiscard]] Region inner(const Region& region, Length depth) {
    return flatten(offsetter_.offset(region, depth), settings_.arc_tolerance);
  }

  // Roads along the edges for as long as there is room for two, and one of its own width in the
  // middle. That gap tapers off into hairs that get no road: the innermost rings, up to a hair
  // wider, close them from both sides.
  void fill_band(const Region& band) {
    const Length distance = ring_distance(band);
    const Length width = style_.width + distance - spacing_;
    const Length half_narrow = scaled(spacing_, kNarrowShare / 2);
    std::vector<Road> rings;
    std::size_t innermost = 0;
    for (Length depth = scaled(distance, 0.5); true; depth += distance) {
      const Region line = inner(band, depth);
      if (line.empty()) break;
      std::vector<Road> ring =
          roads_near_core(line, inner(band, depth + half_narrow), half_narrow * 2, width,
                          style_.kind, settings_.simplify_tolerance);
      if (ring.empty()) break;
      innermost = rings.size();
      std::move(ring.begin(), ring.end(), std::back_inserter(rings));
    }
    if (rings.empty()) return add(gap_fill_roads(band, Length(), height_, settings_));
    const Region gaps = uncovered(band, rings, distance + kBeadSeam);
    std::vector<Road> between = gap_fill_roads(gaps, kBeadSeam, height_, settings_);
    fit(rings, innermost, distance, band, volume_mm3(between));
    add(std::move(rings));
    add(std::move(between));
  }

  // Makes the innermost rings as wide as the rest of what the band holds asks for, where other
  // roads lay `between_mm3` of it. They still touch.
  void fit(std::vector<Road>& rings, std::size_t innermost, Length distance, const Region& band,
           double between_mm3) const {
    double rest_mm3 = band.area_mm2() * height_.mm() - between_mm3;
    double laid_mm = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (i < innermost) {
        rest_mm3 -= core::volume_mm3(rings[i], height_);
      } else {
        laid_mm += length_mm(rings[i]);
      }
    }
    const Length least = distance + Length::from_mm(kTouchMm);
    const Length most = rings.back().width + gap_width_min(settings_);
    const Length fitted = bead_width(std::max(rest_mm3, 0.0) / laid_mm, height_);
    for (std::size_t i = innermost; i < rings.size(); ++i) {
      rings[i].width = std::clamp(fitted, least, most);
    }
  }

  // Where the innermost rings leave too little for one more road, all rings share it.
  [[nodiscard]] Length ring_distance(const Region& band) const {
    const double s = spacing_.mm(), half = breadth_mm(band) / 2;
    const double rings = half >= kRingShareMin * s ? std::max(1.0, std::floor(half / s)) : 0;
    const bool shared = rings >= 1 && half - rings * s < settings_.road_width_min.mm() / 2;
    return shared ? Length::from_mm(half / rings) : spacing_;
  }

  // The depth at which rows end, as a share of their distance.
  [[nodiscard]] double row_end_share(double breadth) const {
    if (settings_.perimeters == 0) return kRowEndShare;
    const double wide = (breadth - kNarrowRows_mm) / (kWideRows_mm - kNarrowRows_mm);
    return std::lerp(kRowEndShare, kWideRowEndShare, std::clamp(wide, 0.0, 1.0));
  }

  // The piece's own row distance; the formula is in the header, p on both sides.
  [[nodiscard]] Length row_distance(double b, double end_share) const {
    const double s = spacing_.mm();
    const double share = s / b * (1 - 2 * end_share);
    const double p = share < 0.5 ? s / (1 - share) : 2 * s;
    const double most = std::max(s, kRowDistanceMaxWidths * style_.width.mm());
    return Length::from_mm(std::min(p, most));
  }

  void fill_rows(const Region& piece) {
    const double breadth = breadth_mm(piece), end_share = row_end_share(breadth);
    const Length distance = row_distance(breadth, end_share);
    const LineFill pattern(settings_.fill_angle_degrees);
    FilledRows rows = pattern.fill({piece, layer_, style_.kind, style_.width, distance,
                                    scaled(distance, end_share), settings_.arc_tolerance,
                                    style_.pattern == SolidPattern::kMonotonic});
    const RowStrips grid{RowTurn(pattern.angle_degrees(layer_)),
                         static_cast<double>(distance.units()),
                         static_cast<double>(style_.width.units()) / 2};
    const double narrowest = settings_.road_width_min.mm();
    const Region gaps =
        row_rests(piece, rows.stretches, grid, kRestSquaresMin * narrowest * narrowest);
    std::vector<Road> between = gap_fill_roads(gaps, Length(), height_, settings_);
    double laid_mm = 0;
    for (const Road& row : rows.roads) laid_mm += length_mm(row);
    if (laid_mm > 0) {
      const double holds_mm3 = piece.area_mm2() * height_.mm() - volume_mm3(between);
      const double w = style_.width.mm();
      const double least = std::max(w * (1 - kWidthChangeMax), distance.mm() + kTouchMm);
      const double width = bead_width(std::max(holds_mm3, 0.0) / laid_mm, height_).mm();
      const Length fitted = Length::from_mm(std::clamp(width, least, w * (1 + kWidthChangeMax)));
      const double most_mm3 = kRowsMost * holds_mm3;
      if (style_.pattern == SolidPattern::kRectilinear &&
          laid_mm * bead_area_mm2(fitted, height_) > most_mm3) {
        return fill_band(piece);
      }
      for (Road& row : rows.roads) row.width = fitted;
    }
    add(std::move(rows.roads));
    add(std::move(between));
  }

  [[nodiscard]] double volume_mm3(const std::vector<Road>& roads) const {
    double sum = 0;
    for (const Road& road : roads) sum += core::volume_mm3(road, height_);
    return sum;
  }

  void add(std::vector<Road> roads) {
    roads_.insert(roads_.end(), std::make_move_iterator(roads.begin()),
                  std::make_move_iterator(roads.end()));
  }

  SolidStyle style_;
  const Region& rim_;
  LayerIndex layer_;
  Length height_;
  const Settings& settings_;
  Length spacing_;
  PolygonOffsetter offsetter_;
  std::vector<Road> roads_;
};

}  // namespace

std::vector<Road> wall_roads(const Region& wall, const Region& rim, LayerIndex layer, Length height,
                             const Settings& settings) {
  if (wall.empty()) return {};
  const SolidStyle style{RoadKind::kSolid, settings.solid_pattern, settings.road_width};
  return WallFill(style, rim, layer, height, settings).fill(wall);
}

std::vector<Road> surface_roads(const Region& surface, RoadKind kind, LayerIndex layer,
                                Length height, const Settings& settings) {
  if (surface.empty()) return {};
  const bool own_width = kind == RoadKind::kTopSolid && settings.top_width > Length();
  const SolidStyle style{kind, settings.top_pattern,
                         own_width ? settings.top_width : settings.road_width};
  std::vector<Road> roads = WallFill(style, {}, layer, height, settings).fill(surface);
  if (kind != RoadKind::kTopSolid || settings.top_flow == 1) return roads;
  const auto flowing = [&](Length width) {
    return bead_width(settings.top_flow * bead_area_mm2(width, height), height);
  };
  for (Road& road : roads) {
    road.width = flowing(road.width);
    for (Length& width : road.widths) width = flowing(width);
  }
  return roads;
}

std::vector<Road> ironing_roads(const Region& top, LayerIndex layer, Length height,
                                const Settings& settings) {
  if (top.empty()) return {};
  const Length spacing = settings.ironing_spacing;
  const double area_mm2 = settings.ironing_flow * height.mm() * spacing.mm();
  const Length width = bead_width(area_mm2, height);
  const Length inset = Length::from_units(settings.nozzle_diameter.units() / 2);
  return LineFill(settings.fill_angle_degrees)
      .fill({top, layer, RoadKind::kIroning, width, spacing, inset, settings.arc_tolerance, true})
      .roads;
}

}  // namespace core
