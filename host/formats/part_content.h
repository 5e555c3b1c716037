// The content of a part's file: triangles, layers, or booleans of meshes.
#pragma once

#include <memory>
#include <variant>

#include "host/formats/layer_reader.h"     // LayerReader
#include "host/formats/shell_tree.h"       // ShellTree
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

using PartContent = std::variant<std::unique_ptr<TriangleSource>, std::unique_ptr<LayerReader>,
                                 std::unique_ptr<ShellTree>>;

}  // namespace host
