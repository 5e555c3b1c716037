// Build items of a 3MF of which some have negative parts, as booleans: each item's plastic without
// what its own negative parts enclose, all items together. Another item's plastic is not cut.
//
// Items that are not in one another's way are cut in one go, since few meshes can be cut side by
// side (kOperandsMax).
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

// Fills the tree's operands and nodes. REQUIRES: its store has the items, none of them placed; at
// least one has negative parts
// COSTS: looks at all triangles of items that are cut, where they are several.
[[nodiscard]] core::Status cut_items(const std::vector<ThreeMfItem>& items, ShellTree& tree);

}  // namespace host
