// Gathers the bodies of a 3MF that have settings of their own, in the order in which they hold: of
// bodies that overlap, the later one.
#pragma once

#include <vector>

#include "core/result.h"                 // Result
#include "host/formats/mesh_store.h"     // MeshStore
#include "host/formats/modifier_body.h"  // ModifierBody
#include "host/formats/threemf_cut.h"    // ThreeMfItem
#include "host/formats/threemf_roles.h"  // ThreeMfModifier

namespace host {

// ENSURES: the store has no items. REQUIRES: all objects are known, and add_item() accepts all
// items. COSTS: a pass over the bodies. Errors do not name the file.
[[nodiscard]] core::Result<std::vector<ModifierBody>> gather_modifiers(
    const std::vector<ThreeMfModifier>& modifiers, const std::vector<ThreeMfItem>& items,
    MeshStore& store);

}  // namespace host
