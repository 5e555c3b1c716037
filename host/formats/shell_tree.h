// A solid as an unevaluated boolean expression of meshes, from a SIF file or a 3MF with negative
// parts.
//
//     operands    meshes, each a union of closed shells
//     nodes       union, intersection, difference of nodes; a leaf is an operand
//
// Each operand is cut on its own, and the booleans are evaluated on the slices (boolean_layers.h).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "host/formats/mesh_store.h"     // MeshStore
#include "host/formats/modifier_body.h"  // ModifierBody
#include "host/formats/support_marks.h"  // MarkCounts, MarkedFacets

namespace host {

// Largest number of operands: each has its own sorter and its own sweep.
inline constexpr std::size_t kOperandsMax = 64;

struct ShellNode {
  enum class Kind { kOperand, kUnion, kIntersection, kDifference };
  Kind kind = Kind::kUnion;
  std::size_t operand = 0;          // for kOperand
  std::vector<std::size_t> inputs;  // for the others: nodes before this one
};

struct Shell {
  MeshStore::Key key;
  bool reversed = false;  // its triangles face inwards
  Transform transform{};
  MeshRole role = MeshRole::kSolid;  // only its triangles of this role
};

struct ShellTree {
  std::string format;
  std::string name;  // the file, for messages
  MeshStore store;
  std::vector<std::vector<Shell>> operands;
  std::vector<ShellNode> nodes;  // the last one is the part
  std::vector<std::string> warnings;
  MarkCounts mark_counts{};
  std::unique_ptr<MarkedFacets> marked_facets{};  // nullptr if nothing is marked
  std::vector<ModifierBody> modifiers{};

  // True if it is one mesh, without booleans.
  [[nodiscard]] bool is_plain() const { return operands.size() == 1 && nodes.size() == 1; }
};

}  // namespace host
