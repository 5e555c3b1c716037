#include "core/roads/loose_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "core/booleans/simplified.h"      // simplified
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/offsets/slice_offsets.h"    // perimeter_spacing
#include "core/regions/polyline.h"         // between, distance_units, length_mm
#include "core/roads/boundary_joins.h"     // join_along_boundary
#include "core/roads/gyroid_pattern.h"     // GyroidPattern
#include "core/roads/honeycomb_pattern.h"  // HoneycombPattern
#include "core/roads/line_clip.h"          // LineClipper
#include "core/roads/straight_pattern.h"   // StraightPattern

namespace core {
namespace {

// Rows' distances are this factor apart, from the one without joins on.
constexpr double kDistanceStep = 1.19;
constexpr int kDistanceSteps = 4;

// What the width may change to make what is laid equal to what was asked for.
constexpr double kWidthMin = 0.75;  // road widths
constexpr double kWidthMax = 1.15;

// Rows farther apart than this are none: patterns reach some cells beyond what they fill.
constexpr double kDistanceMax_mm = 2'000;

// A free end is drawn on over at most this many road distances of the inside.
constexpr double kEndReachDistances = 1.5;

// Null for rings, which are no pattern of the plane.
std::unique_ptr<FillPattern> pattern_of(LoosePattern pattern) {
  using Kind = StraightPattern::Kind;
  switch (pattern) {
    case LoosePattern::kLines:
      return std::make_unique<StraightPattern>(Kind::kLines);
    case LoosePattern::kGrid:
      return std::make_unique<StraightPattern>(Kind::kGrid);
    case LoosePattern::kTriangles:
      return std::make_unique<StraightPattern>(Kind::kTriangles);
    case LoosePattern::kCubic:
      return std::make_unique<StraightPattern>(Kind::kCubic);
    case LoosePattern::kHoneycomb:
      return std::make_unique<HoneycombPattern>();
    case LoosePattern::kGyroid:
      return std::make_unique<GyroidPattern>();
    case LoosePattern::kConcentric:
    case LoosePattern::kLightning:
      break;
  }
  return nullptr;
}

class LooseFill {
 public:
  LooseFill(const Region& within, const Slice& slice, const Settings& settings)
      : slice_(slice),
        settings_(settings),
        spacing_(perimeter_spacing(settings, slice.height)),
        bead_mm_(bead_mm(slice.height)),
        even_bead_mm_(has_unequal_layers(settings) ? bead_mm(settings.layer_height) : bead_mm_),
        pattern_(pattern_of(settings.loose_pattern)),
        room_(within) {}

  void fill(const Region& piece) {
    if (distance(0) > kDistanceMax_mm * kUnitsPerMm) return;
    const Region middle =
        flatten(offsetter_.offset(piece, Length::from_units(spacing_.units() / 2)),
                settings_.arc_tolerance);
    if (middle.empty()) return;
    const double asked_mm = settings_.loose_density * piece.area_mm2() / bead_mm_;
    const LineClipper edge(piece), clipper(middle);
    const auto lay = [&](int step) {
      return pattern_ ? lines(middle.box(), clipper, edge, step) : rings(middle, step);
    };
    int step = first_step(middle, asked_mm);
    Laid best = lay(step);
    const auto take_better = [&](Laid other) {
      if (misfit(other, asked_mm) < misfit(best, asked_mm)) best = std::move(other);
    };
    // How lines happen to meet a small piece is not in the formula.
    for (; best.length_mm * kWidthMax < asked_mm && step > 0; --step) take_better(lay(step - 1));
    for (; best.length_mm * kWidthMin > asked_mm && step < kDistanceSteps; ++step) {
      take_better(lay(step + 1));
    }
    if (best.roads.empty()) return;
    const double area_mm2 = bead_mm_ * slice_.height.mm() * asked_mm / best.length_mm;
    const double width = bead_width(area_mm2, slice_.height).mm(), w = settings_.road_width.mm();
    const Length fitted = Length::from_mm(std::clamp(width, w * kWidthMin, w * kWidthMax));
    for (Road& road : best.roads) {
      road.width = fitted;
      roads_.push_back(std::move(road));
    }
  }

  [[nodiscard]] std::vector<Road> take() { return std::move(roads_); }

 private:
  struct Laid {
    std::vector<Road> roads;
    double length_mm = 0;
  };

  // A bead's area over the layer's height.
  [[nodiscard]] double bead_mm(Length height) const {
    return bead_area_mm2(settings_.road_width, height) / height.mm();
  }

  static double misfit(const Laid& laid, double asked_mm) {
    if (laid.length_mm <= 0) return std::numeric_limits<double>::infinity();
    return std::max(laid.length_mm / asked_mm, asked_mm / laid.length_mm);
  }

  // By the formula in the header.
  [[nodiscard]] int first_step(const Region& middle, double asked_mm) const {
    const double joins_mm = settings_.infill_anchor_max > Length() ? middle.perimeter_mm() / 2 : 0;
    const double rows_mm = asked_mm - joins_mm;
    if (rows_mm <= 0) return kDistanceSteps;
    const double factor = settings_.loose_density / even_bead_mm_ * middle.area_mm2() / rows_mm;
    int step = 0;
    for (double up_to = std::sqrt(kDistanceStep); step < kDistanceSteps && factor > up_to; ++step) {
      up_to *= kDistanceStep;
    }
    return step;
  }

  [[nodiscard]] double distance(int step) const {
    double units = even_bead_mm_ * kUnitsPerMm / settings_.loose_density;
    for (int i = 0; i < step; ++i) units *= kDistanceStep;
    return units;
  }

  // Rings at equal distances, the outermost one along the middle's edge.
  [[nodiscard]] Laid rings(const Region& middle, int step) {
    Laid laid;
    const Length apart = Length::from_units(std::llround(distance(step)));
    for (Length depth; true; depth += apart) {
      const Region inner = flatten(offsetter_.offset(middle, depth), settings_.arc_tolerance);
      if (inner.empty()) return laid;
      for (const Ring& ring : inner.rings()) {
        laid.roads.push_back({RoadKind::kLoose, settings_.road_width, true, ring});
        laid.length_mm += length_mm(ring, true);
      }
    }
  }

  [[nodiscard]] Laid lines(const Box& box, const LineClipper& clipper, const LineClipper& edge,
                           int step) const {
    const PatternPlace place{box,
                             distance(step),
                             static_cast<double>(settings_.road_width.units()),
                             settings_.fill_angle_degrees,
                             slice_.index,
                             slice_.bottom + Length::from_units(slice_.height.units() / 2)};
    std::vector<ClippedLine> clipped;
    for (const std::vector<Point>& line : pattern_->lines(place)) clipper.clip(line, clipped);
    Laid laid;
    JoinedLines joined = join_along_boundary(clipped, clipper, settings_.infill_anchor_max);
    for (std::vector<Point>& points : joined.ways) {
      draw_on(points, edge);
      std::reverse(points.begin(), points.end());
      draw_on(points, edge);
      laid.length_mm += length_mm(points, false);
      laid.roads.push_back({RoadKind::kLoose, settings_.road_width, false, std::move(points)});
    }
    return laid;
  }

  // Draws the last point on, straight: to the inside's edge, and loose_anchor beyond it.
  void draw_on(std::vector<Point>& points, const LineClipper& edge) const {
    const Point end = points.back(), before = points[points.size() - 2];
    const double length = distance_units(before, end);
    if (length == 0) return;
    const auto ahead = [&](double by) { return between(end, before, -by / length); };
    const auto anchor = static_cast<double>(settings_.loose_anchor.units());
    double reach = kEndReachDistances * static_cast<double>(spacing_.units());
    const double to_edge = edge.first_crossing(end, ahead(reach));
    reach = to_edge <= 1 ? to_edge * reach + anchor : reach;
    reach *= std::min(1.0, room_.first_crossing(end, ahead(reach)));
    points.back() = ahead(reach);
  }

  const Slice& slice_;
  const Settings& settings_;
  Length spacing_;
  double bead_mm_;       // what a millimetre of road fills, as an area
  double even_bead_mm_;  // the same in a layer of layer_height, where layers differ in height
  std::unique_ptr<FillPattern> pattern_;
  LineClipper room_;
  PolygonOffsetter offsetter_;
  std::vector<Road> roads_;
};

}  // namespace

bool changes_with_height(LoosePattern pattern) {
  return pattern == LoosePattern::kGyroid || pattern == LoosePattern::kCubic;
}

std::vector<Road> loose_roads(const Region& inside, const Region& within, const Slice& slice,
                              const Settings& settings) {
  if (settings.loose_density <= 0 || inside.empty()) return {};
  LooseFill fill(within, slice, settings);
  for (Island& island : islands(inside)) fill.fill(region_of(std::move(island)));
  return fill.take();
}

}  // namespace core
