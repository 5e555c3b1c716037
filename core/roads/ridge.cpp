#include "core/roads/ridge.h"

#include <algorithm>
#include <cmath>

#include "core/trigonometry.h"  // hypotenuse

namespace core {
namespace {

// A vertex lower than this, in units, lies on the contour.
constexpr double kOnContour = 0.25;

}  // namespace

Ridge::Ridge(const VoronoiDiagram& diagram, double open_height)
    : diagram_(diagram), open_height_(open_height) {
  reach_.reserve(diagram.vertices.size());
  for (const VoronoiVertex& vertex : diagram.vertices) reach_.push_back(std::abs(vertex.height));
  left_.assign(diagram.edges.size(), 0);
  degree_.assign(diagram.vertices.size(), 0);
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    const std::uint32_t to = diagram.to(i);
    if (!edge.primary || edge.from == VoronoiEdge::kInfinity || to == VoronoiEdge::kInfinity) {
      continue;
    }
    const double a = diagram.vertices[edge.from].height, b = diagram.vertices[to].height;
    if (std::max(a, b) <= kOnContour) continue;
    left_[i] = 1;
    ++degree_[edge.from];
  }
  starts_.assign(1, 0);
  starts_.reserve(degree_.size() + 1);
  for (const std::uint32_t degree : degree_) starts_.push_back(starts_.back() + degree);
  leaving_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    if (left_[i] != 0) leaving_[next[diagram.edges[i].from]++] = i;
  }
}

bool Ridge::on_contour(std::uint32_t vertex) const {
  return diagram_.vertices[vertex].height <= kOnContour;
}

bool Ridge::is_open(std::uint32_t vertex) const {
  return diagram_.vertices[vertex].height >= open_height_;
}

bool Ridge::is_end(std::uint32_t vertex) const {
  return (degree_[vertex] == 1 && !is_open(vertex)) || on_contour(vertex);
}

double Ridge::length(std::uint32_t edge) const {
  const VoronoiVertex& a = diagram_.vertices[diagram_.edges[edge].from];
  const VoronoiVertex& b = diagram_.vertices[diagram_.to(edge)];
  return hypotenuse(b.x - a.x, b.y - a.y);
}

template <typename Visit>
void Ridge::for_leaving(std::uint32_t vertex, const Visit& visit) const {
  for (std::uint32_t i = starts_[vertex]; i < starts_[vertex + 1]; ++i) {
    if (left_[leaving_[i]] != 0) visit(leaving_[i]);
  }
}

// REQUIRES: two edges are left there.
std::uint32_t Ridge::only_other(std::uint32_t vertex, std::uint32_t edge) const {
  std::uint32_t other = edge;
  for_leaving(vertex, [&](std::uint32_t half) { other = half != edge ? half : other; });
  return other;
}

// Whether the branch still widens as a corner does, on along this edge.
void Ridge::widen(Branch& branch, std::uint32_t edge, const CornerRule& rule) const {
  const double first = diagram_.vertices[diagram_.edges[edge].from].height;
  const double last = diagram_.vertices[diagram_.to(edge)].height;
  const double start = branch.reach, end = branch.reach + length(edge);
  const auto add = [&](double reach, double radius) {
    const double beyond = reach - radius * rule.reach;
    branch.least = std::min(branch.least, beyond);
    if (beyond - branch.least > rule.flat_max) branch.corner = false;
  };
  if ((first < rule.radius_min) != (last < rule.radius_min)) {
    add(start + (end - start) * (rule.radius_min - first) / (last - first), rule.radius_min);
  }
  if (last >= rule.radius_min) add(end, last);
}

// REQUIRES: the edge leaves a free end.
Ridge::Branch Ridge::branch_from(std::uint32_t edge, const CornerRule& rule) const {
  Branch branch;
  branch.reach = reach_[diagram_.edges[edge].from];
  for (;;) {
    branch.edges.push_back(edge);
    widen(branch, edge, rule);
    branch.reach += length(edge);
    branch.end = diagram_.to(edge);
    if (is_end(branch.end) || is_open(branch.end) || degree_[branch.end] > 2) return branch;
    edge = only_other(branch.end, diagram_.edges[edge].twin);
  }
}

void Ridge::remove(std::uint32_t edge) {
  left_[edge] = 0;
  --degree_[diagram_.edges[edge].from];
}

void Ridge::remove(const Branch& branch) {
  for (const std::uint32_t edge : branch.edges) {
    remove(edge);
    remove(diagram_.edges[edge].twin);
  }
  reach_[branch.end] = std::max(reach_[branch.end], branch.reach);
}

void Ridge::drop_spurs(const CornerRule& rule) {
  for (bool again = true; again;) {
    std::vector<Branch> spurs;
    for (std::uint32_t vertex = 0; vertex < degree_.size(); ++vertex) {
      if (!is_end(vertex)) continue;
      for_leaving(vertex, [&](std::uint32_t edge) {
        Branch branch = branch_from(edge, rule);
        if (is_end(branch.end)) return;
        const double radius = diagram_.vertices[branch.end].height;
        if (branch.corner && branch.reach <= rule.reach * radius)
          spurs.push_back(std::move(branch));
      });
    }
    // Those that meet in one fork side by side, the farthest reaching first.
    std::stable_sort(spurs.begin(), spurs.end(), [](const Branch& a, const Branch& b) {
      return a.end != b.end ? a.end < b.end : a.reach > b.reach;
    });
    std::vector<std::size_t> doomed;
    for (std::size_t i = 0, j = 0; i < spurs.size(); i = j) {
      while (j < spurs.size() && spurs[j].end == spurs[i].end) ++j;
      const bool all = j - i == degree_[spurs[i].end] && !is_open(spurs[i].end);
      for (std::size_t k = all ? i + 2 : i; k < j; ++k) doomed.push_back(k);
    }
    for (const std::size_t k : doomed) remove(spurs[k]);
    again = !doomed.empty();
  }
}

std::vector<std::uint32_t> Ridge::edges() const {
  std::vector<std::uint32_t> result;
  result.reserve(leaving_.size() / 2);
  for (const std::uint32_t edge : leaving_) {
    if (left_[edge] != 0 && edge < diagram_.edges[edge].twin) result.push_back(edge);
  }
  return result;
}

}  // namespace core
