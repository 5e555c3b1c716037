// Reads STL, binary and text, facet by facet in bounded memory.
//
//     binary   80 bytes of header, a count (uint32), then for each facet 12 floats (normal and
//              three corners) and 2 bytes, all little-endian
//     text     solid NAME / facet normal N N N / outer loop / vertex X Y Z, three times / endloop /
//              endfacet / endsolid NAME; words in any case, separated by any blanks or line ends
//
// The content decides which of the two it is: many binary files start with "solid", too. Text
// starts with that word, and "facet" or "endsolid" follows after the rest of the line.
//
// Normals and colour bytes are ignored: the order of its corners gives a facet's side.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry.h"                 // Triangle
#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/formats/vertex_snap.h"      // snapped_vertex

namespace host {

// format() is "binary STL" or "ASCII STL". Errors, with the facet and its byte or line: the file
// ends within a facet; a corner is no number or out of range. A file with fewer facets than its
// head says, or text without its last "endsolid", leaves a doubt(). Text after "endsolid" is left
// out, with a warning.
class StlReader : public TriangleSource {
 public:
  // Reads only as far as needed to recognise the kind.
  static core::Result<std::unique_ptr<StlReader>> open(InputFile file);

  [[nodiscard]] bool read_in(double unit_mm) override {
    unit_mm_ = unit_mm;
    return true;
  }

 protected:
  explicit StlReader(InputFile file) : file_(std::move(file)) {}

  using Corners = std::array<std::array<double, 3>, 3>;  // as in the file

  // Nullopt if a corner is no number or out of range.
  [[nodiscard]] std::optional<core::Triangle> snapped(const Corners& corners) const {
    core::Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<core::Vertex> vertex = snapped_vertex(
          {corners[i][0] * unit_mm_, corners[i][1] * unit_mm_, corners[i][2] * unit_mm_});
      if (!vertex) return std::nullopt;
      triangle.corners[i] = *vertex;
    }
    return triangle;
  }
  // The error for that. `place`: the position in the file.
  [[nodiscard]] core::Error not_snapped(const Corners& corners, const std::string& place) const;
  [[nodiscard]] core::Error bad_part(const std::string& place, const std::string& cause) const;

  InputFile file_;

 private:
  double unit_mm_ = 1;
};

}  // namespace host
