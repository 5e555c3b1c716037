// Adds to a part's slices where its inside is filled otherwise (core::ChangedArea): the bodies of
// modifiers are cut by the same planes as the part.
//
//     part ─────────────────────────────────────> slice ──┬─> slice with areas
//     modifiers  ──> MeshSorter ──> PlaneSweep ──> region ─┘
//
// Bodies are placed on the bed as the part is, and don't count for where it is placed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/result.h"                 // Result
#include "core/settings.h"               // Settings
#include "host/formats/modifier_body.h"  // ModifierBody
#include "host/part/opened_part.h"       // OpenedPart

namespace host {

// Errors, of read_rest() if the part is not read yet: of the disk; a body that reaches too far.
// REQUIRES: part.placing is there.
// COSTS: sorts in `sort_bytes` at most; memory for the facets of bodies that cross a plane.
[[nodiscard]] core::Result<OpenedPart> with_modifiers(OpenedPart part,
                                                      std::vector<ModifierBody> bodies,
                                                      const core::Settings& settings,
                                                      std::size_t sort_bytes,
                                                      const std::string& name);

}  // namespace host
