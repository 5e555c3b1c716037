// Slices a mesh: its triangles are sorted by lowest z, placed on the bed, and swept upwards.
//
//     look-ahead ─┬─ all of it ───────────────────────────> sorted in memory
//                 ├─ a file, so far in order ─ surveyed ──> read a second time, as the sweep asks
//                 ├─ a pipe, so far in order, trusted ────> read as the sweep asks
//                 └─ otherwise ─ read to the end ─────────> MeshSorter, in its budget
//
// The position on the bed, the number of layers, adaptive layer heights (part_heights.h) and the
// checks before a print need the whole mesh, so a file in order is read twice. Of a pipe that is
// sliced as it arrives, only the look-ahead (kReorderTriangles) is known: it decides the position
// on the bed, and every later facet is checked when it arrives. A pipe is never sliced so if layers
// are adaptive, or the part is cut.
//
// Of a cut mesh, one piece is swept (cut_plane.h). Where it lies is told by one more pass over the
// facets: the file is read a third time, or the sorted facets twice. A file that holds its mesh by
// corners (3MF, AMF) is parsed once in any case.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/result.h"                   // Result
#include "core/settings.h"                 // Settings
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/part/mesh_piece.h"          // TriangleOpener
#include "host/part/opened_part.h"         // OpenedPart, OpenOptions

namespace host {

struct MeshInput {
  std::string name;  // for messages
  std::unique_ptr<TriangleSource> triangles;
  // Opens the same triangles again, from the start; empty if they can be read only once (a pipe).
  TriangleOpener again;

  // The triangles come once more, from the first. Errors: of `again`. REQUIRES: again
  [[nodiscard]] core::Status start_again() {
    const core::Result<bool> rewound = triangles->rewind();
    if (!rewound.ok()) return rewound.error();
    if (rewound.value()) return {};
    core::Result<std::unique_ptr<TriangleSource>> opened = again();
    if (!opened.ok()) return opened.error();
    triangles = std::move(opened).value();
    return {};
  }
};

// Reads the look-ahead. Errors are those of open_part() (part_file.h), here or in read_rest().
[[nodiscard]] core::Result<OpenedPart> open_mesh(MeshInput mesh, const core::Settings& settings,
                                                 const OpenOptions& options);

}  // namespace host
