// Plug point: where a mesh's triangles come from. One file format each (formats/), in any order of
// triangles, read as they are asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"  // Triangle
#include "core/result.h"    // Result

namespace host {

class TriangleSource {
 public:
  virtual ~TriangleSource() = default;

  // For people: "binary STL".
  [[nodiscard]] virtual std::string format() const = 0;

  // The next triangle, snapped to the grid, x and y within ±kCoordinateMax, or nothing at the end.
  // An error names the file and the place in it, and is final.
  [[nodiscard]] virtual core::Result<std::optional<core::Triangle>> next() = 0;

  // Given so far.
  [[nodiscard]] std::int64_t facets() const { return facets_; }
  // What was odd and how it was taken; known for good once next() has given nothing. A few at most.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  // Why the file may have been cut off between two triangles, without its name; empty where it is
  // whole. Known with the warnings. Whoever knows the surface decides: a cut one is open.
  [[nodiscard]] const std::string& doubt() const { return doubt_; }

 protected:
  std::int64_t facets_ = 0;
  std::vector<std::string> warnings_;
  std::string doubt_;
};

}  // namespace host
