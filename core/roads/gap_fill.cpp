#include "core/roads/gap_fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/booleans/simplified.h"     // simplified
#include "core/offsets/polygon_offset.h"  // PolygonOffsetter
#include "core/regions/polyline.h"        // between, distance_mm
#include "core/roads/medial_axis.h"       // medial_axis
#include "core/trigonometry.h"            // hypotenuse
#include "core/vector.h"                  // Vector

namespace core {

namespace {

// Between roads, room down to this share of the narrowest road gets one; it lays more than the room
// holds, by a tenth of a millimetre's width at most. At the part's contour there is no such grace.
constexpr double kRoomMinShare = 0.25;

// Room up to this many road widths gets one road; there is none wider in what rings and rows leave.
constexpr double kRoomMaxWidths = 2;

// A road shorter than this is a blot.
constexpr double kBlobLengthMinMm = 0.1;

// Between roads, a line shorter than this is not worth the travel: mostly a spur into a corner.
constexpr double kLineLengthMinMm = 0.6;

// A blob of fewer squares of the narrowest road is not worth the travel.
constexpr double kBlobSquaresMin = 3;

// Pieces with more corners are no blobs.
constexpr std::size_t kBlobPointsMax = 64;

// Gaps of less area than this many squares of the narrowest road stay empty.
constexpr double kCrumbSquares = 1.5;

// Pieces thinner than this share of the narrowest road, on the whole, are hairs.
constexpr double kHairShare = 0.1;

// Points of a line that move neither it nor its edges by more go.
constexpr Length kLineTolerance = Length::from_units(50);

// Nor by more on either side.
constexpr double kSideShare = 4;

// Pieces worth a road: not thin hairs, not crumbs.
std::vector<Region> pieces_of(const Region& gaps, const Settings& settings) {
  const double narrowest = settings.road_width_min.mm();
  std::vector<Region> kept;
  for (Island& island : islands(simplified(gaps, settings.simplify_tolerance * 4))) {
    std::vector<Ring> rings;
    append_rings(std::move(island), rings);
    // The outer ring last: the lines along the medial axis come in this order.
    std::rotate(rings.begin(), rings.begin() + 1, rings.end());
    Region piece = Region::from_clean_rings(std::move(rings));
    const double area = piece.area_mm2();
    if (area < kCrumbSquares * narrowest * narrowest) continue;
    if (2 * area / piece.perimeter_mm() < kHairShare * narrowest) continue;
    kept.push_back(std::move(piece));
  }
  return kept;
}

// How wide a piece is at most, in steps. Offsets tell it for a small part of an axis's cost, which
// grows with the square of the width that it looks for.
class RoomGauge {
 public:
  RoomGauge(Length narrowest, Length widest)
      : widths_{narrowest, Length::from_mm(widest.mm() / 4), Length::from_mm(widest.mm() / 2)},
        widest_(widest) {
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      depths_[i] = Length::from_units(widths_[i].units() / 2);
    }
  }

  // No place of the piece is wider; nullopt where none is as wide as the narrowest.
  [[nodiscard]] std::optional<Length> width_max(const Region& piece) {
    offsetter_.offset(piece, depths_, offsets_);
    if (offsets_.front().empty()) return std::nullopt;
    for (std::size_t i = 1; i < widths_.size(); ++i) {
      if (offsets_[i].empty()) return widths_[i];
    }
    return widest_;
  }

 private:
  std::array<Length, 3> widths_, depths_;
  Length widest_;
  std::array<OffsetContours, 3> offsets_;
  PolygonOffsetter offsetter_;
};

// Whether the whole line lies in the piece, looked at in nine places.
bool holds(const Region& piece, const Segment& line) {
  for (int i = 0; i <= 8; ++i) {
    if (!piece.contains(between(line.from, line.to, i / 8.0))) return false;
  }
  return true;
}

// A piece as long as it is broad has no axis: a road along its longest diagonal holds what it does.
// A crescent's diagonal would lead out of it.
void add_blob(const Region& piece, Length widest, const Settings& settings,
              std::vector<Road>& roads) {
  Segment longest;
  const Ring& ring = piece.rings().back();
  for (const Point a : ring) {
    for (const Point b : ring) {
      if (distance_mm(a, b) > distance_mm(longest.from, longest.to)) longest = {a, b};
    }
  }
  const double area = piece.area_mm2();
  const double diagonal = distance_mm(longest.from, longest.to);
  const double width = std::clamp(area / diagonal, settings.road_width_min.mm(), widest.mm());
  // Its round ends lie within the piece, too.
  const double length = std::min(area / width, diagonal - width);
  if (length < kBlobLengthMinMm ||
      area < kBlobSquaresMin * settings.road_width_min.mm() * settings.road_width_min.mm()) {
    return;
  }
  const double share = length / diagonal / 2;
  const Segment line{between(longest.from, longest.to, 0.5 - share),
                     between(longest.from, longest.to, 0.5 + share)};
  if (!holds(piece, line)) return;
  roads.push_back({RoadKind::kGapFill, Length::from_mm(width), false, {line.from, line.to}});
}

// How far a point is off a line, and how far the line's edge is then off, on either side.
struct Offset {
  double line = 0, edge = 0;
};

// Point i, against the straight line from `first` to `last`.
Offset off_chord(const ThickPolyline& line, std::size_t first, std::size_t last, std::size_t i) {
  const std::size_t count = line.points.size();
  const Vector a = to_vector(line.points[first]), b = to_vector(line.points[last % count]);
  const Vector chord = b - a, to = to_vector(line.points[i]) - a;
  const double t = share_along(to, chord);
  const Vector off = to - chord * t;
  const double from = static_cast<double>(line.widths[first].units());
  const double until = static_cast<double>(line.widths[last % count].units());
  const double width = from + t * (until - from);
  return {hypotenuse(off.x, off.y),
          std::abs(static_cast<double>(line.widths[i].units()) - width) / 2};
}

// Without the points that change neither the way nor the width by the tolerance
// (Ramer–Douglas–Peucker). The ends stay, and of a closed line its first point.
ThickPolyline simplified(const ThickPolyline& line, Length tolerance) {
  const auto most = static_cast<double>(tolerance.units());
  const std::size_t count = line.points.size();
  std::vector<bool> keep(count + 1, false);
  keep[0] = keep[line.closed ? count : count - 1] = true;
  std::vector<std::pair<std::size_t, std::size_t>> runs = {{0, line.closed ? count : count - 1}};
  while (!runs.empty()) {
    const auto [first, last] = runs.back();
    runs.pop_back();
    double worst = most;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Offset off = off_chord(line, first, last, i);
      const double by = std::max(off.line, off.edge / kSideShare);
      if (by <= worst) continue;
      worst = by;
      at = i;
    }
    if (at == first) continue;
    keep[at] = true;
    runs.emplace_back(first, at);
    runs.emplace_back(at, last);
  }
  ThickPolyline result;
  result.closed = line.closed;
  for (std::size_t i = 0; i < count; ++i) {
    if (!keep[i]) continue;
    result.points.push_back(line.points[i]);
    result.widths.push_back(line.widths[i]);
  }
  return result;
}

// What a line's room holds, as an area.
double room_mm2(const ThickPolyline& line) {
  const std::size_t count = line.points.size();
  double sum = 0;
  for (std::size_t i = 0; i < (line.closed ? count : count - 1); ++i) {
    const std::size_t j = (i + 1) % count;
    sum += distance_mm(line.points[i], line.points[j]) *
           (line.widths[i].mm() + line.widths[j].mm()) / 2;
  }
  return sum;
}

// One road along the line, as wide everywhere as the room is.
void add_road(const ThickPolyline& whole, Length seam, Length height, const Settings& settings,
              std::vector<Road>& roads) {
  const double narrowest = settings.road_width_min.mm();
  if (length_mm(whole.points, whole.closed) < kLineLengthMinMm) return;
  const double room = room_mm2(whole);
  if (room < kCrumbSquares * narrowest * narrowest) return;
  ThickPolyline line = simplified(whole, kLineTolerance);
  if (line.closed && line.points.size() < 3) line = whole;
  // What a bead's round sides need beyond the room.
  const double side = height.mm() * (1 - std::numbers::pi / 4) + seam.mm();
  Road road{RoadKind::kGapFill, {}, line.closed, std::move(line.points), std::move(line.widths)};
  for (Length& width : road.widths) {
    width = Length::from_mm(std::max(width.mm() + side, narrowest));
  }
  road.width = Length::from_mm(std::max(room / length_mm(road) + side, narrowest));
  roads.push_back(std::move(road));
}

}  // namespace

Length gap_width_min(const Settings& settings) {
  return Length::from_mm(kRoomMinShare * settings.road_width_min.mm());
}

std::vector<Road> gap_fill_roads(const Region& gaps, Length seam, Length layer_height,
                                 const Settings& settings) {
  std::vector<Road> roads;
  const Length narrowest = gap_width_min(settings);
  const Length widest = Length::from_mm(kRoomMaxWidths * settings.road_width.mm());
  RoomGauge gauge(narrowest, widest);
  for (const Region& piece : pieces_of(gaps, settings)) {
    const std::optional<Length> width = gauge.width_max(piece);
    if (!width) continue;
    const std::size_t before = roads.size();
    for (const ThickPolyline& line : medial_axis(piece, narrowest, *width)) {
      add_road(line, seam, layer_height, settings, roads);
    }
    if (roads.size() == before && piece.point_count() <= kBlobPointsMax) {
      add_blob(piece, widest, settings, roads);
    }
  }
  return roads;
}

}  // namespace core
