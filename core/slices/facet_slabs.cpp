#include "core/slices/facet_slabs.h"

#include <algorithm>
#include <utility>

#include "core/booleans/boolean.h"       // clean
#include "core/slices/plane_crossing.h"  // is_above, plane_crossing

namespace core {
namespace {

// The facet between two planes, seen from above; at most five corners.
Ring piece_between(const Triangle& facet, std::int64_t doubled_low, std::int64_t doubled_high) {
  Ring ring;
  const auto add = [&ring](Point at) {
    if (ring.empty() || ring.back() != at) ring.push_back(at);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& a = facet.corners[i];
    const Vertex& b = facet.corners[(i + 1) % 3];
    const bool over_low = is_above(a, doubled_low), over_high = is_above(a, doubled_high);
    if (over_low && !over_high) add({a.x, a.y});
    const bool crosses_low = over_low != is_above(b, doubled_low);
    const bool crosses_high = over_high != is_above(b, doubled_high);
    if (crosses_low && !over_low) add(plane_crossing(a, b, doubled_low));
    if (crosses_high) add(plane_crossing(a, b, doubled_high));
    if (crosses_low && over_low) add(plane_crossing(a, b, doubled_low));
  }
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() < 3) return {};
  const double doubled_area = doubled_area_units(ring);
  if (doubled_area == 0) return {};
  if (doubled_area < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace

FacetSlabs::FacetSlabs(LayerHeights heights, FacetSource source)
    : heights_(std::move(heights)), source_(std::move(source)) {}

Status FacetSlabs::take_facets_below(std::int64_t doubled_z) {
  while (!source_ended_) {
    if (!waiting_) {
      Result<std::optional<Triangle>> facet = source_();
      if (!facet.ok()) return facet.error();
      waiting_ = facet.value();
      source_ended_ = !waiting_;
    }
    if (!waiting_ || 2 * waiting_->lowest_z() >= doubled_z) break;
    held_.push_back(*waiting_);
    waiting_.reset();
  }
  return {};
}

Result<Region> FacetSlabs::next() {
  const LayerIndex index = next_index_++;
  const std::int64_t low = std::exchange(below_, heights_.doubled_plane(index)), high = below_;
  if (Status taken = take_facets_below(high); !taken.ok()) return taken.error();
  std::erase_if(held_, [&](const Triangle& facet) {
    return 2 * facet.highest_z() < (index == 0 ? high : low);
  });
  if (index == 0 || held_.empty()) return Region();
  std::vector<Ring> pieces;
  for (const Triangle& facet : held_) {
    Ring piece = piece_between(facet, low, high);
    if (!piece.empty()) pieces.push_back(std::move(piece));
  }
  return clean(pieces, FillRule::kPositive);
}

}  // namespace core
