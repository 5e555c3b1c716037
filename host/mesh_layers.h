// Slices of a mesh: its triangles are sorted by lowest z, set on the bed, and swept upward.
//
//     TriangleSource ──> MeshSorter ──> PlaneSweep ──> slices
//
// A mesh has to be read to its end before its first slice, because facets come in any order;
// nothing of it is built in memory but triangles sorted by lowest z.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.h"           // Result
#include "core/settings.h"         // Settings
#include "host/opened_part.h"      // OpenedPart
#include "host/triangle_source.h"  // TriangleSource

namespace host {

struct MeshInput {
  std::string name;  // stands in errors
  std::unique_ptr<TriangleSource> triangles;
  // Opens the same triangles once more, from the begin; empty where they can be read only once, as
  // from a pipe.
  std::function<core::Result<std::unique_ptr<TriangleSource>>()> again;
};

// Errors are open_part()'s (part_file.h).
[[nodiscard]] core::Result<OpenedPart> open_mesh(MeshInput mesh, const core::Settings& settings);

}  // namespace host
