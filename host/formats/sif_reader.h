// Reads SIF, the Solid Interchange Format (UC Berkeley): 2.0, and the triangles of 1.0.
//
//     2.0   (SIF_SFF 2 0 (units mm) (constellation …) (solid (union SHELL …)) …)
//           SHELL: (shell (vertices (v x y z) …) (triangles (t i j k) …)), also (surface …) within;
//           union, intersection, difference of shells, evaluated slice by slice (boolean_layers.h)
//     1.0   (SIF_SFF 1 0 (units METRES) (body (lump (shell (v ID x y z) … (t ID ID ID) …)) …))
//           (f ID ID ID …) convex facets; (def surface ID …), (inst surface ID TRANSFORM …)
//
// Only parts of the 2.0 grammar are published. The rest is read as follows:
//
//   - A shell set is a shell or a boolean of shell sets. Sets side by side in a solid are united,
//     and so are solids side by side; constellations are not moved.
//   - Vertices are counted from 0 within their shell; from 1 if 0 never occurs and the last number
//     does.
//   - Triangles are counter-clockwise seen from outside. A shell of negative volume is turned
//     inside out, with a warning. `lump` means `solid`.
//   - Transforms of 1.0: tv tx ty tz, rx ry rz (degrees), sv sa sx sy sz, mx my mz mo. The first
//     one written is applied first. Inner shells are voids by their orientation.
//   - Colours, accuracies and unknown properties are skipped, with a warning for the first unknown
//     one. Other shapes of 1.0 (face, path, strips …) are refused by name.
#pragma once

#include <memory>

#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/shell_tree.h"       // ShellTree
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

// Named vertices in memory at once (1.0).
inline constexpr std::size_t kNamedVerticesMax = std::size_t{1} << 20;

// COSTS: reads the file once; see mesh_store.h for the memory.
[[nodiscard]] core::Result<std::unique_ptr<ShellTree>> read_sif(InputFile file);

// REQUIRES: tree->is_plain()
[[nodiscard]] std::unique_ptr<TriangleSource> plain_triangles(std::unique_ptr<ShellTree> tree);

}  // namespace host
