// Writes SVG with layers (svg_reader.h), the variant with paths: a path for an island with its
// holes, a <g> for a layer. The picture is the bed, in mm, with y pointing down. Walls and insides
// have different classes and colours.
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

[[nodiscard]] std::unique_ptr<LayerWriter> svg_writer(const LayerFileHead& head);

}  // namespace host
