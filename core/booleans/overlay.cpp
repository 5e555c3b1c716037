#include "core/booleans/overlay.h"

#include <iterator>

#include "core/check.h"  // RIND_CHECK

namespace core {

// Results of booleans stand in the order of their first points, so that equal rings are found like
// equal words in two sorted lists. Where operands are in another order some are not found, and are
// then treated like any others.
void Overlay::add_in_common(const Region& a, const Region& b) {
  common_a_.assign(a.rings().size(), 0);
  common_b_.assign(b.rings().size(), 0);
  for (std::size_t i = 0, j = 0; i < common_a_.size() && j < common_b_.size();) {
    const Ring &ring = a.rings()[i], &other = b.rings()[j];
    if (ring == other) {
      common_a_[i++] = 1;
      common_b_[j++] = 1;
    } else if (ring_before(other, ring)) {
      ++j;
    } else {
      ++i;
    }
  }
}

Region Overlay::combine(const Region& a, std::int32_t weight_a, const Region& b,
                        std::int32_t weight_b, const WindingRule& rule) {
  add_in_common(a, b);
  edges_.clear();
  for (std::size_t i = 0; i < common_a_.size(); ++i) {
    if (common_a_[i] == 0) edges_.add(a.rings()[i], weight_a, 0);
  }
  for (std::size_t i = 0; i < common_b_.size(); ++i) {
    if (common_b_[i] == 0) edges_.add(b.rings()[i], weight_b, 1);
  }
  weights_.by_operand = {weight_a, weight_b, weight_a + weight_b};
  for (std::size_t i = 0; i < common_a_.size(); ++i) {
    if (common_a_[i] != 0) edges_.add(a.rings()[i], weight_a + weight_b, kOperandInCommon);
  }
  weights_.clean = true;
  return run(rule);
}

Region Overlay::combine(const std::vector<Ring>& rings, const WindingRule& rule) {
  edges_.clear();
  weights_.by_operand.assign(1, 1);
  weights_.clean = false;
  for (const Ring& ring : rings) edges_.add_mended(ring, 1, 0);
  return run(rule);
}

Region Overlay::run(const WindingRule& rule) {
  if (edges_.rings().empty()) return {};
  tree_.build(edges_);
  if (!find_boundary(rule)) {
    ++retries_;
    weights_.clean = false;
    RIND_CHECK(find_boundary(rule));
  }
  found_.clear();
  tracer_.trace(edges_, snapped_, graph_, walk_, found_);
  if (weights_.clean) copy_free_rings(rule, found_);
  sort_rings(found_);
  return Region::from_clean_rings(std::vector<Ring>(std::make_move_iterator(found_.begin()),
                                                    std::make_move_iterator(found_.end())));
}

bool Overlay::find_boundary(const WindingRule& rule) {
  snapped_.run(edges_, tree_, weights_.clean ? Meetings::kAcrossOperands : Meetings::kAll);
  if (!weights_.clean) snapped_.add_node_to_rings_without(edges_);
  graph_.build(edges_, snapped_);
  ray_.reset(edges_, tree_, snapped_, weights_);
  return walk_.run(edges_, snapped_, graph_, ray_, rule, weights_.clean);
}

// A ring without nodes meets no other operand, but may touch other rings of its own.
void Overlay::copy_free_rings(const WindingRule& rule, std::vector<Ring>& rings) {
  for (std::uint32_t i = 0; i < edges_.rings().size(); ++i) {
    if (graph_.has_chains(i)) continue;
    const ContourRing& ring = edges_.rings()[i];
    const std::int32_t right = ray_.winding_right_of(ring.operand, edges_.from(ring.first));
    const bool left_inside = rule.inside(right + ring.weight);
    if (left_inside == rule.inside(right)) continue;
    rings.push_back(canonical_ring(edges_.points() + ring.first, edges_.points() + ring.end,
                                   left_inside ? Turned::kNo : Turned::kYes));
  }
}

}  // namespace core
