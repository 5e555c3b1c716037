#include "host/formats/mesh_store.h"

#include <algorithm>
#include <utility>

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

bool MeshStore::start_object(const Key& key) {
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

core::Status MeshStore::paint(std::string_view text) {
  RIND_CHECK(triangles_.size() > 0);
  const Paint paint{triangles_.size() - 1, paint_text_.size(), text.size()};
  for (const char c : text) {
    if (core::Status kept = paint_text_.push_back(c); !kept.ok()) return kept;
  }
  return paints_.push_back(paint);
}

void MeshStore::count_from_one() {
  RIND_CHECK(object_ != nullptr);
  object_->first_index = 1;
}

void MeshStore::add_component(const Key& key, const Transform& transform, bool reversed,
                              MeshRole role) {
  RIND_CHECK(object_ != nullptr);
  if (++components_ > kMeshInstancesMax) return;
  object_->components.push_back({key, transform, reversed, role});
}

void MeshStore::set_role(const Key& key, std::size_t first, std::size_t count, MeshRole role) {
  std::vector<Range>& ranges = objects_.at(key).ranges;
  RIND_CHECK(ranges.empty() || first >= ranges.back().end);
  if (role != MeshRole::kSolid && count > 0) ranges.push_back({first, first + count, role});
}

std::size_t MeshStore::triangles(const Key& key) const {
  const auto found = objects_.find(key);
  return found == objects_.end() ? 0 : found->second.triangles;
}

std::string MeshStore::add_item(const Key& key, const Transform& transform, bool reversed,
                                MeshRole role) {
  return place({key, transform, reversed, MeshRole::kSolid}, role, 0);
}

std::vector<MeshStore::Range> MeshStore::stretches(const Object& object, MeshRole outer,
                                                   MeshRole wanted) {
  if (outer != MeshRole::kSolid) {
    if (outer != wanted) return {};
    return {{0, object.triangles, outer}};
  }
  std::vector<Range> found;
  std::size_t solid_from = 0;
  for (const Range& range : object.ranges) {
    if (wanted == MeshRole::kSolid) found.push_back({solid_from, range.first, wanted});
    if (wanted == range.role) found.push_back(range);
    solid_from = range.end;
  }
  if (wanted == MeshRole::kSolid) found.push_back({solid_from, object.triangles, wanted});
  return found;
}

std::size_t MeshStore::count(const Key& key, MeshRole role) const {
  // No deeper than in place().
  const auto counted = [&](const auto& self, const Key& at, MeshRole outer) -> std::size_t {
    const Object& object = objects_.at(at);
    std::size_t sum = 0;
    for (const Range& range : stretches(object, outer, role)) sum += range.end - range.first;
    for (const Component& component : object.components) {
      sum += self(self, component.key, outer == MeshRole::kSolid ? component.role : outer);
    }
    return sum;
  };
  return counted(counted, key, MeshRole::kSolid);
}

std::string MeshStore::place(const Component& what, MeshRole wanted, int depth) {
  const auto found = objects_.find(what.key);
  if (found == objects_.end()) {
    return "object '" + shown(what.key.second) + "' is not in the file; export the part again";
  }
  const Object& object = found->second;
  // Objects without triangles count too, so that no tree of them takes for ever.
  if (instances_.size() >= kMeshInstancesMax || components_ > kMeshInstancesMax) {
    return "more than " + std::to_string(kMeshInstancesMax) +
           " copies of objects, more than fit; merge them";
  }
  if (depth > kNestingMax) {
    return "objects within one another more than " + std::to_string(kNestingMax) +
           " deep, or in a circle; export the part again";
  }
  const bool reversed = what.transform.mirrors() != what.reversed;
  std::vector<Range> ranges = stretches(object, what.role, wanted);
  if (ranges.empty() && wanted == MeshRole::kSolid) ranges.emplace_back();
  for (const Range& range : ranges) {
    instances_.push_back({&object, what.transform, reversed, range.first, range.end});
  }
  for (const Component& component : object.components) {
    const MeshRole role = what.role == MeshRole::kSolid ? component.role : what.role;
    std::string cause = place({component.key, component.transform.then(what.transform),
                               component.reversed != what.reversed, role},
                              wanted, depth + 1);
    if (!cause.empty()) return cause;
  }
  return {};
}

void MeshStore::clear_items() {
  instances_.clear();
  next_instance_ = 0;
}

MeshStore::Next MeshStore::next() {
  while (next_instance_ < instances_.size() &&
         instances_[next_instance_].next >= instances_[next_instance_].end) {
    ++next_instance_;
  }
  if (next_instance_ == instances_.size()) return {};
  Instance& instance = instances_[next_instance_];
  core::Triangle triangle;
  std::string cause =
      place_triangle(instance, instance.object->first_triangle + instance.next++, triangle);
  if (!cause.empty()) return {std::nullopt, std::move(cause)};
  if (instance.reversed) std::swap(triangle.corners[0], triangle.corners[2]);
  return {triangle, {}};
}

std::string MeshStore::place_triangle(const Instance& instance, std::size_t number,
                                      core::Triangle& into) const {
  const Object& object = *instance.object;
  const auto corners = triangles_.at(number);
  for (std::size_t i = 0; i < 3; ++i) {
    const PointMm at = instance.transform.applied(
        points_.at(object.first_vertex + corners[i] - object.first_index));
    const std::optional<core::Vertex> vertex = snapped_vertex(at);
    if (!vertex) return vertex_too_far(at);
    into.corners[i] = *vertex;
  }
  return {};
}

std::string MeshStore::text_of(const Paint& paint) const {
  std::string text;
  for (std::size_t i = 0; i < paint.size; ++i) text += paint_text_.at(paint.first + i);
  return text;
}

std::string MeshStore::name_of(std::size_t triangle) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(), [&](const auto& one) {
    const Object& object = one.second;
    return triangle >= object.first_triangle && triangle < object.first_triangle + object.triangles;
  });
  RIND_CHECK(found != objects_.end());
  return "triangle " + std::to_string(triangle - found->second.first_triangle + 1) +
         " of object '" + shown(found->first.second) + "'";
}

core::Status MeshStore::each_painted(
    const std::function<core::Status(const Painted&)>& take) const {
  const auto first_from = [this](std::size_t triangle) {
    std::size_t low = 0, high = paints_.size();
    while (low < high) {
      const std::size_t half = low + (high - low) / 2;
      if (paints_.at(half).triangle < triangle) {
        low = half + 1;
      } else {
        high = half;
      }
    }
    return low;
  };
  for (const Instance& instance : instances_) {
    const std::size_t end = instance.object->first_triangle + instance.end;
    for (std::size_t i = first_from(instance.object->first_triangle + instance.next);
         i < paints_.size() && paints_.at(i).triangle < end; ++i) {
      const Paint paint = paints_.at(i);
      Painted painted{{}, text_of(paint), paint.triangle};
      std::string cause = place_triangle(instance, paint.triangle, painted.triangle);
      if (!cause.empty()) return core::Error{core::ErrorCode::kBadPart, std::move(cause)};
      if (core::Status taken = take(painted); !taken.ok()) return taken;
    }
  }
  return {};
}

}  // namespace host
