// Turns the build items of a 3MF with negative parts into booleans: each item's plastic minus its
// own negative parts, and the union of all items. A negative part cuts no other item.
//
// Items that don't touch one another share operands, since there can be only kOperandsMax.
#pragma once

#include <vector>

#include "core/result.h"              // Status
#include "host/formats/mesh_store.h"  // MeshStore
#include "host/formats/shell_tree.h"  // ShellTree

namespace host {

struct ThreeMfItem {
  MeshStore::Key key;
  Transform transform;
};

// Fills the tree's operands and nodes. REQUIRES: its store has the items, none of them added to its
// build; at least one has negative parts
// COSTS: reads all triangles of the items that are cut, if there are several.
[[nodiscard]] core::Status cut_items(const std::vector<ThreeMfItem>& items, ShellTree& tree);

}  // namespace host
