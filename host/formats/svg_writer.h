// Writes SVG with layers (svg_reader.h), the dialect with paths: an island with its holes is a
// path, one <g> a layer; the picture is the bed, in mm, y upside down. Walls and insides are told
// apart by class and colour.
#pragma once

#include <memory>

#include "host/formats/layer_writer.h"  // LayerWriter, LayerFileHead

namespace host {

[[nodiscard]] std::unique_ptr<LayerWriter> svg_writer(const LayerFileHead& head);

}  // namespace host
