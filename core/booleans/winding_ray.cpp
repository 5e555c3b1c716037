#include "core/booleans/winding_ray.h"

#include <algorithm>
#include <cstdint>

#include "core/wide_product.h"

namespace core {
namespace {

// Among fewer rings, boxes save less than they cost.
constexpr std::size_t kFewRings = 8;

// 1 for a straight piece that leads south across the ray, -1 for one that leads north.
int turn(Point a, Point b, Point p) {
  if (b.y <= p.y && p.y < a.y) return cross(a, b, p) > 0 ? 1 : 0;
  if (a.y <= p.y && p.y < b.y) return cross(a, b, p) < 0 ? -1 : 0;
  return 0;
}

// For two pieces that lead across the ray at height y: below 0 if the first does so further west,
// 0 if both do at the same point.
int compare_crossings(const Segment& e, const Segment& f, std::int32_t y) {
  const auto crossing = [y](const Segment& s) {
    const std::int64_t sign = s.from.y < s.to.y ? 1 : -1;
    const std::int64_t dx = sign * (std::int64_t{s.to.x} - s.from.x);
    const std::int64_t dy = sign * (std::int64_t{s.to.y} - s.from.y);
    return std::pair(s.from.x * dy + dx * (std::int64_t{y} - s.from.y), dy);
  };
  const auto [e_part, e_whole] = crossing(e);
  const auto [f_part, f_whole] = crossing(f);
  return compare_products(e_part, f_whole, f_part, e_whole);
}

}  // namespace

// As rounding has left the edge.
template <typename Visit>
void WindingRay::for_pieces(EdgeIndex edge, Visit visit) const {
  Point from = edges_->from(edge);
  if (snapped_->bent(edge)) {
    for (const Passage& passage : snapped_->passages_of(edge)) {
      const Point to = snapped_->nodes()[passage.node];
      visit(from, to);
      from = to;
    }
  }
  visit(from, edges_->to(edge));
}

void WindingRay::reset(const ContourEdges& edges, const EdgeTree& tree, const SnapRounding& snapped,
                       const OperandWeights& weights) {
  edges_ = &edges;
  tree_ = &tree;
  snapped_ = &snapped;
  weights_ = &weights;
  seen_.assign(edges.index_end(), 0);
  ray_ = 0;
  few_rings_ = edges.rings().size() <= kFewRings;
  ring_tree_planted_ = false;
  west_ = INT32_MIN;
}

// Boxes are a unit wider than the rings, as rounding moves edges by less.
void WindingRay::plant_ring_tree() {
  const std::span<const ContourRing> rings = edges_->rings();
  ring_tree_planted_ = true;
  ring_tree_.clear();
  ring_boxes_.clear();
  around_.assign(rings.size(), 0);
  for (const ContourRing& ring : rings) {
    Box box;
    for (EdgeIndex e = ring.first; e < ring.end; ++e) box.add(edges_->from(e));
    ring_boxes_.push_back({{box.min.x - 1, box.min.y - 1}, {box.max.x + 1, box.max.y + 1}});
  }
  const auto first_of = [&](std::uint32_t i) { return edges_->from(rings[i].first); };
  for (const std::uint32_t i : order_.near_by_near(rings.size(), first_of)) {
    ring_tree_.add(ring_boxes_[i], i);
  }
  ring_tree_.finish();
}

// Starts a ray. False if no ring goes around the point but those of operand `but`.
bool WindingRay::find_rings_around(Point p, std::uint32_t but) {
  ++ray_;
  if (few_rings_) return true;
  if (!ring_tree_planted_) plant_ring_tree();
  west_ = INT32_MAX;
  ring_tree_.for_items_in({p, p}, [&](std::uint32_t ring) {
    if (edges_->rings()[ring].operand == but) return;
    around_[ring] = ray_;
    west_ = std::min(west_, ring_boxes_[ring].min.x);
  });
  return west_ < INT32_MAX;
}

std::int32_t WindingRay::winding_at(Point p) { return sum_west_of(p, weights_->by_operand); }

std::int32_t WindingRay::sum_west_of(Point p, std::span<const std::int32_t> weights) {
  if (!find_rings_around(p, kNoOperand)) return 0;
  std::int32_t winding = 0;
  tree_->for_edges_in(Box{{west_, p.y}, p}, kNoOperand, [&](EdgeIndex e) {
    if (seen_[e] == ray_ || !may_go_around(e)) return;
    seen_[e] = ray_;
    const int count = turns(e, p);
    if (count != 0) winding += count * weights[edges_->ring(e).operand];
  });
  return winding;
}

std::int32_t WindingRay::winding_right_of(std::uint32_t operand, Point corner) {
  const std::vector<std::int32_t>& weights = weights_->by_operand;
  if (operand == kOperandInCommon) return 0;
  const std::optional<bool> covered = covered_by_other(operand, corner);
  if (covered.has_value()) return *covered ? weights[1 - operand] : 0;
  others_ = weights;
  others_[operand] = 0;
  others_[kOperandInCommon] -= weights[operand];
  return sum_west_of(corner, others_);
}

// Two clean operands: the nearest edge of the other one tells by its direction. Nothing where two
// are equally near: rounding may have laid them on one another.
std::optional<bool> WindingRay::covered_by_other(std::uint32_t operand, Point p) {
  if (!find_rings_around(p, operand)) return false;
  std::optional<EdgeIndex> nearest;
  Segment nearest_edge;
  bool tied = false, folded = false;
  BoxGroup::Query ray(Box{{west_, p.y}, p});
  tree_->for_edges_in(ray, operand, [&](EdgeIndex e) {
    if (e == nearest || !may_go_around(e)) return;
    Segment edge;
    const int count = crossings(e, p, edge);
    if (count == 0) return;
    const int order = nearest.has_value() ? compare_crossings(edge, nearest_edge, p.y) : 1;
    folded = folded || count > 1;
    if (order == 0) tied = true;
    if (order <= 0) return;
    tied = false;
    nearest = e;
    nearest_edge = edge;
    ray = BoxGroup::Query(Box{{std::min(edge.from.x, edge.to.x), p.y}, p});
  });
  if (tied || folded) return std::nullopt;
  return nearest.has_value() && nearest_edge.to.y < nearest_edge.from.y;
}

int WindingRay::turns(EdgeIndex edge, Point p) const {
  int count = 0;
  for_pieces(edge, [&](Point from, Point to) { count += turn(from, to, p); });
  return count;
}

// How often the edge crosses the ray, and the last piece of it that does.
int WindingRay::crossings(EdgeIndex edge, Point p, Segment& piece) const {
  int count = 0;
  for_pieces(edge, [&](Point from, Point to) {
    if (turn(from, to, p) == 0) return;
    ++count;
    piece = {from, to};
  });
  return count;
}

}  // namespace core
