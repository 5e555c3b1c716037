// Adds to a part's slices what people have marked for supports (core::SupportMarks): bodies are cut
// by the same planes as the part, painted facets give what lies of them between two planes.
//
//     part ────────────────────────────────────────────> slice ──┬─> slice with marks
//     bodies         ──> MeshSorter ──> PlaneSweep ─────> region ─┤
//     painted facets ──> MeshSorter ──> FacetSlabs ─────> region ─┘  a little wider
//
// Gaps in enforcing paint that are narrower than two roads are closed: of speckles, thousands would
// be crumbs.
//
// Marks are placed on the bed as the part is, and don't count for where it is placed. They hold for
// all bodies of the plate.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/result.h"                 // Result
#include "core/settings.h"               // Settings
#include "core/slices/layer_heights.h"   // LayerHeights
#include "host/formats/layer_source.h"   // LayerSource
#include "host/formats/support_marks.h"  // MarkedFacets
#include "host/part/bed_placing.h"       // Shift
#include "host/part/opened_part.h"       // OpenedPart

namespace host {

// How far what is painted reaches beyond its facets: slices are simplified, and a little of a strip
// would be left at their edges.
inline constexpr core::Length kPaintReach = core::Length::from_units(1'000);

// The part with its marks. `name`: of the file, for messages. Errors: a body that reaches too far;
// beside negative parts, whose place is known later, it is an error of read_rest(). Errors of the
// slices, besides the part's: of the disk. REQUIRES: part.placing is there.
// COSTS: sorts in `sort_bytes` at most; memory for the facets that cross a plane.
[[nodiscard]] core::Result<OpenedPart> with_marks(OpenedPart part,
                                                  std::unique_ptr<MarkedFacets> marks,
                                                  const core::Settings& settings,
                                                  std::size_t sort_bytes, const std::string& name);

}  // namespace host
