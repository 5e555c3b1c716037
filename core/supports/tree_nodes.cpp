#include "core/supports/tree_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/regions/polyline.h"        // between, distance_units
#include "core/supports/tree_obstacle.h"  // TreeObstacle
#include "core/trigonometry.h"            // cosine, sine

namespace core {
namespace {

// Neighbours that a node may be drawn to: the nearest ones that it sees, so many at most.
constexpr std::size_t kNeighboursMax = 4;

// Two that would meet only below this share of their height go straight down.
constexpr double kMeetingShare = 0.8;

// A node is not drawn to one that is thinner than this share of it.
constexpr double kThinnerShare = 0.67;

// Branches grow no wider, in units.
constexpr double kRadiusMax = 60'000;

double tangent(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return sine(angle) / cosine(angle);
}

// From one point towards another.
Point towards(Point from, Point to, double units) {
  const double distance = distance_units(from, to);
  if (distance <= units) return to;
  // Rounded to the nearer side, so that no step is longer than asked for.
  const double share = std::max(units - 1, 0.0) / distance;
  return between(from, to, share);
}

// Of one rod that is as stiff as two.
double joined_radius(double a, double b) {
  const double a2 = a * a, b2 = b * b;
  return std::min(std::sqrt(std::sqrt(a2 * a2 + b2 * b2)), std::max({kRadiusMax, a, b}));
}

}  // namespace

void TreeNodes::sort() {
  std::sort(nodes_.begin(), nodes_.end(), [](const TreeNode& a, const TreeNode& b) {
    if (a.at != b.at) return a.at < b.at;
    if (a.radius != b.radius) return a.radius < b.radius;
    return a.to_bed < b.to_bed;
  });
}

void TreeNodes::start(const TreeNode& node) {
  if (nodes_.size() >= kTreeNodesMax) return;
  const auto place =
      std::upper_bound(nodes_.begin(), nodes_.end(), node,
                       [](const TreeNode& a, const TreeNode& b) { return a.at < b.at; });
  nodes_.insert(place, node);
}

bool TreeNodes::any_near(Point point, Length distance) const {
  const auto reach = static_cast<std::int32_t>(distance.units());
  auto node = std::lower_bound(nodes_.begin(), nodes_.end(), point.x - reach,
                               [](const TreeNode& a, std::int32_t x) { return a.at.x < x; });
  for (; node != nodes_.end() && node->at.x <= point.x + reach; ++node) {
    if (distance_units(node->at, point) <= static_cast<double>(reach)) return true;
  }
  return false;
}

// The nearest ones, nearest first.
std::vector<std::size_t> TreeNodes::neighbours(std::size_t number, double within) const {
  const Point at = nodes_[number].at;
  std::vector<std::pair<double, std::size_t>> found;
  const auto bound = [&] { return found.size() < kNeighboursMax ? within : found.back().first; };
  const auto take = [&](std::size_t other) {
    const double distance = distance_units(at, nodes_[other].at);
    if (distance > bound()) return;
    found.insert(std::upper_bound(found.begin(), found.end(), std::pair{distance, other}),
                 {distance, other});
    if (found.size() > kNeighboursMax) found.pop_back();
  };
  for (std::size_t i = number; i-- > 0;) {
    if (static_cast<double>(at.x) - nodes_[i].at.x > bound()) break;
    take(i);
  }
  for (std::size_t i = number + 1; i < nodes_.size(); ++i) {
    if (static_cast<double>(nodes_[i].at.x) - at.x > bound()) break;
    take(i);
  }
  std::vector<std::size_t> numbers;
  numbers.reserve(found.size());
  for (const auto& each : found) numbers.push_back(each.second);
  return numbers;
}

// Where a node would go: to a neighbour that it sees and can meet; else away from the part, until
// there is room for all of it.
std::optional<Point> TreeNodes::goal(std::size_t number, const TreeLayer& layer) const {
  const TreeNode& node = nodes_[number];
  const TreeObstacle& obstacle = layer.around(node);
  const double meeting = 2 * kMeetingShare * static_cast<double>(layer.bottom.units()) *
                         tangent(settings_.support_branch_angle_degrees);
  for (const std::size_t other : neighbours(number, meeting)) {
    const TreeNode& to = nodes_[other];
    if (to.radius < kThinnerShare * node.radius || obstacle.between(node.at, to.at)) continue;
    const bool both = to.radius * kThinnerShare <= node.radius;
    const double distance = distance_units(node.at, to.at);
    if (!both && distance > meeting / 2) continue;
    return both ? between(node.at, to.at, 0.5) : to.at;
  }
  const double core = static_cast<double>(settings_.support_tip_diameter.units()) / 2;
  const double room = node.radius - core;
  if (room <= 0) return {};
  const auto edge = obstacle.nearest_edge(node.at, Length::from_units(std::lround(room)));
  if (!edge || *edge == node.at) return {};
  return Point{2 * node.at.x - edge->x, 2 * node.at.y - edge->y};
}

Point TreeNodes::moved(const TreeNode& node, std::optional<Point> goal,
                       const TreeLayer& layer) const {
  const TreeObstacle& obstacle = layer.around(node);
  if (goal) {
    const Point at = towards(node.at, *goal, static_cast<double>(layer.step.units()));
    if (!obstacle.blocks(at)) return at;
  }
  return obstacle.nearest_free(node.at, layer.step).value_or(node.at);
}

double TreeNodes::grown(double radius, const TreeLayer& layer) const {
  const double whole = static_cast<double>(settings_.support_branch_diameter.units()) / 2;
  if (radius < whole) radius = std::min(whole, radius + static_cast<double>(layer.step.units()));
  const double growth = static_cast<double>(layer.height.units()) *
                        tangent(settings_.support_branch_diameter_angle_degrees);
  return std::max(radius, std::min(radius + growth, kRadiusMax));
}

void TreeNodes::descend(const TreeLayer& layer) {
  std::vector<TreeNode> next = nodes_;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    next[i].at = moved(nodes_[i], goal(i, layer), layer);
    next[i].radius = grown(nodes_[i].radius, layer);
    next[i].to_bed = nodes_[i].to_bed || !layer.avoided->blocks(next[i].at);
  }
  nodes_ = std::move(next);
  sort();
  merge();
}

// Each into one that holds it, the thicker one first.
void TreeNodes::merge() {
  std::vector<bool> gone(nodes_.size(), false);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (gone[i]) continue;
    TreeNode& node = nodes_[i];
    for (std::size_t j = i + 1; j < nodes_.size(); ++j) {
      if (static_cast<double>(nodes_[j].at.x) - node.at.x > kRadiusMax) break;
      if (gone[j]) continue;
      TreeNode& other = nodes_[j];
      const bool other_holds =
          other.to_bed != node.to_bed ? other.to_bed : other.radius > node.radius;
      TreeNode& holds = other_holds ? other : node;
      const TreeNode& held = other_holds ? node : other;
      const double radius = joined_radius(node.radius, other.radius);
      if (distance_units(node.at, other.at) + held.radius > radius) continue;
      holds.radius = radius;
      gone[static_cast<std::size_t>(&held - nodes_.data())] = true;
      if (other_holds) break;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!gone[i]) nodes_[kept++] = nodes_[i];
  }
  nodes_.resize(kept);
}

}  // namespace core
