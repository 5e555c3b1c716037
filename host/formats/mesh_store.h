// Meshes that a file describes first and places afterwards: objects of vertices, triangles and
// other objects, then the items that are to be printed.
//
//     object ── triangles over its own vertices
//       └────── components: other objects, each with a transform
//     item = object with a transform
//
// Vertices and triangles are in temporary files when there are many (mapped_array.h); what is in
// memory is bounded by kMeshObjectsMax and kMeshInstancesMax.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"             // Triangle
#include "core/result.h"               // Result, Status
#include "host/formats/vertex_snap.h"  // PointMm
#include "host/part/mapped_array.h"    // MappedArray

namespace host {

inline constexpr std::size_t kMeshObjectsMax = std::size_t{1} << 16;
inline constexpr std::size_t kMeshInstancesMax = std::size_t{1} << 16;

// A point times this matrix: x' = x m[0] + y m[3] + z m[6] + m[9], and so on: 3MF's order.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

  [[nodiscard]] PointMm applied(const PointMm& point) const;
  // This one first, then `after`.
  [[nodiscard]] Transform then(const Transform& after) const;
  // It turns inside out.
  [[nodiscard]] bool mirrors() const;
};

class MeshStore {
 public:
  // The part of the file, and the object's number in it.
  using Key = std::pair<int, std::string>;

  // Begins an object; what follows belongs to it. False for a key that is there already, or too
  // many.
  [[nodiscard]] bool begin_object(const Key& key);
  [[nodiscard]] bool contains(const Key& key) const { return objects_.contains(key); }
  [[nodiscard]] core::Status add_vertex(const PointMm& point);
  // Of the object that was begun last.
  [[nodiscard]] std::size_t vertices() const;
  // REQUIRES: each at most vertices(), and below it once the object is done, or count_from_one()
  [[nodiscard]] core::Status add_triangle(const std::array<std::uint32_t, 3>& corners);
  // The object's triangles count its vertices from 1. REQUIRES: none names 0
  void count_from_one();
  // `reversed`: inside out.
  void add_component(const Key& key, const Transform& transform, bool reversed = false);

  // What is to be printed; all objects are known. Returns why it can't be; empty when it can.
  // More may be added when next() has given nothing.
  [[nodiscard]] std::string add_item(const Key& key, const Transform& transform,
                                     bool reversed = false);

  // The items' triangles, snapped; nothing at the end. An empty error text, or why not.
  struct Next {
    std::optional<core::Triangle> triangle;
    std::string error;
  };
  [[nodiscard]] Next next();

 private:
  struct Component {
    Key key;
    Transform transform;
    bool reversed = false;
  };
  struct Object {
    std::uint32_t first_index = 0;
    std::size_t first_vertex = 0;
    std::size_t vertices = 0;
    std::size_t first_triangle = 0;
    std::size_t triangles = 0;
    std::vector<Component> components;
  };
  struct Instance {
    const Object* object;
    Transform transform;
    bool reversed;
  };

  [[nodiscard]] std::string place(const Component& what, int depth);

  MappedArray<PointMm> points_;
  MappedArray<std::array<std::uint32_t, 3>> triangles_;
  std::map<Key, Object> objects_;
  Object* object_ = nullptr;
  std::vector<Instance> instances_;
  std::size_t components_ = 0;
  std::size_t next_instance_ = 0;
  std::size_t next_triangle_ = 0;
};

}  // namespace host
