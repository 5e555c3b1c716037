#include "core/slice_offsets.h"

#include <numbers>
#include <utility>

#include "core/offset_contours.h"   // flatten
#include "core/voronoi_mountain.h"  // VoronoiMountain
#include "core/wall_depths.h"       // wall_depths

namespace core {

Length perimeter_spacing(const Settings& settings, Length layer_height) {
  const double void_mm = layer_height.mm() * (1 - std::numbers::pi / 4);
  return Length::from_mm(settings.road_width.mm() - settings.road_overlap * void_mm);
}

Length perimeter_depth(const Settings& settings, Length layer_height, int number) {
  const Length s = perimeter_spacing(settings, layer_height);
  return Length::from_units(settings.road_width.units() / 2) + s * (number - 1);
}

Length narrow_half(const Settings& settings, Length layer_height) {
  return Length::from_mm(kNarrowShare / 2 * perimeter_spacing(settings, layer_height).mm());
}

namespace {

SliceOffsets cut_offsets(const Slice& slice, const Settings& settings, OffsetCounters& counters) {
  SliceOffsets cut;
  if (slice.region.empty()) return cut;
  const VoronoiMountain mountain(slice.region);
  ++counters.mountains;
  counters.retries += mountain.retries();
  const auto at = [&](Length depth) {
    return flatten(mountain.offset(depth), settings.arc_tolerance);
  };
  const Length half_spacing =
      Length::from_units(perimeter_spacing(settings, slice.height).units() / 2);
  const Length half_narrow = narrow_half(settings, slice.height);
  for (const Length depth : wall_depths(settings, slice.height)) {
    cut.wall_inners.push_back({depth, at(depth)});
  }
  Length inner_edge;
  for (int number = 1; number <= settings.perimeters; ++number) {
    const Length depth = perimeter_depth(settings, slice.height, number);
    cut.perimeters.push_back(mountain.offset(depth));
    cut.perimeter_cores.push_back(at(depth + half_narrow));
    inner_edge = depth + half_spacing;
  }
  cut.interior = inner_edge == Length() ? slice.region : at(inner_edge);
  return cut;
}

}  // namespace

std::shared_ptr<const SliceOffsets> OffsetCutter::cut(const Slice& slice) {
  if (last_ && slice.height == last_height_ && slice.region == last_region_) {
    ++counters_.reused;
    return last_;
  }
  auto offsets = std::make_shared<SliceOffsets>(cut_offsets(slice, settings_, counters_));
  offsets->content = last_ ? last_->content + 1 : 0;
  last_region_ = slice.region;
  last_height_ = slice.height;
  last_ = std::move(offsets);
  return last_;
}

}  // namespace core
