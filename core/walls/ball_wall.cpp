#include "core/walls/ball_wall.h"

#include <algorithm>

#include "core/booleans/boolean.h"          // intersect, subtract_within
#include "core/check.h"                     // RIND_CHECK
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/offsets/wall_depths.h"       // ball_depth

namespace core {
namespace {

Length doubled_middle(const Slice& slice) { return slice.bottom * 2 + slice.height; }

// From the mid-plane of one layer to the near face of another; 0 for itself.
Length doubled_distance(const Slice& from, const Slice& to) {
  if (to.index == from.index) return {};
  return to.index > from.index ? to.bottom * 2 - doubled_middle(from)
                               : doubled_middle(from) - to.top() * 2;
}

}  // namespace

BallWall::BallWall(Length wall_thickness, Length arc_tolerance)
    : wall_thickness_(wall_thickness), arc_tolerance_(arc_tolerance) {
  RIND_CHECK(wall_thickness > Length() && arc_tolerance > Length());
}

void BallWall::push(Layer layer) {
  RIND_CHECK(!finished_ && layer.offsets != nullptr);
  window_.push(std::move(layer));
  layers_held_peak_ = std::max(layers_held_peak_, window_.size());
}

std::optional<SplitLayer> BallWall::next() {
  operations_ = 0;
  if (pending_ == window_.size()) return std::nullopt;
  const Layer& layer = window_[pending_];
  const Slice& newest = window_[window_.size() - 1].slice;
  const bool near_bed = doubled_middle(layer.slice) < wall_thickness_ * 2;
  const bool all_known = newest.top() * 2 - doubled_middle(layer.slice) >= wall_thickness_ * 2;
  if (!near_bed && !all_known && !finished_) return std::nullopt;

  SplitLayer result{layer, layer.slice.region, {}};
  if (!near_bed && all_known && !layer.slice.region.empty()) {
    const std::vector<Operand> wanted = operands();
    std::vector<std::pair<std::int64_t, Length>> key;
    for (const Operand& operand : wanted) key.emplace_back(operand.content, operand.depth);
    if (key == last_operands_) {
      ++layers_reused_;
    } else {
      last_loose_ = intersection(wanted);
      // Every loose point is w from the slice's contours.
      last_solid_ = subtract_within(layer.slice.region, last_loose_);
      last_operands_ = std::move(key);
    }
    result.solid = last_solid_;
    result.loose = last_loose_;
  }
  RIND_CHECK(operations_ <= kBallOperationsMax);
  ++pending_;
  forget();
  return result;
}

// From the nearest outwards. The first operand is the layer itself, so that equal keys mean an
// equal slice too.
std::vector<BallWall::Operand> BallWall::operands() const {
  const Slice& slice = window_[pending_].slice;
  std::vector<Operand> found;
  const auto add = [&](std::size_t place) {
    const Layer& other = window_[place];
    const Length distance = doubled_distance(slice, other.slice);
    if (distance >= wall_thickness_ * 2) return false;
    const std::int64_t content = other.offsets->content;
    const Length depth = ball_depth(wall_thickness_, distance);
    const auto equal = std::find_if(found.begin(), found.end(), [&](const Operand& operand) {
      return operand.content == content;
    });
    if (equal == found.end()) {
      found.push_back({content, depth, place});
    } else if (equal->depth < depth) {
      *equal = {content, depth, place};
    }
    return true;
  };
  add(pending_);
  bool up = true, down = true;
  for (std::size_t i = 1; up || down; ++i) {
    up = up && pending_ + i < window_.size() && add(pending_ + i);
    down = down && i <= pending_ && add(pending_ - i);
  }
  return found;
}

// Nearest first: what is left soon is no more than what all of them share, so that every further
// intersection costs about a slice's edges.
Region BallWall::intersection(const std::vector<Operand>& operands) {
  Region common;
  for (const Operand& operand : operands) {
    const Layer& layer = window_[operand.place];
    if (layer.slice.region.empty()) return {};
    const std::vector<InnerOffset>& inners = layer.offsets->wall_inners;
    const auto inner = std::find_if(inners.begin(), inners.end(), [&](const InnerOffset& offset) {
      return offset.depth == operand.depth;
    });
    const bool known = inner != inners.end();
    offsets_cut_ += known ? 0 : 1;
    const Region& next =
        known ? inner->region : offset(layer.slice.region, operand.depth, arc_tolerance_);
    if (&operand == &operands.front()) {
      common = next;
    } else {
      common = intersect(common, next);
      ++operations_;
    }
    if (common.empty()) return {};
  }
  return common;
}

// Layers below that no layer still to be settled can see: it would have to be nearer than the next.
void BallWall::forget() {
  while (pending_ > 0) {
    const bool last = pending_ == window_.size();
    const Length middle =
        last ? window_[pending_ - 1].slice.top() * 2 : doubled_middle(window_[pending_].slice);
    if (middle - window_[0].slice.top() * 2 < wall_thickness_ * 2) return;
    (void)window_.pop();
    --pending_;
  }
}

}  // namespace core
