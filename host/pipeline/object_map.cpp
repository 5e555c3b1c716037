#include "host/pipeline/object_map.h"

#include <algorithm>
#include <cstdint>

namespace host {
namespace {

std::int64_t squared_distance(const core::Box& box, core::Point point) {
  const std::int64_t x = std::max(
      {std::int64_t{box.min.x} - point.x, std::int64_t{point.x} - box.max.x, std::int64_t{0}});
  const std::int64_t y = std::max(
      {std::int64_t{box.min.y} - point.y, std::int64_t{point.y} - box.max.y, std::int64_t{0}});
  return x * x + y * y;
}

}  // namespace

ObjectMap::ObjectMap(const std::vector<PartObject>& objects) {
  for (const PartObject& object : objects) boxes_.push_back(object.box);
}

int ObjectMap::at(core::Point point) const {
  const auto nearest = std::min_element(
      boxes_.begin(), boxes_.end(), [point](const core::Box& a, const core::Box& b) {
        return squared_distance(a, point) < squared_distance(b, point);
      });
  return nearest == boxes_.end() ? core::kNoObject : static_cast<int>(nearest - boxes_.begin());
}

void ObjectMap::mark(std::vector<core::Road>& roads) const {
  if (boxes_.empty()) return;
  for (core::Road& road : roads) {
    const bool nobodys = road.kind == core::RoadKind::kSkirt || road.kind == core::RoadKind::kRaft;
    road.object = nobodys ? core::kNoObject : at(road.points.front());
  }
}

}  // namespace host
