#include "core/roads/line_fill.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/check.h"                    // RIND_CHECK
#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/regions/polyline.h"         // distance_units
#include "core/roads/boundary_joins.h"     // join_along_boundary
#include "core/roads/line_clip.h"          // LineClipper
#include "core/roads/monotonic_joins.h"    // join_monotonic
#include "core/roads/row_turn.h"           // RowTurn
#include "core/roads/straight_pattern.h"   // rows_over

namespace core {

namespace {

// Stretches shorter than this share of the road's width are left for gap fill.
constexpr double kStretchMinWidths = 0.5;

// A join is at most this many row distances long: enough for an edge at 10° to the rows.
constexpr double kJoinMaxDistances = 6;

Region inner(const FillArea& area) {
  if (area.inset <= Length()) return area.region;
  return flatten(PolygonOffsetter().offset(area.region, area.inset), area.tolerance);
}

// Ends whose rest their join covers: the join leads outwards along the edge.
void mark_covered(const std::vector<std::size_t>& joined, std::vector<RowStretch>& stretches) {
  const auto at = [&](std::size_t end) {
    const RowStretch& stretch = stretches[end / 2];
    return end % 2 == 0 ? stretch.from : stretch.to;
  };
  for (std::size_t end = 0; end < joined.size(); ++end) {
    if (joined[end] == kNotJoined) continue;
    const bool lower = end % 2 == 0;
    const bool outwards = lower ? at(joined[end]) < at(end) : at(joined[end]) > at(end);
    RowStretch& stretch = stretches[end / 2];
    if (outwards) (lower ? stretch.from_covered : stretch.to_covered) = true;
  }
}

}  // namespace

FilledRows LineFill::fill(const FillArea& area) const {
  RIND_CHECK(area.distance > Length());
  FilledRows filled;
  const Region within = inner(area);
  if (within.empty()) return filled;
  const double angle = angle_degrees(area.layer);
  const RowTurn turn(angle);
  const auto distance = static_cast<double>(area.distance.units());
  const double shortest = kStretchMinWidths * static_cast<double>(area.width.units());
  const LineClipper clipper(within);
  std::vector<ClippedLine> lines;
  for (const PatternRow& row : rows_over(within.box(), angle, distance, 0)) {
    std::size_t kept = lines.size();
    clipper.clip({row.line.from, row.line.to}, lines);
    for (std::size_t i = kept; i < lines.size(); ++i) {
      const Point from = lines[i].points.front(), to = lines[i].points.back();
      if (distance_units(from, to) < shortest) continue;
      filled.stretches.push_back({row.number, turn.to_rows(from)[0], turn.to_rows(to)[0]});
      if (i != kept) lines[kept] = std::move(lines[i]);
      ++kept;
    }
    lines.resize(kept);
  }
  const Length longest =
      area.joined ? Length::from_mm(area.distance.mm() * kJoinMaxDistances) : Length();
  JoinedLines joined = area.monotonic ? join_monotonic(lines, filled.stretches, clipper, longest)
                                      : join_along_boundary(lines, clipper, longest);
  mark_covered(joined.partners, filled.stretches);
  for (std::vector<Point>& points : joined.ways) {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) continue;
    filled.roads.push_back({area.kind, area.width, false, std::move(points)});
  }
  return filled;
}

}  // namespace core
