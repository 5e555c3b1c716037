// Slices of a mesh: its triangles are brought in order of lowest z, set on the bed, swept upward.
//
//     look ahead ─┬─ all of it ───────────────────────────> sorted in memory
//                 ├─ a file, so far in order ─ surveyed ──> read a second time, as the sweep asks
//                 ├─ a pipe, so far in order, trusted ────> read as the sweep asks
//                 └─ otherwise ─ read to the end ─────────> MeshSorter, in its budget
//
// Nothing is known of a mesh before all of it was seen, so a file in order is read twice: that is
// what its place on the bed, its layers and the checks before the print rest on. Of a pipe that is
// sliced as it comes only the look-ahead (kReorderTriangles) is known: it decides the place on the
// bed, and every later facet is checked when it arrives.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.h"                   // Result
#include "core/settings.h"                 // Settings
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/part/opened_part.h"         // OpenedPart, OpenOptions

namespace host {

using TriangleOpener = std::function<core::Result<std::unique_ptr<TriangleSource>>()>;

struct MeshInput {
  std::string name;  // stands in errors
  std::unique_ptr<TriangleSource> triangles;
  // Opens the same triangles once more, from the begin; empty where they can be read only once, as
  // from a pipe.
  TriangleOpener again;
};

// Reads the look-ahead. Errors are open_part()'s (part_file.h), then or in read_rest().
[[nodiscard]] core::Result<OpenedPart> open_mesh(MeshInput mesh, const core::Settings& settings,
                                                 const OpenOptions& options);

}  // namespace host
