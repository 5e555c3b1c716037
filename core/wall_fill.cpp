#include "core/wall_fill.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/bead_cover.h"        // bead_cover
#include "core/boolean.h"           // subtract
#include "core/line_fill.h"         // LineFill
#include "core/perimeters.h"        // roads_near_core
#include "core/polyline.h"          // length_mm
#include "core/rest_fill.h"         // rest_roads
#include "core/slice_offsets.h"     // narrow_half, perimeter_spacing
#include "core/voronoi_mountain.h"  // VoronoiMountain

namespace core {

namespace {

// Up to this many roads side by side make a band.
constexpr double kBandRoads = 3;

// Depth below the edge at which rows end, as a share of their distance; half would lay exactly what
// joined rows need, and leave notches between two joins.
constexpr double kRowEndShare = 0.25;

// Rows are at most this share of a bead's width apart.
constexpr double kRowDistanceMaxWidths = 0.97;

// What the width may change to make what is laid equal to what the piece holds.
constexpr double kWidthChangeMax = 0.12;

// Beads overlap by this much where they are taken from a region: rounding leaves no hairs.
constexpr Length kSeam = Length::from_units(100);

// A band smaller than this many squares of a road, or thinner than half the narrowest one, stays
// with its neighbour.
constexpr double kBandSquaresMin = 4;

Length scaled(Length length, double factor) { return Length::from_mm(length.mm() * factor); }

Region region_of(Island island) {
  std::vector<Ring> rings = {std::move(island.outer)};
  rings.insert(rings.end(), std::make_move_iterator(island.holes.begin()),
               std::make_move_iterator(island.holes.end()));
  return Region::from_clean_rings(std::move(rings));
}

double breadth_mm(const Region& region) { return 2 * region.area_mm2() / region.perimeter_mm(); }

Length width_of_area(double area_mm2, Length height) {
  const double h = height.mm();
  return Length::from_mm(area_mm2 / h + h * (1 - std::numbers::pi / 4));
}

class WallFill {
 public:
  WallFill(LayerIndex layer, Length height, const Settings& settings)
      : layer_(layer),
        height_(height),
        settings_(settings),
        spacing_(perimeter_spacing(settings, height)) {}

  [[nodiscard]] std::vector<Road> fill(const Region& wall) {
    split(wall);
    for (Island& piece : islands(wide_)) fill_rows(region_of(std::move(piece)));
    if (!bands_.empty()) fill_bands();
    return std::move(roads_);
  }

 private:
  // The wall's opening, grown by a hair more than it was shrunk, is wide; what is left over and
  // worth it are bands.
  void split(const Region& wall) {
    const Length half = scaled(spacing_, kBandRoads / 2);
    const Region middle = offset(wall, half, settings_.arc_tolerance);
    if (middle.empty()) {
      bands_ = wall;
      return;
    }
    const Length back = half + settings_.arc_tolerance * 2;
    const Region narrow = subtract(wall, offset(middle, -back, settings_.arc_tolerance));
    std::vector<Ring> rings;
    for (Island& island : islands(narrow)) {
      const Region piece = region_of(std::move(island));
      if (piece.area_mm2() < kBandSquaresMin * spacing_.mm() * spacing_.mm()) continue;
      if (breadth_mm(piece) < settings_.road_width_min.mm() / 2) continue;
      rings.insert(rings.end(), piece.rings().begin(), piece.rings().end());
    }
    bands_ = Region::from_clean_rings(std::move(rings));
    wide_ = subtract(wall, bands_);
  }

  void fill_bands() {
    const VoronoiMountain mountain(bands_);
    const auto at = [&](Length depth) {
      return flatten(mountain.offset(depth), settings_.arc_tolerance);
    };
    const Length half = scaled(spacing_, 0.5);
    const Length half_narrow = narrow_half(settings_, height_);
    const std::vector<Road> rings = roads_near_core(
        at(half), at(half + half_narrow), half_narrow * 2, settings_.road_width, RoadKind::kSolid);
    add(rings);
    add(rest_roads(subtract(bands_, bead_cover(rings, spacing_ + kSeam)), RestEdges::kRoads,
                   height_, settings_));
  }

  // The piece's own row distance; the formula is in the header, p on both sides.
  [[nodiscard]] Length row_distance(const Region& piece) const {
    const double s = spacing_.mm(), b = breadth_mm(piece);
    const double share = s / b * (1 - 2 * kRowEndShare);
    const double p = share < 0.5 ? s / (1 - share) : 2 * s;
    const double most = std::max(s, kRowDistanceMaxWidths * settings_.road_width.mm());
    return Length::from_mm(std::min(p, most));
  }

  void fill_rows(const Region& piece) {
    const Length distance = row_distance(piece);
    const Region within = offset(piece, scaled(distance, kRowEndShare), settings_.arc_tolerance);
    const LineFill pattern(settings_.fill_angle_degrees, LineFill::Joins::kNearEnds);
    std::vector<Road> rows = pattern.fill(
        {within, within, layer_, RoadKind::kSolid, settings_.road_width, distance, Length()});
    const Length covered = std::max(distance, settings_.road_width);
    const Region rest = subtract(piece, bead_cover(rows, covered));
    double laid_mm = 0;
    for (const Road& row : rows) laid_mm += length_mm(row);
    if (laid_mm > 0) {
      const double holds_mm2 = piece.area_mm2() - rest.area_mm2();
      const double w = settings_.road_width.mm();
      const double width = width_of_area(holds_mm2 * height_.mm() / laid_mm, height_).mm();
      const Length fitted =
          Length::from_mm(std::clamp(width, w * (1 - kWidthChangeMax), w * (1 + kWidthChangeMax)));
      for (Road& row : rows) row.width = fitted;
    }
    add(std::move(rows));
    add(rest_roads(rest, RestEdges::kRoads, height_, settings_));
  }

  void add(std::vector<Road> roads) {
    roads_.insert(roads_.end(), std::make_move_iterator(roads.begin()),
                  std::make_move_iterator(roads.end()));
  }

  LayerIndex layer_;
  Length height_;
  const Settings& settings_;
  Length spacing_;
  Region wide_;
  Region bands_;
  std::vector<Road> roads_;
};

}  // namespace

std::vector<Road> wall_roads(const Region& wall, LayerIndex layer, Length height,
                             const Settings& settings) {
  if (wall.empty()) return {};
  return WallFill(layer, height, settings).fill(wall);
}

}  // namespace core
