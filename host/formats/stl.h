// STL, binary and text: a list of facets, one after the other, in bounded memory.
//
//     binary   80 bytes of header, a count (uint32), then for each facet 12 floats (normal and
//              three corners) and 2 bytes, all little-endian
//     text     solid NAME / facet normal N N N / outer loop / vertex X Y Z, three times / endloop /
//              endfacet / endsolid NAME; words in any case, parted by any blanks or line ends
//
// Which of the two is told by the content: many binary files begin with "solid" as well. Text
// begins with that word and, after the rest of its line, goes on with "facet" or "endsolid".
//
// Normals and colour bytes are not used: a facet's side is told by the order of its corners.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry.h"                 // Triangle
#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

// format() is "binary STL" or "ASCII STL". A file that ends within a facet, and a corner that is no
// number or out of range, are errors that name the facet and its byte or line. Fewer facets than
// the head counts, and text without its last "endsolid", leave a doubt(). Text behind "endsolid" is
// left out, and told.
class StlReader : public TriangleSource {
 public:
  // Reads as much as tells the kind.
  static core::Result<std::unique_ptr<StlReader>> open(InputFile file);

 protected:
  explicit StlReader(InputFile file) : file_(std::move(file)) {}

  using Corners = std::array<std::array<double, 3>, 3>;  // in mm

  // Nothing for corners that are no numbers or out of range.
  [[nodiscard]] static std::optional<core::Triangle> snapped(const Corners& corners);
  // Why there was nothing. `place` says where in the file.
  [[nodiscard]] core::Error not_snapped(const Corners& corners, const std::string& place) const;
  [[nodiscard]] core::Error bad_part(const std::string& place, const std::string& cause) const;

  InputFile file_;
};

}  // namespace host
