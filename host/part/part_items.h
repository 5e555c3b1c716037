// The things that a file lays onto the bed, the build items of a 3MF, as objects that can be
// cancelled one by one, and printed one after another.
//
//      ┌──────┐  ┌────┐      Which object a road is of is told by boxes alone
//      │ a    │  │ b  │      (pipeline/object_map.h). So items whose boxes meet, seen from above,
//      └──────┘  │  ┌─┼──┐   are one object: here a, and b with c.
//                └──┼─┘ c│
//                   └────┘
//
// Their extents are found while the part is surveyed; nothing is read for them alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry.h"                 // Box, Triangle
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/part/bed_placing.h"         // Shift
#include "host/part/opened_part.h"         // PartObject

namespace host {

class PartItems {
 public:
  explicit PartItems(std::vector<std::string> names)
      : names_(std::move(names)), extents_(names_.size()) {}

  void add(std::size_t item, const core::Triangle& triangle);

  // As they lie on the bed, in the items' order; empty: they are one object. `file`: for those
  // without a name. REQUIRES: all triangles were added, some more than once perhaps.
  // COSTS: O(items³) where all meet; there are kObjectsMax at most.
  [[nodiscard]] std::vector<PartObject> objects(const Shift& shift, const std::string& file) const;

 private:
  struct Extent {
    core::Box box;
    std::int64_t highest_z = std::numeric_limits<std::int64_t>::min();
  };

  std::vector<std::string> names_;
  std::vector<Extent> extents_;
};

// The same triangles; `items` sees each. REQUIRES: its names are those of the triangles' items().
[[nodiscard]] std::unique_ptr<TriangleSource> watched(std::unique_ptr<TriangleSource> triangles,
                                                      std::shared_ptr<PartItems> items);

// Letters, digits and underscores of a file's or a thing's name, and a number.
[[nodiscard]] std::string object_name(const std::string& name, std::size_t number);

}  // namespace host
