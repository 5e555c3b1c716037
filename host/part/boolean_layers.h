// Slices a solid that is a boolean expression of meshes: each mesh is cut on its own, and the
// booleans are evaluated on the slices.
//
//     operand 0 ──> MeshSorter ──> PlaneSweep ──> slice ─┐
//     operand 1 ──> MeshSorter ──> PlaneSweep ──> slice ─┴─> union, intersection, difference
//
// The part's extent, for placing it, is the result of the booleans on the meshes' boxes. Adaptive
// layer heights follow the facets of all meshes, those that are cut away, too.
#pragma once

#include <memory>

#include "core/result.h"              // Result
#include "core/settings.h"            // Settings
#include "host/formats/shell_tree.h"  // ShellTree
#include "host/part/opened_part.h"    // OpenedPart

namespace host {

// Errors are those of open_part(), here or in read_rest(). REQUIRES: !tree->is_plain()
// COSTS: memory for each operand's triangles that cross one plane; options.sort_bytes for all.
[[nodiscard]] core::Result<OpenedPart> open_booleans(std::unique_ptr<ShellTree> tree,
                                                     const core::Settings& settings,
                                                     const OpenOptions& options);

}  // namespace host
