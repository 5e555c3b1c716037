// Meshes that a file describes first and places afterwards: objects of vertices, triangles and
// other objects, then the items that are to be printed.
//
//     object ── triangles over its own vertices
//       └────── components: other objects, each with a transform
//     item = object with a transform
//
// Some of an object's triangles, or a component, may have another role than to be printed.
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
#include "host/files/mapped_array.h"   // MappedArray
#include "host/formats/vertex_snap.h"  // PointMm

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

// What triangles are for.
enum class MeshRole : std::uint8_t {
  kSolid,     // they are printed
  kNegative,  // what they enclose is cut out of the item
  kLeftOut,   // they are there for another program: modifiers, where supports go
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
  // `reversed`: inside out. A role other than kSolid is that of all that is in it.
  void add_component(const Key& key, const Transform& transform, bool reversed = false,
                     MeshRole role = MeshRole::kSolid);
  // So many of an object's own triangles, from one of them on. REQUIRES: the object is there;
  // in order of triangles, each above the one before
  void set_role(const Key& key, std::size_t first, std::size_t count, MeshRole role);
  // The object's own triangles.
  [[nodiscard]] std::size_t triangles(const Key& key) const;

  // What is to be printed; all objects are known. Returns why it can't be; empty when it can.
  // More may be added when next() has given nothing. Only triangles that have the role.
  [[nodiscard]] std::string add_item(const Key& key, const Transform& transform,
                                     bool reversed = false, MeshRole role = MeshRole::kSolid);
  // Nothing is to be printed so far.
  void clear_items();
  // So many triangles of that role an item would have.
  // REQUIRES: add_item() of it has found no reason against it
  [[nodiscard]] std::size_t count(const Key& key, MeshRole role) const;

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
    MeshRole role = MeshRole::kSolid;
  };
  // Triangles of another role than kSolid, counted within their object.
  struct Range {
    std::size_t first = 0;
    std::size_t end = 0;
    MeshRole role = MeshRole::kSolid;
  };
  struct Object {
    std::uint32_t first_index = 0;
    std::size_t first_vertex = 0;
    std::size_t vertices = 0;
    std::size_t first_triangle = 0;
    std::size_t triangles = 0;
    std::vector<Component> components;
    std::vector<Range> ranges;
  };
  struct Instance {
    const Object* object;
    Transform transform;
    bool reversed;
    std::size_t next;  // triangles of the object
    std::size_t end;
  };

  // `wanted` is the role that counts.
  [[nodiscard]] std::string place(const Component& what, MeshRole wanted, int depth);
  // The stretches of an object's triangles that have a role, where it is in something of `outer`.
  [[nodiscard]] static std::vector<Range> stretches(const Object& object, MeshRole outer,
                                                    MeshRole wanted);

  MappedArray<PointMm> points_;
  MappedArray<std::array<std::uint32_t, 3>> triangles_;
  std::map<Key, Object> objects_;
  Object* object_ = nullptr;
  std::vector<Instance> instances_;
  std::size_t components_ = 0;
  std::size_t next_instance_ = 0;
};

}  // namespace host
