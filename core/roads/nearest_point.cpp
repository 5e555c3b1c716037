#include "core/roads/nearest_point.h"

#include <algorithm>
#include <utility>

#include "core/check.h"  // RIND_CHECK

namespace core {

namespace {

constexpr std::uint32_t kLeafPointsMax = 8;

double distance2(Point a, Point b) {
  const double dx = static_cast<double>(a.x) - b.x, dy = static_cast<double>(a.y) - b.y;
  return dx * dx + dy * dy;
}

// No point within is nearer, in floating point, too.
double least_distance2(Point p, const Box& box) {
  return distance2(p,
                   {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)});
}

}  // namespace

NearestPoint::NearestPoint(std::vector<Entry> entries) : entries_(std::move(entries)) {
  if (entries_.empty()) return;
  const auto count = static_cast<std::uint32_t>(entries_.size());
  std::size_t owners = 0;
  for (const Entry& entry : entries_) owners = std::max(owners, entry.owner + 1);
  of_owner_.assign(owners, {0, 0});
  for (std::uint32_t i = 0; i < count; ++i) {
    Range& range = of_owner_[entries_[i].owner];
    if (range.end == 0) range.begin = i;
    range.end = i + 1;
  }
  places_.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) places_.push_back({entries_[i].point, i});
  leaf_of_.resize(count);
  nodes_.reserve(4 * std::size_t{count} / kLeafPointsMax + 1);
  add_node(0, count, 0);
}

void NearestPoint::add_node(std::uint32_t begin, std::uint32_t end, std::uint32_t parent) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node{{}, begin, end - begin, parent, 0};
  for (std::uint32_t i = begin; i < end; ++i) node.box.add(places_[i].point);
  nodes_.push_back(node);
  if (end - begin <= kLeafPointsMax) {
    for (std::uint32_t i = begin; i < end; ++i) leaf_of_[places_[i].entry] = number;
    return;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  const bool wide = std::int64_t{node.box.max.x} - node.box.min.x >=
                    std::int64_t{node.box.max.y} - node.box.min.y;
  const auto at = [this](std::uint32_t i) {
    return places_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  if (wide) {
    std::nth_element(at(begin), at(middle), at(end),
                     [](const Place& a, const Place& b) { return a.point.x < b.point.x; });
  } else {
    std::nth_element(at(begin), at(middle), at(end),
                     [](const Place& a, const Place& b) { return a.point.y < b.point.y; });
  }
  add_node(begin, middle, number);
  nodes_[number].far_side = static_cast<std::uint32_t>(nodes_.size());
  add_node(middle, end, number);
}

void NearestPoint::remove_owner(std::size_t owner) {
  RIND_CHECK(owner < of_owner_.size());
  for (std::uint32_t i = of_owner_[owner].begin; i < of_owner_[owner].end; ++i) {
    if (entries_[i].owner != owner) continue;
    std::uint32_t number = leaf_of_[i];
    Node& leaf = nodes_[number];
    const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(leaf.begin);
    const auto found = std::find_if(begin, begin + static_cast<std::ptrdiff_t>(leaf.left),
                                    [i](const Place& place) { return place.entry == i; });
    std::swap(*found, *(begin + static_cast<std::ptrdiff_t>(leaf.left) - 1));
    for (;; number = nodes_[number].parent) {
      --nodes_[number].left;
      if (number == 0) break;
    }
  }
  of_owner_[owner] = {0, 0};
}

std::optional<NearestPoint::Entry> NearestPoint::nearest(Point to) const {
  if (nodes_.empty() || nodes_.front().left == 0) return std::nullopt;
  Best best;
  look(0, to, best);
  return entries_[*best.entry];
}

void NearestPoint::look(std::uint32_t number, Point to, Best& best) const {
  const Node& node = nodes_[number];
  if (node.far_side == 0) {
    for (std::uint32_t at = node.begin; at < node.begin + node.left; ++at) {
      const std::uint32_t i = places_[at].entry;
      const double d2 = distance2(places_[at].point, to);
      const bool farther =
          best.entry && (d2 > best.distance2 || (d2 == best.distance2 && i > *best.entry));
      if (!farther) best = {i, d2};
    }
    return;
  }
  std::pair<double, std::uint32_t> sides[2];
  std::size_t count = 0;
  for (const std::uint32_t side : {number + 1, node.far_side}) {
    if (nodes_[side].left > 0) sides[count++] = {least_distance2(to, nodes_[side].box), side};
  }
  if (count == 2 && sides[1] < sides[0]) std::swap(sides[0], sides[1]);
  for (std::size_t i = 0; i < count; ++i) {
    // One that is equally near counts, if it came first.
    if (!best.entry || sides[i].first <= best.distance2) look(sides[i].second, to, best);
  }
}

}  // namespace core
