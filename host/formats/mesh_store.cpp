#include "host/formats/mesh_store.h"

#include "core/check.h"                  // RIND_CHECK
#include "host/formats/format_limits.h"  // kNestingMax
#include "host/formats/text_scanner.h"   // shown

namespace host {

PointMm Transform::applied(const PointMm& point) const {
  PointMm moved{};
  for (std::size_t i = 0; i < 3; ++i) {
    moved[i] = point[0] * m[i] + point[1] * m[3 + i] + point[2] * m[6 + i] + m[9 + i];
  }
  return moved;
}

Transform Transform::then(const Transform& after) const {
  Transform both;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = row == 3 ? after.m[9 + i] : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += m[3 * row + k] * after.m[3 * k + i];
      both.m[3 * row + i] = sum;
    }
  }
  return both;
}

bool Transform::mirrors() const {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
             m[2] * (m[3] * m[7] - m[4] * m[6]) <
         0;
}

bool MeshStore::begin_object(const Key& key) {
  if (objects_.size() >= kMeshObjectsMax) return false;
  const auto [at, fresh] = objects_.try_emplace(key);
  if (!fresh) return false;
  object_ = &at->second;
  object_->first_vertex = points_.size();
  object_->first_triangle = triangles_.size();
  return true;
}

core::Status MeshStore::add_vertex(const PointMm& point) {
  RIND_CHECK(object_ != nullptr);
  ++object_->vertices;
  return points_.push_back(point);
}

std::size_t MeshStore::vertices() const { return object_ == nullptr ? 0 : object_->vertices; }

core::Status MeshStore::add_triangle(const std::array<std::uint32_t, 3>& corners) {
  for (const std::uint32_t corner : corners) RIND_CHECK(corner <= vertices());
  ++object_->triangles;
  return triangles_.push_back(corners);
}

void MeshStore::count_from_one() {
  RIND_CHECK(object_ != nullptr);
  object_->first_index = 1;
}

void MeshStore::add_component(const Key& key, const Transform& transform, bool reversed) {
  RIND_CHECK(object_ != nullptr);
  if (++components_ <= kMeshInstancesMax) object_->components.push_back({key, transform, reversed});
}

std::string MeshStore::add_item(const Key& key, const Transform& transform, bool reversed) {
  return place({key, transform, reversed}, 0);
}

std::string MeshStore::place(const Component& what, int depth) {
  const auto found = objects_.find(what.key);
  if (found == objects_.end()) {
    return "object '" + shown(what.key.second) + "' is not in the file; export the part again";
  }
  const Object& object = found->second;
  // Objects without triangles of their own count too, so that no tree of them takes for ever.
  if (instances_.size() >= kMeshInstancesMax || components_ > kMeshInstancesMax) {
    return "more than " + std::to_string(kMeshInstancesMax) +
           " copies of objects, more than fit; merge them";
  }
  if (depth > kNestingMax) {
    return "objects within one another more than " + std::to_string(kNestingMax) +
           " deep, or in a circle; export the part again";
  }
  instances_.push_back({&object, what.transform, what.transform.mirrors() != what.reversed});
  for (const Component& component : object.components) {
    std::string cause = place({component.key, component.transform.then(what.transform),
                               component.reversed != what.reversed},
                              depth + 1);
    if (!cause.empty()) return cause;
  }
  return {};
}

MeshStore::Next MeshStore::next() {
  while (next_instance_ < instances_.size() &&
         next_triangle_ == instances_[next_instance_].object->triangles) {
    ++next_instance_;
    next_triangle_ = 0;
  }
  if (next_instance_ == instances_.size()) return {};
  const Instance& instance = instances_[next_instance_];
  const Object& object = *instance.object;
  const auto corners = triangles_.at(object.first_triangle + next_triangle_++);
  core::Triangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const PointMm at = instance.transform.applied(
        points_.at(object.first_vertex + corners[i] - object.first_index));
    const std::optional<core::Vertex> vertex = snapped_vertex(at);
    if (!vertex) return {std::nullopt, vertex_too_far(at)};
    triangle.corners[instance.reversed ? 2 - i : i] = *vertex;
  }
  return {triangle, {}};
}

}  // namespace host
