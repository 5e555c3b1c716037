// Gathers what is marked for supports in the build items of a 3MF: bodies whose role says so
// (threemf_roles.h), and painted facets of plastic, in the pieces that are painted (facet_paint.h).
#pragma once

#include <memory>
#include <vector>

#include "core/result.h"                 // Result
#include "host/formats/mesh_store.h"     // MeshStore
#include "host/formats/support_marks.h"  // MarkedFacets
#include "host/formats/threemf_cut.h"    // ThreeMfItem

namespace host {

// ENSURES: the store has no items. REQUIRES: all objects are known, and add_item() accepts all
// items. COSTS: one pass over what is marked; over all that is printed, too,
// if there are bodies. Errors do not name the file.
[[nodiscard]] core::Result<std::unique_ptr<MarkedFacets>> gather_marks(
    const std::vector<ThreeMfItem>& items, MeshStore& store);

}  // namespace host
