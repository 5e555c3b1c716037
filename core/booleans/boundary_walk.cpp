#include "core/booleans/boundary_walk.h"

#include <algorithm>

namespace core {
namespace {

// The node's bundles, counter-clockwise: visit(first chain end, change of winding across it).
template <typename Change, typename Visit>
void for_bundles(std::span<const Spoke> spokes, Change change, Visit visit) {
  for (std::size_t i = 0, j = 0; i < spokes.size(); i = j) {
    std::int32_t sum = 0;
    for (; j < spokes.size() && spokes[j].toward == spokes[i].toward; ++j) {
      sum += change(spokes[j].end);
    }
    visit(spokes[i].end, sum);
  }
}

}  // namespace

// From its right to its left, seen from its node: a ring's left side is its weight above its right.
std::int32_t BoundaryWalk::change_at(const ContourEdges& edges, const ChainGraph& graph,
                                     ChainEnd end) const {
  const std::int32_t weight = edges.rings()[graph.chains()[end / 2].ring].weight;
  return end % 2 == 0 ? weight : -weight;
}

bool BoundaryWalk::run(const ContourEdges& edges, const SnapRounding& snapped,
                       const ChainGraph& graph, WindingRay& ray, const WindingRule& rule,
                       bool operands_clean) {
  pieces_.clear();
  next_.assign(2 * graph.chains().size(), kNoPiece);
  leaving_.assign(graph.node_count(), 0);
  walked_.assign(graph.node_count(), 0);
  known_.clear();
  least_winding_ = 0;
  for (NodeIndex node = 0; node < graph.node_count(); ++node) {
    if (walked_[node] != 0 || graph.spokes(node).empty()) continue;
    if (!operands_clean || !start_at_corner(edges, graph, node, ray)) {
      walk_from(edges, graph, node, ray.winding_at(snapped.nodes()[node]), rule);
    }
    if (!spread(edges, graph, rule)) return false;
  }
  return std::all_of(pieces_.begin(), pieces_.end(),
                     [this](BoundaryPiece piece) { return next_[piece] != kNoPiece; });
}

// From a corner of some chain that starts here and is alone on its course, where the ray ends
// sooner than from a node.
bool BoundaryWalk::start_at_corner(const ContourEdges& edges, const ChainGraph& graph,
                                   NodeIndex node, WindingRay& ray) {
  const std::span<const Spoke> spokes = graph.spokes(node);
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const EdgeChain& chain = graph.chains()[spokes[i].end / 2];
    if (spokes[i].end % 2 != 0 || chain.corner_count == 0) continue;
    if (i > 0 && spokes[i - 1].toward == spokes[i].toward) continue;
    if (i + 1 < spokes.size() && spokes[i + 1].toward == spokes[i].toward) continue;
    const std::uint32_t operand = edges.rings()[chain.ring].operand;
    const Point middle = corner(chain, edges, chain.corner_count / 2);
    known_.push_back({spokes[i].end, ray.winding_right_of(operand, middle)});
    return true;
  }
  return false;
}

bool BoundaryWalk::spread(const ContourEdges& edges, const ChainGraph& graph,
                          const WindingRule& rule) {
  while (!known_.empty()) {
    const Known known = known_.back();
    known_.pop_back();
    const NodeIndex node = graph.node_at(known.end);
    if (walked_[node] != 0) continue;
    // Back from the known side to the sector before the first bundle.
    std::int32_t winding = known.winding;
    bool found = false;
    for_bundles(
        graph.spokes(node), [&](ChainEnd end) { return change_at(edges, graph, end); },
        [&](ChainEnd first, std::int32_t change) {
          found = found || first == known.end;
          if (!found) winding -= change;
        });
    if (!found) return false;
    walk_from(edges, graph, node, winding, rule);
  }
  return true;
}

// winding: of the sector before the first bundle.
void BoundaryWalk::walk_from(const ContourEdges& edges, const ChainGraph& graph, NodeIndex node,
                             std::int32_t winding, const WindingRule& rule) {
  walked_[node] = 1;
  BoundaryPiece last_leaving = kNoPiece, first_coming = kNoPiece;
  for_bundles(
      graph.spokes(node), [&](ChainEnd end) { return change_at(edges, graph, end); },
      [&](ChainEnd first, std::int32_t change) {
        const bool right = rule.inside(winding);
        winding += change;
        least_winding_ = std::min(least_winding_, winding);
        const bool left = rule.inside(winding);
        // From the far end, the left side is the right one.
        known_.push_back({first ^ 1, winding});
        if (left == right) return;
        if (left) {
          last_leaving = first;
          pieces_.push_back(first);
          ++leaving_[node];
        } else if (last_leaving == kNoPiece) {
          first_coming = first ^ 1;
        } else {
          next_[first ^ 1] = last_leaving;
        }
      });
  if (first_coming != kNoPiece) next_[first_coming] = last_leaving;
}

}  // namespace core
