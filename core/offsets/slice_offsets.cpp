#include "core/offsets/slice_offsets.h"

#include <numbers>
#include <utility>
#include <vector>

#include "core/offsets/offset_contours.h"  // flatten
#include "core/offsets/polygon_offset.h"   // PolygonOffsetter
#include "core/offsets/slice_step.h"       // slice_step
#include "core/offsets/wall_depths.h"      // wall_depths
#include "core/regions/ring_corners.h"     // kCornerArm

namespace core {
namespace {

// The wall's depths at which neighbours are likely to need the slice (ball_wall.h): those that are
// less below the one before than contours move, in the step to this slice, and likely in the next.
std::vector<Length> likely_depths(const std::vector<Length>& all, Length step) {
  std::vector<Length> depths(all.begin(), all.begin() + 1);
  for (std::size_t i = 1; i < all.size() && all[i - 1] - all[i] < step; ++i) {
    depths.push_back(all[i]);
  }
  return depths;
}

}  // namespace

Length perimeter_spacing(const Settings& settings, Length layer_height) {
  const double void_mm = layer_height.mm() * (1 - std::numbers::pi / 4);
  return Length::from_mm(settings.road_width.mm() - settings.road_overlap * void_mm);
}

Length perimeter_depth(const Settings& settings, Length layer_height, int number) {
  const Length s = perimeter_spacing(settings, layer_height);
  return Length::from_units(settings.road_width.units() / 2) + s * (number - 1);
}

Length wide_depth(const Settings& settings, Length layer_height) {
  return perimeter_depth(settings, layer_height, settings.perimeters + 1);
}

std::int64_t OffsetCutter::fill(const Slice& slice, SliceOffsets& cut) const {
  if (slice.region.empty()) return 0;
  const Settings& settings = slice.index == 0 ? first_settings_ : settings_;
  thread_local PolygonOffsetter offsetter;
  const Length half_spacing =
      Length::from_units(perimeter_spacing(settings, slice.height).units() / 2);
  const std::vector<Length> walls =
      likely_depths(wall_depths(settings, slice.height), cut.step.longest());
  // The wall's depths; the perimeters' centre lines; where places are wide; the interior's.
  std::vector<Length> depths = walls;
  // Without perimeters, rows that end kRowEndShare below the interior's edge stay within the part.
  Length inner_edge = Length::from_mm(
      settings.road_width.mm() / 2 - kRowEndShare * perimeter_spacing(settings, slice.height).mm());
  for (int number = 1; number <= settings.perimeters; ++number) {
    const Length depth = perimeter_depth(settings, slice.height, number);
    depths.push_back(depth);
    inner_edge = depth + half_spacing;
  }
  depths.push_back(wide_depth(settings, slice.height));
  depths.push_back(inner_edge);
  thread_local std::vector<OffsetContours> contours;
  contours.resize(depths.size());
  const std::int64_t tries_before = offsetter.retries() + offsetter.fallbacks();
  offsetter.offset(slice.region, depths, contours);

  const auto flat = [&](const OffsetContours& at) {
    return flatten(at, settings.arc_tolerance, ArcForm::kBothSides);
  };
  for (std::size_t i = 0; i < walls.size(); ++i) {
    cut.wall_inners.push_back({walls[i], flat(contours[i])});
  }
  for (std::size_t i = walls.size(); i + 2 < contours.size(); ++i) {
    cut.perimeters.push_back(std::move(contours[i]));
  }
  cut.wide_core = flat(contours[contours.size() - 2]);
  cut.interior = flat(contours.back());
  if (settings_.seam == SeamPosition::kAligned) {
    cut.corners = std::make_shared<const CornerIndex>(slice.region, kCornerArm);
  }
  return offsetter.retries() + offsetter.fallbacks() - tries_before;
}

OffsetCutter::Reservation OffsetCutter::reserve(const Slice& slice) {
  const Length width = (slice.index == 0 ? first_settings_ : settings_).road_width;
  if (last_ && slice.height == last_height_ && width == last_width_ &&
      slice.region == last_region_) {
    ++reused_;
    return {last_, false};
  }
  auto offsets = std::make_shared<SliceOffsets>();
  offsets->content = last_ ? last_->content + 1 : 0;
  if (last_ && !wall_counts_layers(settings_)) {
    const std::vector<Length> walls = wall_depths(settings_, slice.height);
    const Length small = walls.size() > 2 ? walls[1] - walls[2] : settings_.wall_thickness;
    offsets->step = slice_step(last_region_, slice.region, small, settings_.wall_thickness);
  }
  last_region_ = slice.region;
  last_height_ = slice.height;
  last_width_ = width;
  last_ = std::move(offsets);
  return {last_, true};
}

std::shared_ptr<const SliceOffsets> OffsetCutter::cut(const Slice& slice) {
  Reservation at = reserve(slice);
  if (at.to_fill) static_cast<void>(fill(slice, *at.offsets));
  return at.offsets;
}

}  // namespace core
