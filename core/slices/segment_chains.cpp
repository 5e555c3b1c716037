#include "core/slices/segment_chains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "core/check.h"             // RIND_DCHECK
#include "core/regions/polyline.h"  // distance_units
#include "core/regions/region.h"    // doubled_area_units

namespace core {
namespace {

using Node = std::uint32_t;

// A segment between numbered points.
struct Link {
  Node from = 0;
  Node to = 0;
  SegmentIndex segment = 0;
  double length_units = 0;
};

std::vector<Point> unique_points(const std::vector<Segment>& segments) {
  std::vector<Point> points;
  points.reserve(2 * segments.size());
  for (const Segment& s : segments) {
    points.push_back(s.from);
    points.push_back(s.to);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Leaves out what is there twice; see the header.
class Links {
 public:
  explicit Links(const std::vector<Segment>& segments) : points_(unique_points(segments)) {
    degree_.assign(points_.size(), 0);
    surplus_.assign(points_.size(), 0);
    links_.reserve(segments.size());
    for (SegmentIndex i = 0; i < segments.size(); ++i) {
      const Segment& s = segments[i];
      if (s.from == s.to) continue;
      links_.push_back({node(s.from), node(s.to), i, distance_units(s.from, s.to)});
    }
    drop_copies();
    drop_reversed_pairs();
  }

  // Rings of segments that were dropped with their reverses, at whose points nothing else is.
  [[nodiscard]] std::vector<Chain> cancelled_rings() const {
    std::vector<std::vector<std::size_t>> at(dropped_.empty() ? 0 : points_.size());
    std::vector<bool> taken(at.size(), false);
    for (std::size_t i = 0; i < dropped_.size(); ++i) {
      at[dropped_[i].from].push_back(i);
      at[dropped_[i].to].push_back(i);
    }
    for (const Link& link : at.empty() ? std::vector<Link>() : links_) {
      taken[link.from] = taken[link.to] = true;
    }
    std::vector<Chain> rings;
    for (const Link& first : dropped_) {
      if (!taken[first.from]) append_ring(first.from, at, taken, rings);
    }
    return rings;
  }

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const std::vector<Link>& links() const { return links_; }
  [[nodiscard]] std::int64_t doubled() const { return doubled_; }

 private:
  [[nodiscard]] Node node(Point point) const {
    const auto found = std::lower_bound(points_.begin(), points_.end(), point);
    return static_cast<Node>(found - points_.begin());
  }

  void drop_copies() {
    std::sort(links_.begin(), links_.end(), [](const Link& a, const Link& b) {
      return std::tie(a.from, a.to, a.segment) < std::tie(b.from, b.to, b.segment);
    });
    const auto first_copy =
        std::unique(links_.begin(), links_.end(),
                    [](const Link& a, const Link& b) { return a.from == b.from && a.to == b.to; });
    doubled_ += links_.end() - first_copy;
    links_.erase(first_copy, links_.end());
    for (const Link& link : links_) {
      ++degree_[link.from];
      ++degree_[link.to];
      ++surplus_[link.from];
      --surplus_[link.to];
    }
  }

  [[nodiscard]] bool has(Node from, Node to) const {
    const auto before = [](const Link& link, std::pair<Node, Node> key) {
      return std::pair(link.from, link.to) < key;
    };
    const auto link = std::lower_bound(links_.begin(), links_.end(), std::pair(from, to), before);
    return link != links_.end() && link->from == from && link->to == to;
  }

  void drop_reversed_pairs() {
    std::vector<Link> kept;
    kept.reserve(links_.size());
    for (const Link& link : links_) {
      if (!has(link.to, link.from)) {
        kept.push_back(link);
        continue;
      }
      const bool one_needed = degree_[link.from] % 2 == 1 && degree_[link.to] % 2 == 1;
      if (!one_needed) {
        if (link.from < link.to) dropped_.push_back(link);
        continue;
      }
      const bool leaves_lack = surplus_[link.from] - surplus_[link.to] < 0;
      const bool balanced = surplus_[link.from] == surplus_[link.to];
      if (leaves_lack || (balanced && link.from < link.to)) {
        kept.push_back(link);
        ++doubled_;
      }
    }
    links_ = std::move(kept);
  }

  // Around from a point where two dropped ones meet, if all others on the way do so too.
  void append_ring(Node start, const std::vector<std::vector<std::size_t>>& at,
                   std::vector<bool>& taken, std::vector<Chain>& rings) const {
    Chain ring;
    Node node = start;
    std::size_t came = dropped_.size();
    do {
      if (taken[node] || at[node].size() != 2) return;
      taken[node] = true;
      const std::size_t next = at[node][0] == came ? at[node][1] : at[node][0];
      ring.points.push_back(points_[node]);
      ring.segments.push_back(dropped_[next].segment);
      node = dropped_[next].from == node ? dropped_[next].to : dropped_[next].from;
      came = next;
    } while (node != start);
    if (doubled_area_units(ring.points) < 0) ring.reverse();
    rings.push_back(std::move(ring));
  }

  std::vector<Point> points_;
  std::vector<Link> links_;
  std::vector<Link> dropped_;  // of each pair that was dropped, the one to the higher point
  std::vector<int> degree_;
  std::vector<int> surplus_;  // links that leave a point, less those that come in
  std::int64_t doubled_ = 0;
};

// Walks along unused links until none is left.
class Walker {
 public:
  explicit Walker(const Links& links)
      : points_(links.points()),
        links_(links.links()),
        used_(links_.size(), false),
        leaving_(points_.size(), links_, &Link::from),
        coming_(points_.size(), links_, &Link::to) {}

  [[nodiscard]] Chains walk_all() {
    Chains chains;
    for (Node node = 0; node < points_.size(); ++node) {
      if ((leaving_.count(node) + coming_.count(node)) % 2 == 0) continue;
      add(walk(node), chains);
    }
    for (const Link& link : links_) add(walk(link.from), chains);
    return chains;
  }

 private:
  // Links by one of their ends; the next unused one of a node in amortised constant time.
  class ByNode {
   public:
    ByNode(std::size_t nodes, const std::vector<Link>& links, Node Link::*end)
        : begin_(nodes + 1, 0), order_(links.size()) {
      for (const Link& link : links) ++begin_[link.*end + 1];
      for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
      next_.assign(begin_.begin(), begin_.end() - 1);
      for (std::size_t i = 0; i < links.size(); ++i) order_[next_[links[i].*end]++] = i;
      next_.assign(begin_.begin(), begin_.end() - 1);
    }
    [[nodiscard]] std::size_t count(Node node) const { return begin_[node + 1] - begin_[node]; }
    [[nodiscard]] std::optional<std::size_t> unused(Node node, const std::vector<bool>& used) {
      std::size_t& next = next_[node];
      while (next < begin_[node + 1] && used[order_[next]]) ++next;
      if (next == begin_[node + 1]) return std::nullopt;
      return order_[next];
    }

   private:
    std::vector<std::size_t> begin_, order_, next_;
  };

  static void add(Chain chain, Chains& chains) {
    if (chain.points.size() < 2) return;
    const bool closed = chain.points.front() == chain.points.back();
    if (closed) chain.points.pop_back();
    RIND_DCHECK(chain.segments.size() == chain.points.size() - (closed ? 0 : 1));
    (closed ? chains.closed : chains.open).push_back(std::move(chain));
  }

  // Goes on in the direction of the segments as long as it can, until it is back or stuck.
  [[nodiscard]] Chain walk(Node start) {
    Chain chain;
    chain.points.push_back(points_[start]);
    const bool closes = (leaving_.count(start) + coming_.count(start)) % 2 == 0;
    bool along = true;
    Node node = start;
    while (true) {
      auto next = (along ? leaving_ : coming_).unused(node, used_);
      if (!next) {
        next = (along ? coming_ : leaving_).unused(node, used_);
        if (!next) break;
        along = !along;
      }
      used_[*next] = true;
      const Link& link = links_[*next];
      Chain::Tally& tally = along ? chain.along : chain.against;
      ++tally.facets;
      tally.length_units += link.length_units;
      node = along ? link.to : link.from;
      chain.points.push_back(points_[node]);
      chain.segments.push_back(link.segment);
      if (closes && node == start) break;
    }
    if (chain.against.length_units > chain.along.length_units) chain.reverse();
    return chain;
  }

  const std::vector<Point>& points_;
  const std::vector<Link>& links_;
  std::vector<bool> used_;
  ByNode leaving_;
  ByNode coming_;
};

// REQUIRES: the chain is closed.
Ring without_points_on_lines(const Chain& chain, const OnOneLine& on_one_line) {
  Ring ring;
  ring.reserve(chain.points.size());
  SegmentIndex before = chain.segments.back();
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    const SegmentIndex after = chain.segments[i];
    const bool gap = before == kNoSegment || after == kNoSegment;
    if (gap || !on_one_line(before, after)) ring.push_back(chain.points[i]);
    before = after;
  }
  return ring;
}

}  // namespace

// Of a closed chain, the last segment stays where it is: it leads to the other end now.
void Chain::reverse() {
  std::reverse(points.begin(), points.end());
  std::reverse(segments.begin(), segments.begin() + static_cast<std::ptrdiff_t>(points.size()) - 1);
  std::swap(along, against);
}

Chains chain_segments(const std::vector<Segment>& segments) {
  const Links links(segments);
  Chains chains = Walker(links).walk_all();
  chains.doubled_facets = links.doubled();
  chains.cancelled = links.cancelled_rings();
  return chains;
}

SliceRings rings_of(const std::vector<Segment>& segments, Length gap_max,
                    const OnOneLine& on_one_line, SliceDefects& defects) {
  Chains chains = chain_segments(segments);
  defects.doubled_facets += chains.doubled_facets;
  if (!chains.open.empty()) {
    std::vector<Chain> closed = closed_across_gaps(std::move(chains.open), gap_max, defects);
    std::move(closed.begin(), closed.end(), std::back_inserter(chains.closed));
  }
  SliceRings result;
  result.rings.reserve(chains.closed.size());
  for (const Chain& chain : chains.closed) {
    defects.flipped_facets += chain.against.facets;
    result.rings.push_back(without_points_on_lines(chain, on_one_line));
  }
  for (const Chain& chain : chains.cancelled) {
    result.cancelled.push_back(without_points_on_lines(chain, on_one_line));
  }
  return result;
}

}  // namespace core
