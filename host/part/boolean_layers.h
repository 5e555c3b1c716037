// Slices of a solid that is given as booleans of meshes: each mesh is cut on its own, and the
// booleans are evaluated on the slices.
//
//     operand 0 ──> MeshSorter ──> PlaneSweep ──> slice ─┐
//     operand 1 ──> MeshSorter ──> PlaneSweep ──> slice ─┴─> union, intersection, difference
//
// The extent that the part is placed by is what the booleans leave of the meshes' boxes.
#pragma once

#include <memory>

#include "core/result.h"              // Result
#include "core/settings.h"            // Settings
#include "host/formats/shell_tree.h"  // ShellTree
#include "host/part/opened_part.h"    // OpenedPart

namespace host {

// REQUIRES: !tree->is_plain(). Errors are open_part()'s, then or in read_rest().
// COSTS: for each operand the triangles that cross one plane; for all of them options.sort_bytes.
[[nodiscard]] core::Result<OpenedPart> open_booleans(std::unique_ptr<ShellTree> tree,
                                                     const core::Settings& settings,
                                                     const OpenOptions& options);

}  // namespace host
