// SIF, the Solid Interchange Format (UC Berkeley), 2.0 and what of 1.0 is triangles.
//
//     2.0   (SIF_SFF 2 0 (units mm) (constellation …) (solid (union SHELL …)) …)
//           SHELL: (shell (vertices (v x y z) …) (triangles (t i j k) …)), also (surface …) within
//           union, intersection, difference of shells, evaluated slice by slice (boolean_layers.h)
//     1.0   (SIF_SFF 1 0 (units METRES) (body (lump (shell (v ID x y z) … (t ID ID ID) …)) …))
//           (f ID ID ID …) convex facets; (def surface ID …), (inst surface ID TRANSFORM …)
//
// Only parts of the 2.0 grammar are public. This is how the rest is read here:
//
//   - a shell set is a shell or a boolean of shell sets; sets side by side in a solid, and solids
//     side by side, are united, constellations keep their places;
//   - vertices are counted from 0 within their shell; from 1 where 0 never occurs and the last
//     number does;
//   - triangles are counter-clockwise seen from outside; a shell of negative volume is taken inside
//     out, and told; `lump` means `solid`;
//   - 1.0's transforms: tv tx ty tz, rx ry rz (degrees), sv sa sx sy sz, mx my mz mo; the first one
//     written acts first; inner shells are voids by their orientation;
//   - colours, accuracies and unknown properties are skipped, whole forms at a time, and the first
//     unknown one is told; 1.0's other shapes (face, path, strips …) are refused by name.
#pragma once

#include <memory>

#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/shell_tree.h"       // ShellTree
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

// Vertices with names that are in memory at once (1.0).
inline constexpr std::size_t kNamedVerticesMax = std::size_t{1} << 20;

// COSTS: reads the file once; see mesh_store.h for what is held.
[[nodiscard]] core::Result<std::unique_ptr<ShellTree>> read_sif(InputFile file);

// REQUIRES: tree->is_plain()
[[nodiscard]] std::unique_ptr<TriangleSource> plain_triangles(std::unique_ptr<ShellTree> tree);

}  // namespace host
