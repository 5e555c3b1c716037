#include "core/walls/wall_reach.h"

#include <cstdlib>

#include "core/offsets/wall_depths.h"  // ball_depth, doubled_distance, doubled_middle

namespace core {

WallReach::WallReach(const Settings& settings)
    : wall_thickness_(settings.wall_thickness),
      layers_(wall_counts_layers(settings) ? wall_layers(settings) : 0) {}

bool WallReach::includes(const Slice& from, const Slice& to) const {
  if (layers_ > 0) return std::abs(to.index - from.index) <= layers_;
  return doubled_distance(from, to) < wall_thickness_ * 2;
}

bool WallReach::includes_bed(const Slice& from) const {
  return layers_ > 0 ? from.index < layers_ : doubled_middle(from) < wall_thickness_ * 2;
}

bool WallReach::ends_within(const Slice& newest, const Slice& from) const {
  return layers_ > 0 ? newest.index - from.index >= layers_
                     : newest.top() * 2 - doubled_middle(from) >= wall_thickness_ * 2;
}

Length WallReach::depth(const Slice& from, const Slice& to) const {
  return layers_ > 0 ? wall_thickness_ : ball_depth(wall_thickness_, doubled_distance(from, to));
}

}  // namespace core
