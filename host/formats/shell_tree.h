// A solid as booleans of meshes, unevaluated: what a SIF file says, and a 3MF with negative parts.
//
//     operands    meshes, each a union of closed shells
//     nodes       union, intersection, difference of nodes; a leaf is an operand
//
// A plane cuts each operand on its own, and the booleans are evaluated on the slices
// (boolean_layers.h).
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "host/formats/mesh_store.h"  // MeshStore

namespace host {

// Meshes that are cut side by side: each has its own sorter and its own sweep.
inline constexpr std::size_t kOperandsMax = 64;

struct ShellNode {
  enum class Kind { kOperand, kUnion, kIntersection, kDifference };
  Kind kind = Kind::kUnion;
  std::size_t operand = 0;          // of a leaf
  std::vector<std::size_t> inputs;  // of the others: nodes before this one
};

struct Shell {
  MeshStore::Key key;
  bool reversed = false;  // its triangles look inwards
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

  // One mesh, nothing to evaluate.
  [[nodiscard]] bool is_plain() const { return operands.size() == 1 && nodes.size() == 1; }
};

}  // namespace host
