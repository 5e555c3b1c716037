#include "core/walls/ball_wall.h"

#include <algorithm>

#include "core/booleans/boolean.h"          // intersect, subtract_within
#include "core/check.h"                     // RIND_CHECK
#include "core/offsets/voronoi_mountain.h"  // offset
#include "core/offsets/wall_depths.h"       // doubled_middle

namespace core {
BallWall::BallWall(Length wall_thickness, Length arc_tolerance)
    : wall_thickness_(wall_thickness), reach_(wall_thickness), arc_tolerance_(arc_tolerance) {
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
  const bool near_bed = reach_.includes_bed(layer.slice);
  const bool all_known = reach_.ends_within(newest, layer.slice);
  if (!near_bed && !all_known && !finished_) return std::nullopt;

  SplitLayer result{layer, layer.slice.region, {}};
  if (!near_bed && all_known && !layer.slice.region.empty()) {
    const std::vector<Operand> wanted = operands();
    std::vector<std::pair<std::int64_t, Length>> key;
    key.reserve(wanted.size());
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
  // How far around what is outside of the last slice visited upwards, and downwards, all is wall.
  Length up, down;
  visit_outwards(window_.size(), pending_, [&](std::size_t number) {
    const Layer& other = window_[number];
    if (!reach_.includes(slice, other.slice)) return false;
    const Length depth = reach_.depth(slice, other.slice);
    if (number == pending_) {
      up = down = depth;
    } else {
      Length& covered = number > pending_ ? up : down;
      covered -= reach_between(number > pending_ ? number - 1 : number + 1, number);
      if (covered >= depth) return true;
      covered = depth;
    }
    found.push_back({other.offsets->content, depth, number});
    return true;
  });
  return found;
}

// How deep what is outside of the farther layer's slice reaches into the nearer one's, at most.
Length BallWall::reach_between(std::size_t nearer, std::size_t farther) const {
  const std::size_t above = std::max(nearer, farther);
  const SliceOffsets& from = *window_[above - 1].offsets;
  const SliceOffsets& to = *window_[above].offsets;
  if (from.content == to.content) return {};
  if (from.content + 1 != to.content) return SliceStep::kUnknown;
  return farther == above ? to.step.inwards : to.step.outwards;
}

// Nearest first: so the rest soon shrinks to what all of them share, and every further intersection
// costs about a slice's edges.
Region BallWall::intersection(const std::vector<Operand>& operands) {
  Region common;
  for (const Operand& operand : operands) {
    const Layer& layer = window_[operand.layer];
    if (layer.slice.region.empty()) return {};
    const std::vector<InnerOffset>& inners = layer.offsets->wall_inners;
    const auto inner = std::find_if(inners.begin(), inners.end(), [&](const InnerOffset& offset) {
      return offset.depth == operand.depth;
    });
    const bool known = inner != inners.end();
    offsets_cut_ += known ? 0 : 1;
    const Region& next =
        known ? inner->region
              : offset(layer.slice.region, operand.depth, arc_tolerance_, ArcForm::kBothSides);
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
