#include "core/roads/perimeters.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/booleans/boolean.h"           // clean
#include "core/offsets/offset_contours.h"    // flatten
#include "core/offsets/polygon_offset.h"     // PolygonOffsetter
#include "core/offsets/slice_offsets.h"      // perimeter_depth, wide_depth
#include "core/regions/contact_check.h"      // surely_clean
#include "core/regions/contour_proximity.h"  // frechet_within
#include "core/regions/simplify.h"           // simplify
#include "core/roads/axis_graph.h"           // AxisGraph
#include "core/roads/bead_counts.h"          // decide_bead_counts
#include "core/roads/bead_lines.h"           // bead_lines
#include "core/roads/bead_roads.h"           // add_bead_road
#include "core/roads/centre_beads.h"         // centre_beads
#include "core/roads/pin_rings.h"            // pin_rings
#include "core/rounded.h"                    // rounded

namespace core {

namespace {

// Contours that touch are parted by this before their axis is sought.
constexpr Length kPartTouching = Length::from_units(5);

// Whether not even the narrowest road fits, by the island's box: its axis may be a single point.
bool is_crumb(const Region& island, const Settings& settings) {
  const Box box = island.box();
  const std::int64_t width = std::int64_t{box.max.x} - box.min.x;
  const std::int64_t depth = std::int64_t{box.max.y} - box.min.y;
  return std::min(width, depth) < (settings.road_width_min - kRoomSlack).units();
}

RoadKind kind_of(int level) {
  return level == 1 ? RoadKind::kOuterPerimeter : RoadKind::kPerimeter;
}

// Whether each line is near the next deeper one: within twice what lies between, as at corners of
// 60° and more.
bool wide_all_over(const IslandOffsets& island, Length height, const Settings& settings) {
  const Region* line = &island.region;
  Length depth;
  for (std::size_t i = 0; i <= island.perimeters.size(); ++i) {
    const bool last = i == island.perimeters.size();
    const Region& deeper = last ? island.wide_core : island.perimeters[i];
    const Length next = last ? wide_depth(settings, height)
                             : perimeter_depth(settings, height, static_cast<int>(i) + 1);
    if (deeper.empty() || !frechet_within(*line, deeper, (next - depth) * 2)) return false;
    line = &deeper;
    depth = next;
  }
  return true;
}

Perimeters of_wide_island(IslandOffsets island, const Settings& settings) {
  Perimeters result;
  for (std::size_t i = 0; i < island.perimeters.size(); ++i) {
    for (const Ring& exact : island.perimeters[i].rings()) {
      Ring ring = simplify(exact, settings.arc_tolerance);
      if (ring.size() < 3) continue;
      result.roads.push_back(
          {kind_of(static_cast<int>(i) + 1), settings.road_width, true, std::move(ring)});
    }
  }
  result.interior = std::move(island.interior);
  return result;
}

// The axis, with beads; nothing where no diagram passes its checks.
std::optional<AxisGraph> beaded_axis(const Region& island, const Beading& beading) {
  std::optional<AxisGraph> graph = AxisGraph::make(island.rings(), beading);
  if (graph) decide_bead_counts(beading, *graph);
  return graph;
}

Region interior_of(const std::vector<BeadLine>& lines) {
  std::vector<Ring> rings;
  for (const BeadLine& line : lines) {
    Ring ring;
    for (const BeadPoint& at : line.points) {
      const Point point = rounded(at.at);
      if (ring.empty() || ring.back() != point) ring.push_back(point);
    }
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
    if (ring.size() >= 3) rings.push_back(std::move(ring));
  }
  if (surely_clean(rings)) return Region::from_clean_rings(std::move(rings));
  return clean(rings, FillRule::kPositive);
}

}  // namespace

Perimeters perimeters(IslandOffsets island, Length height, const Settings& settings) {
  if (is_crumb(island.region, settings)) return {};
  if (auto rings = pin_rings(island.region, height, settings)) return {std::move(*rings), {}};
  if (settings.perimeters == 0 || wide_all_over(island, height, settings)) {
    return of_wide_island(std::move(island), settings);
  }
  const Beading beading(settings, height);
  std::optional<AxisGraph> graph = beaded_axis(island.region, beading);
  std::optional<BeadSpans> spans;
  if (graph) spans.emplace(*graph);
  if (!graph || !spans->sound()) {
    spans.reset();
    graph.reset();
    const Region parted =
        flatten(PolygonOffsetter().offset(island.region, kPartTouching), settings.arc_tolerance);
    graph = beaded_axis(parted, beading);
    if (graph) spans.emplace(*graph);
  }
  if (!graph || !spans->sound()) return of_wide_island(std::move(island), settings);
  const auto tolerance = static_cast<double>(settings.arc_tolerance.units());
  Perimeters result;
  for (int level = 1; level <= settings.perimeters; ++level) {
    for (const BeadLine& line : bead_lines(beading, *graph, *spans, level, tolerance)) {
      add_bead_road(line, beading, kind_of(level), settings.arc_tolerance, result.roads);
    }
  }
  for (const BeadLine& line : centre_beads(beading, *graph)) {
    add_bead_road(line, beading, RoadKind::kGapFill, settings.arc_tolerance, result.roads);
  }
  result.interior =
      interior_of(bead_lines(beading, *graph, *spans, beading.levels(beading.wide()), tolerance));
  return result;
}

}  // namespace core
