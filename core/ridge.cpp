#include "core/ridge.h"

#include <algorithm>
#include <cmath>

namespace core {
namespace {

// A vertex lower than this, in units, lies on the contour.
constexpr double kOnContour = 0.25;

}  // namespace

Ridge::Ridge(const VoronoiDiagram& diagram, double open_height)
    : diagram_(diagram), open_height_(open_height) {
  leaving_.resize(diagram.vertices.size());
  reach_.reserve(diagram.vertices.size());
  for (const VoronoiVertex& vertex : diagram.vertices) reach_.push_back(std::abs(vertex.height));
  for (std::uint32_t i = 0; i < diagram.edges.size(); ++i) {
    const VoronoiEdge& edge = diagram.edges[i];
    const std::uint32_t to = diagram.to(i);
    if (!edge.primary || edge.from == VoronoiEdge::kInfinity || to == VoronoiEdge::kInfinity) {
      continue;
    }
    const double a = diagram.vertices[edge.from].height, b = diagram.vertices[to].height;
    if (std::max(a, b) > kOnContour) leaving_[edge.from].push_back(i);
  }
}

bool Ridge::on_contour(std::uint32_t vertex) const {
  return diagram_.vertices[vertex].height <= kOnContour;
}

bool Ridge::is_open(std::uint32_t vertex) const {
  return diagram_.vertices[vertex].height >= open_height_;
}

bool Ridge::is_end(std::uint32_t vertex) const {
  return (leaving_[vertex].size() == 1 && !is_open(vertex)) || on_contour(vertex);
}

double Ridge::length(std::uint32_t edge) const {
  const VoronoiVertex& a = diagram_.vertices[diagram_.edges[edge].from];
  const VoronoiVertex& b = diagram_.vertices[diagram_.to(edge)];
  return std::hypot(b.x - a.x, b.y - a.y);
}

std::uint32_t Ridge::only_other(std::uint32_t vertex, std::uint32_t edge) const {
  const std::vector<std::uint32_t>& halves = leaving_[vertex];
  return halves[0] == edge ? halves[1] : halves[0];
}

// REQUIRES: the edge leaves a free end.
Ridge::Branch Ridge::branch_from(std::uint32_t edge) const {
  Branch branch;
  branch.reach = reach_[diagram_.edges[edge].from];
  for (;;) {
    branch.edges.push_back(edge);
    branch.reach += length(edge);
    branch.end = diagram_.to(edge);
    if (is_end(branch.end) || is_open(branch.end) || leaving_[branch.end].size() > 2) return branch;
    edge = only_other(branch.end, diagram_.edges[edge].twin);
  }
}

void Ridge::remove(const Branch& branch) {
  for (const std::uint32_t edge : branch.edges) {
    const std::uint32_t twin = diagram_.edges[edge].twin;
    std::erase(leaving_[diagram_.edges[edge].from], edge);
    std::erase(leaving_[diagram_.edges[twin].from], twin);
  }
  reach_[branch.end] = std::max(reach_[branch.end], branch.reach);
}

void Ridge::drop_spurs() {
  for (bool again = true; again;) {
    std::vector<Branch> spurs;
    for (std::uint32_t vertex = 0; vertex < leaving_.size(); ++vertex) {
      if (!is_end(vertex)) continue;
      for (const std::uint32_t edge : leaving_[vertex]) {
        Branch branch = branch_from(edge);
        if (is_end(branch.end)) continue;
        const double radius = diagram_.vertices[branch.end].height;
        if (branch.reach <= 2 * radius) spurs.push_back(std::move(branch));
      }
    }
    // Those that meet in one fork side by side, the farthest reaching first.
    std::sort(spurs.begin(), spurs.end(), [](const Branch& a, const Branch& b) {
      return a.end != b.end ? a.end < b.end : a.reach > b.reach;
    });
    std::vector<std::size_t> doomed;
    for (std::size_t i = 0, j = 0; i < spurs.size(); i = j) {
      while (j < spurs.size() && spurs[j].end == spurs[i].end) ++j;
      const bool all = j - i == leaving_[spurs[i].end].size() && !is_open(spurs[i].end);
      for (std::size_t k = all ? i + 2 : i; k < j; ++k) doomed.push_back(k);
    }
    for (const std::size_t k : doomed) remove(spurs[k]);
    again = !doomed.empty();
  }
}

std::vector<std::uint32_t> Ridge::edges() const {
  std::vector<std::uint32_t> result;
  for (const std::vector<std::uint32_t>& halves : leaving_) {
    for (const std::uint32_t edge : halves) {
      if (edge < diagram_.edges[edge].twin) result.push_back(edge);
    }
  }
  return result;
}

}  // namespace core
