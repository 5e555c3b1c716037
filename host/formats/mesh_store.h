// Stores meshes that a file first describes and then places: objects with vertices, triangles and
// components (other objects), then the items to be printed.
//
//     object ── triangles over its own vertices
//       └────── components: other objects, each with a transform
//     item = object with a transform
//
// Some of an object's triangles, or a component, may have another role than kSolid. Triangles may
// be painted.
//
// Many vertices and triangles are kept in temporary files (mapped_array.h). kMeshObjectsMax and
// kMeshInstancesMax bound what is in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry.h"             // Triangle
#include "core/result.h"               // Result, Status
#include "host/files/mapped_array.h"   // MappedArray
#include "host/formats/vertex_snap.h"  // PointMm

namespace host {

inline constexpr std::size_t kMeshObjectsMax = std::size_t{1} << 16;
inline constexpr std::size_t kMeshInstancesMax = std::size_t{1} << 16;

// A 4 × 3 matrix in 3MF's order: x' = x m[0] + y m[3] + z m[6] + m[9], and so on.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

  [[nodiscard]] PointMm applied(const PointMm& point) const;
  // This transform first, then `after`.
  [[nodiscard]] Transform then(const Transform& after) const;
  // True if it turns meshes inside out.
  [[nodiscard]] bool mirrors() const;
};

// The purpose of triangles.
enum class MeshRole : std::uint8_t {
  kSolid,     // printed
  kNegative,  // cut out of the item
  kEnforcer,  // holds what hangs in it
  kBlocker,   // holds nothing in it
  kLeftOut,   // ignored: modifiers without settings
  kModifier,  // the first modifier's body; the others' roles follow
};

// Of the modifier's body of that number, counted from 0. REQUIRES: number < kModifiersMax
[[nodiscard]] inline MeshRole modifier_role(std::size_t number) {
  return static_cast<MeshRole>(static_cast<std::size_t>(MeshRole::kModifier) + number);
}

class MeshStore {
 public:
  // The part of the file, and the object's number in it.
  using Key = std::pair<int, std::string>;

  // Starts an object; the calls that follow belong to it. False if the key exists already, or if
  // there are too many objects.
  [[nodiscard]] bool start_object(const Key& key);
  [[nodiscard]] bool contains(const Key& key) const { return objects_.contains(key); }
  [[nodiscard]] core::Status add_vertex(const PointMm& point);
  // Of the object that was started last.
  [[nodiscard]] std::size_t vertices() const;
  // REQUIRES: each corner is at most vertices(); once the object is complete, below vertices(),
  // unless count_from_one() was called
  [[nodiscard]] core::Status add_triangle(const std::array<std::uint32_t, 3>& corners);
  // How the triangle that was added last is painted (facet_paint.h).
  [[nodiscard]] core::Status paint(std::string_view text);
  // The object's triangles count its vertices from 1. REQUIRES: no corner is 0
  void count_from_one();
  // `reversed`: inside out. A role other than kSolid applies to everything in the component.
  void add_component(const Key& key, const Transform& transform, bool reversed = false,
                     MeshRole role = MeshRole::kSolid);
  // Sets the role of `count` of the object's own triangles, from `first` on. REQUIRES: the object
  // exists; ranges are set in ascending order and don't overlap
  void set_role(const Key& key, std::size_t first, std::size_t count, MeshRole role);
  // The object's own triangles.
  [[nodiscard]] std::size_t triangles(const Key& key) const;

  // Adds an item to be printed: its triangles with that role. Returns why it can't be printed;
  // empty if it can. REQUIRES: all objects are known; before the first next(), or after its end
  [[nodiscard]] std::string add_item(const Key& key, const Transform& transform,
                                     bool reversed = false, MeshRole role = MeshRole::kSolid);
  // Removes all items.
  void clear_items();
  // The number of triangles with that role that an item would have.
  // REQUIRES: add_item() accepted it
  [[nodiscard]] std::size_t count(const Key& key, MeshRole role) const;

  // Calls `take` with the painted ones of the items' triangles: snapped, corners in the object's
  // order. Errors: of `take`, of the snapping. REQUIRES: before the first next()
  struct Painted {
    core::Triangle triangle;
    std::string text;
    std::size_t number = 0;  // in the store
  };
  [[nodiscard]] core::Status each_painted(
      const std::function<core::Status(const Painted&)>& take) const;

  // "triangle 7 of object '1'", counted from 1. REQUIRES: it is in the store
  [[nodiscard]] std::string name_of(std::size_t triangle) const;

  // The items' triangles, snapped; nullopt at the end. `error` is empty, or says why it failed.
  struct Next {
    std::optional<core::Triangle> triangle;
    std::string error;
  };
  [[nodiscard]] Next next();
  // Copies of objects that the items are made of, so far; and which of them the last triangle is
  // of. Those of an item follow one another.
  [[nodiscard]] std::size_t instances() const { return instances_.size(); }
  [[nodiscard]] std::size_t instance() const { return next_instance_; }

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

  // A triangle's painting, in paint_text_.
  struct Paint {
    std::size_t triangle = 0;
    std::size_t first = 0;
    std::size_t size = 0;
  };

  // The corners where an instance of the object is, in the object's order. Empty, or why not.
  [[nodiscard]] std::string place_triangle(const Instance& instance, std::size_t number,
                                           core::Triangle& into) const;
  [[nodiscard]] std::string text_of(const Paint& paint) const;

  // Only triangles whose role is `wanted`.
  [[nodiscard]] std::string place(const Component& what, MeshRole wanted, int depth);
  // The ranges of an object's triangles whose role is `wanted`, if the object is within a component
  // of role `outer`.
  [[nodiscard]] static std::vector<Range> stretches(const Object& object, MeshRole outer,
                                                    MeshRole wanted);

  MappedArray<PointMm> points_;
  MappedArray<std::array<std::uint32_t, 3>> triangles_;
  MappedArray<Paint> paints_;  // in order of the triangles
  MappedArray<char> paint_text_;
  std::map<Key, Object> objects_;
  Object* object_ = nullptr;
  std::vector<Instance> instances_;
  std::size_t components_ = 0;
  std::size_t next_instance_ = 0;
};

}  // namespace host
