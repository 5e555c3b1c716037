#include "core/roads/gap_fill.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/booleans/simplified.h"     // simplified
#include "core/offsets/polygon_offset.h"  // PolygonOffsetter
#include "core/regions/polyline.h"        // between, distance_mm
#include "core/roads/bead_cover.h"        // kBeadSeam
#include "core/roads/medial_axis.h"       // medial_axis

namespace core {

namespace {

// Between roads, room down to this share of the narrowest road gets one; it lays more than the room
// holds, by a tenth of a millimetre's width at most. At the part's contour there is no such grace.
constexpr double kRoomMinShare = 0.25;

// Room up to this many road widths gets one road; there is none wider in what rings and rows leave.
constexpr double kRoomMaxWidths = 2;

// A road shorter than this is a blot.
constexpr double kBlobLengthMinMm = 0.1;

// A blob of fewer squares of the narrowest road is not worth the travel.
constexpr double kBlobSquaresMin = 3;

// Pieces with more corners are no blobs.
constexpr std::size_t kBlobPointsMax = 64;

// Gaps of less area than this many squares of the narrowest road stay empty.
constexpr double kCrumbSquares = 1.5;

// Pieces thinner than this share of the narrowest road, on the whole, are hairs.
constexpr double kHairShare = 0.1;

// Pieces worth a road: not thin hairs, not crumbs.
std::vector<Region> pieces_of(const Region& gaps, const Settings& settings) {
  const double narrowest = settings.road_width_min.mm();
  std::vector<Region> kept;
  for (Island& island : islands(simplified(gaps, settings.simplify_tolerance * 2))) {
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

class Cutter {
 public:
  Cutter(GapBoundary edges, Length height, const Settings& settings)
      : settings_(settings), edges_(edges) {
    if (edges == GapBoundary::kRoads)
      side_mm_ = height.mm() * (1 - std::numbers::pi / 4) + kBeadSeam.mm();
  }

  // One road as long as the room stays within kWidthStep, then the next from where it ended.
  void cut(const ThickPolyline& line, std::vector<Road>& roads) {
    const std::size_t count = line.points.size();
    const std::size_t pieces = line.closed ? count : count - 1;
    start(line.points.front());
    for (std::size_t i = 0; i < pieces; ++i) {
      const std::size_t j = (i + 1) % count;
      const double a = line.widths[i].mm(), b = line.widths[j].mm();
      const auto parts = std::max<std::int64_t>(
          1, std::llround(std::ceil(std::abs(a - b) / (kWidthStep / 2 * std::max(a, b)))));
      for (std::int64_t part = 0; part < parts; ++part) {
        const double t0 = static_cast<double>(part) / static_cast<double>(parts);
        const double t1 = static_cast<double>(part + 1) / static_cast<double>(parts);
        add(between(line.points[i], line.points[j], t1), a + (b - a) * t0, a + (b - a) * t1, roads);
      }
    }
    const bool whole = line.closed && points_.front() == line.points.front();
    finish(roads, whole);
  }

 private:
  void start(Point point) {
    points_ = {point};
    low_ = high_ = room_mm2_ = length_mm_ = 0;
  }

  // On to a point, the room changing from a to b.
  void add(Point to, double a, double b, std::vector<Road>& roads) {
    const double low = length_mm_ > 0 ? std::min({low_, a, b}) : std::min(a, b);
    const double high = length_mm_ > 0 ? std::max({high_, a, b}) : std::max(a, b);
    const bool long_enough = length_mm_ >= settings_.road_width.mm();
    if (long_enough && high > low * (1 + kWidthStep)) {
      const Point from = points_.back();
      finish(roads, false);
      start(from);
      low_ = std::min(a, b);
      high_ = std::max(a, b);
    } else {
      low_ = low;
      high_ = high;
    }
    const double mm = distance_mm(points_.back(), to);
    if (mm == 0) return;
    points_.push_back(to);
    length_mm_ += mm;
    room_mm2_ += mm * (a + b) / 2;
  }

  void finish(std::vector<Road>& roads, bool closed) {
    const double narrowest = settings_.road_width_min.mm();
    if (points_.size() < 2 || room_mm2_ < kCrumbSquares * narrowest * narrowest) return;
    // At the part's contour a road is nowhere wider than its room.
    const double room = edges_ == GapBoundary::kPart ? low_ : room_mm2_ / length_mm_;
    const double width = std::max(room + side_mm_, narrowest);
    if (closed && points_.back() == points_.front()) points_.pop_back();
    closed = closed && points_.size() >= 3;
    roads.push_back({RoadKind::kGapFill, Length::from_mm(width), closed, points_});
  }

  const Settings& settings_;
  GapBoundary edges_;
  double side_mm_ = 0;  // what a bead's round sides need beyond the room
  std::vector<Point> points_;
  double low_ = 0;
  double high_ = 0;
  double room_mm2_ = 0;
  double length_mm_ = 0;
};

}  // namespace

Length gap_width_min(const Settings& settings, GapBoundary edges) {
  if (edges == GapBoundary::kPart) return settings.road_width_min - kRoomSlack;
  return Length::from_mm(kRoomMinShare * settings.road_width_min.mm());
}

std::vector<Road> gap_fill_roads(const Region& gaps, GapBoundary edges, Length layer_height,
                                 const Settings& settings) {
  std::vector<Road> roads;
  const Length narrowest = gap_width_min(settings, edges);
  const Length widest = Length::from_mm(kRoomMaxWidths * settings.road_width.mm());
  Cutter cutter(edges, layer_height, settings);
  PolygonOffsetter offsetter;
  for (const Region& piece : pieces_of(gaps, settings)) {
    // An offset tells whether there is room anywhere, for a small part of an axis's cost.
    if (offsetter.offset(piece, Length::from_units(narrowest.units() / 2)).empty()) continue;
    const std::size_t before = roads.size();
    for (const ThickPolyline& line : medial_axis(piece, narrowest, widest)) {
      cutter.cut(line, roads);
    }
    if (roads.size() == before && edges == GapBoundary::kRoads &&
        piece.point_count() <= kBlobPointsMax) {
      add_blob(piece, widest, settings, roads);
    }
  }
  return roads;
}

}  // namespace core
