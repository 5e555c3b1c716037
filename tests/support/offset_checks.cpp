#include "tests/support/offset_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/booleans/boolean.h"
#include "core/limits.h"
#include "core/offsets/voronoi_mountain.h"
#include "core/regions/contact_check.h"
#include "core/regions/segment_grid.h"
#include "tests/support/boolean_case.h"
#include "tests/support/region_checks.h"

namespace test {
namespace {

using core::Length;
using core::OffsetContour;
using core::OffsetContours;
using core::OffsetPiece;
using core::Point;
using core::PolygonOffsetter;
using core::Region;
using core::Ring;

// Of pieces: an end is rounded to the grid, and the depth was nudged: sqrt(1/2) and a little.
constexpr double kEnd = 0.75;

double units(Length length) { return static_cast<double>(length.units()); }

// The middle of an arc of at most half a turn, of the true radius.
std::pair<double, double> middle_of_arc(const OffsetPiece& piece, Point to, double radius) {
  const double ax = piece.from.x - piece.centre.x, ay = piece.from.y - piece.centre.y;
  const double bx = to.x - piece.centre.x, by = to.y - piece.centre.y;
  double x = ax + bx, y = ay + by;
  if (std::hypot(x, y) < radius / 16) {  // nearly half a turn: across the chord
    const bool left = piece.kind == OffsetPiece::Kind::kArcClockwise;
    x = left ? ay - by : by - ay;
    y = left ? bx - ax : ax - bx;
  }
  const double scale = radius / std::hypot(x, y);
  return {piece.centre.x + x * scale, piece.centre.y + y * scale};
}

// From the corners and the middles of the edges of one to the contours of the other.
double farthest_from(const Region& region, const Region& from) {
  double farthest = 0;
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      farthest = std::max(farthest, distance_to_boundary(from.rings(), a.x, a.y));
      farthest = std::max(farthest, distance_to_boundary(from.rings(), 0.5 * a.x + 0.5 * b.x,
                                                         0.5 * a.y + 0.5 * b.y));
    }
  }
  return farthest;
}

const double kBound = kOffsetRoundingUnits + units(kArcTolerance);

// The same as a question, for large regions.
bool all_within_bound(const Region& region, const Region& from) {
  const Length reach = Length::from_units(static_cast<std::int64_t>(kBound));
  const core::SegmentGrid grid(reach * 8, from);
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const Point middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2};
      if (!grid.any_within(a, reach)) return false;
      if (!grid.any_within(middle, reach + Length::from_units(1))) return false;
    }
  }
  return true;
}

bool near_enough(const Region& ours, const Region& theirs, OffsetComparison& comparison) {
  if (ours.empty() || theirs.empty()) return ours.empty() && theirs.empty();
  constexpr std::size_t kSmallPoints = 300;
  if (ours.point_count() > kSmallPoints) {
    return all_within_bound(ours, theirs) && all_within_bound(theirs, ours);
  }
  const double distance = std::max(farthest_from(ours, theirs), farthest_from(theirs, ours));
  if (distance > kBound) return false;
  comparison.farthest = std::max(comparison.farthest, distance);
  return true;
}

std::string check_one(const Region& ours, const core::VoronoiMountain& diagram, Length depth,
                      OffsetComparison& comparison) {
  // What keeps clear of itself is clean; the rest is looked at edge by edge.
  if (!core::surely_clean(ours.rings()) && !is_clean(ours)) return "the offset is not clean";
  ++comparison.compared;
  if (near_enough(ours, core::flatten(diagram.offset(depth), kArcTolerance), comparison)) return {};
  ++comparison.critical;
  const Length away = Length::from_units(static_cast<std::int64_t>(kBound));
  const Region deeper = core::flatten(diagram.offset(depth + away), kArcTolerance);
  const Region shallower = core::flatten(diagram.offset(depth - away), kArcTolerance);
  if (!core::subtract(deeper, ours).empty()) return "the offset lacks what is deep enough";
  if (!core::subtract(ours, shallower).empty()) return "the offset has what is not deep enough";
  return {};
}

}  // namespace

double worst_depth_error(const Region& region, Length depth, const OffsetContours& contours) {
  double worst = 0;
  const auto measure = [&](double x, double y) {
    const double error = signed_distance(region, x, y) - units(depth);
    worst = std::max(worst, std::abs(error));
  };
  for (const OffsetContour& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const OffsetPiece& piece = contour[i];
      const Point to = contour[(i + 1) % contour.size()].from;
      measure(piece.from.x, piece.from.y);
      if (piece.kind == OffsetPiece::Kind::kLine) {
        measure((double{1} * piece.from.x + to.x) / 2, (double{1} * piece.from.y + to.y) / 2);
      } else if (std::hypot(piece.from.x - to.x, piece.from.y - to.y) > 4) {
        const auto [x, y] = middle_of_arc(piece, to, std::abs(units(depth)));
        measure(x, y);
      }
    }
  }
  return worst;
}

int misjudged_points(const Region& region, Length depth, const Region& result, Random& random,
                     int samples, Length tolerance) {
  const core::Box box = region.box();
  const double margin = std::abs(units(depth)) + 10;
  const double slack = units(tolerance) + kOffsetRoundingUnits;
  int wrong = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = random.between(box.min.x - margin, box.max.x + margin);
    const double y = random.between(box.min.y - margin, box.max.y + margin);
    const double height = signed_distance(region, x, y) - units(depth);
    if (std::abs(height) < slack) continue;
    if (winding_number(result.rings(), x, y) != (height > 0 ? 1 : 0)) ++wrong;
  }
  return wrong;
}

Length random_grid_depth(Random& random, int scale) {
  const int steps = random.integer(1, 14);
  const double depth =
      random.integer(0, 2) > 0 ? steps * scale / 4.0 : std::sqrt(steps) * scale / 2;
  const int sign = random.integer(0, 2) == 0 ? -1 : 1;
  return Length::from_units(sign * std::max(1L, std::lround(depth)));
}

std::string check_against_diagram(PolygonOffsetter& offsetter, const Region& region,
                                  std::span<const Length> depths, OffsetComparison& comparison) {
  const core::VoronoiMountain diagram(region);
  std::vector<OffsetContours> out(depths.size());
  offsetter.offset(region, depths, out);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const Region ours = core::flatten(out[i], kArcTolerance);
    const std::string wrong = check_one(ours, diagram, depths[i], comparison);
    if (!wrong.empty()) return wrong + " at " + std::to_string(depths[i].units());
  }
  return {};
}

std::string check_offset_case(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2) return {};
  const BooleanCase input = boolean_case(bytes.subspan(1));
  const Region region = core::clean(input.rings[0], input.rule);
  // Quarters of the grid, and a unit beside them.
  const int steps = bytes[0] % 32 + 1, beside = bytes[0] / 32 % 4 - 1;
  const std::int64_t whole = std::int64_t{steps} * input.scale / 4 + (beside == 2 ? 0 : beside);
  const std::int64_t limit = core::kCoordinateMax / 4;
  const Length depth =
      Length::from_units((bytes[0] & 0x80 ? -1 : 1) * std::clamp<std::int64_t>(whole, 1, limit));
  const Length depths[] = {depth, Length::from_units(depth.units() / 2), depth * 2};
  PolygonOffsetter offsetter;
  OffsetContours out[3];
  offsetter.offset(region, depths, out);
  Random random(1);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string at = " at " + std::to_string(depths[i].units());
    if (depths[i] != Length() && worst_depth_error(region, depths[i], out[i]) > kEnd) {
      return "a piece is not at its depth" + at;
    }
    // Not too many chords for tests that look at each pair.
    const Length tolerance =
        Length::from_units(std::max<std::int64_t>(25, std::abs(depths[i].units()) / 500));
    const Region result = core::flatten(out[i], tolerance);
    if (!is_clean(result)) return "the offset is not clean" + at;
    if (!region.empty() && misjudged_points(region, depths[i], result, random, 30, tolerance) > 0) {
      return "the offset misjudges a point" + at;
    }
    const Region alone = core::flatten(PolygonOffsetter().offset(region, depths[i]), tolerance);
    if (widest_difference(alone, result) > kOffsetRoundingUnits) {
      return "three depths together give something else" + at;
    }
  }
  return offsetter.fallbacks() > 0 ? "the whole diagram had to be asked" : "";
}

}  // namespace test
