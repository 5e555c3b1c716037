#include "core/booleans/chain_graph.h"

#include <algorithm>

namespace core {
namespace {

// Counter-clockwise from due west; those in the same direction stand together.
class SpokeOrder {
 public:
  explicit SpokeOrder(Point node) : node_(node) {}

  bool operator()(const Spoke& a, const Spoke& b) const {
    const bool a_north = north(a.toward), b_north = north(b.toward);
    if (a_north != b_north) return b_north;
    const std::int64_t turn = cross(node_, a.toward, b.toward);
    if (turn != 0) return turn > 0;
    return a.end < b.end;
  }

 private:
  // East to just before west, as against west to just before east.
  [[nodiscard]] bool north(Point toward) const {
    return toward.y > node_.y || (toward.y == node_.y && toward.x > node_.x);
  }
  Point node_;
};

// Corners after passage `from`, up to passage `to` of the same ring.
std::uint32_t corners_between(const Passage& from, const Passage& to, const ContourRing& ring) {
  std::uint32_t count = to.edge - from.edge;
  if (to.edge < from.edge || (to.edge == from.edge && to.along <= from.along)) {
    count += ring.size();
  }
  return to.along == 0 ? count - 1 : count;
}

}  // namespace

void ChainGraph::build(const ContourEdges& edges, const SnapRounding& snapped) {
  cut_rings(edges, snapped.passages());
  place_spokes(edges, snapped.nodes());
}

void ChainGraph::cut_rings(const ContourEdges& edges, std::span<const Passage> passages) {
  chains_.clear();
  has_chains_.assign(edges.rings().size(), 0);
  for (std::size_t first = 0, end = 0; first < passages.size(); first = end) {
    const std::uint32_t ring_index = edges.ring_index(passages[first].edge);
    const ContourRing& ring = edges.rings()[ring_index];
    has_chains_[ring_index] = 1;
    while (end < passages.size() && passages[end].edge < ring.end) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const Passage &from = passages[i], &to = passages[i + 1 == end ? first : i + 1];
      const EdgeIndex corner = from.edge + 1 == ring.end ? ring.first : from.edge + 1;
      const std::uint32_t corner_count = corners_between(from, to, ring);
      chains_.push_back({from.node, to.node, corner, corner_count, ring_index});
    }
  }
}

void ChainGraph::place_spokes(const ContourEdges& edges, std::span<const Point> nodes) {
  first_spoke_.assign(nodes.size() + 1, 0);
  for (const EdgeChain& chain : chains_) {
    ++first_spoke_[chain.start];
    ++first_spoke_[chain.end];
  }
  std::uint32_t count = 0;
  for (std::uint32_t& first : first_spoke_) first = count += first;
  spokes_.resize(count);
  for (ChainIndex i = 0; i < chains_.size(); ++i) {
    const EdgeChain& chain = chains_[i];
    const std::uint32_t corners = chain.corner_count;
    const Point after = corners > 0 ? corner(chain, edges, 0) : nodes[chain.end];
    const Point before = corners > 0 ? corner(chain, edges, corners - 1) : nodes[chain.start];
    spokes_[--first_spoke_[chain.start]] = {after, 2 * i};
    spokes_[--first_spoke_[chain.end]] = {before, 2 * i + 1};
  }
  for (NodeIndex node = 0; node < nodes.size(); ++node) {
    std::sort(spokes_.begin() + first_spoke_[node], spokes_.begin() + first_spoke_[node + 1],
              SpokeOrder(nodes[node]));
  }
}

}  // namespace core
