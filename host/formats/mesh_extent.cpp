#include "host/formats/mesh_extent.h"

#include <algorithm>
#include <utility>

namespace host {

namespace {

constexpr std::size_t kDirections = kReachDirections.size();
using Alongs = std::array<std::int64_t, kDirections>;

template <std::size_t i>
std::int64_t along(core::Point point) {
  return std::int64_t{kReachDirections[i].x} * point.x +
         std::int64_t{kReachDirections[i].y} * point.y;
}

// Without branches: hardly any point is.
template <std::size_t... i>
bool any_beyond(core::Point point, const Alongs& lowest, const Alongs& highest,
                std::index_sequence<i...>) {
  return ((int{along<i>(point) > highest[i]} | int{along<i>(point) < lowest[i]}) | ...) != 0;
}

}  // namespace

void Reach::add(core::Point point) {
  const bool first = points_.empty();
  if (!first && !any_beyond(point, lowest_, highest_, std::make_index_sequence<kDirections>())) {
    return;
  }
  if (first) points_.assign(2 * kReachDirections.size(), point);
  for (std::size_t i = 0; i < kReachDirections.size(); ++i) {
    const core::Point direction = kReachDirections[i];
    const std::int64_t along =
        std::int64_t{direction.x} * point.x + std::int64_t{direction.y} * point.y;
    if (first || along > highest_[i]) {
      highest_[i] = along;
      points_[2 * i] = point;
    }
    if (first || along < lowest_[i]) {
      lowest_[i] = along;
      points_[2 * i + 1] = point;
    }
  }
}

void Reach::add(const Reach& other) {
  for (const core::Point point : other.points_) add(point);
}

void MeshExtent::add(const core::Triangle& triangle) {
  for (const core::Vertex& corner : triangle.corners) {
    box.add(core::Point{corner.x, corner.y});
    reach.add(core::Point{corner.x, corner.y});
  }
  lowest_z = std::min(lowest_z, triangle.lowest_z());
  highest_z = std::max(highest_z, triangle.highest_z());
}

void MeshExtent::add(const MeshExtent& other) {
  box.add(other.box);
  lowest_z = std::min(lowest_z, other.lowest_z);
  highest_z = std::max(highest_z, other.highest_z);
}

bool MeshExtent::holds(const core::Triangle& triangle) const {
  return std::all_of(triangle.corners.begin(), triangle.corners.end(), [this](const auto& corner) {
    return corner.x >= box.min.x && corner.x <= box.max.x && corner.y >= box.min.y &&
           corner.y <= box.max.y && corner.z >= lowest_z && corner.z <= highest_z;
  });
}

}  // namespace host
